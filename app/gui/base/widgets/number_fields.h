#pragma once

#include <QString>

class QDoubleSpinBox;
class QSpinBox;

namespace noonmark {

/// A number field with a unit; emits a change only after the whole number was typed.
QDoubleSpinBox* numberField(double low, double high, int decimals, double step, const QString& unit);
QSpinBox* wholeField(int low, int high, const QString& unit);

}  // namespace noonmark
