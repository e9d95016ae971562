#pragma once

class QComboBox;

namespace noonmark {

/// Fields for properties that a mesh file (OBJ, PLY, glTF) does not state. The data of an item is its UpAxis
/// or LengthUnit.
QComboBox* upAxisField();
QComboBox* meshUnitField();

void addUnits(QComboBox& field);  ///< metres, feet, US survey feet
void choose(QComboBox& field, int data);

}  // namespace noonmark
