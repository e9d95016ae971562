#pragma once

#include <QString>

class QDoubleSpinBox;
class QSpinBox;

namespace noonmark {

/// A field for a number with its unit; tells of a change only when the whole number was typed.
QDoubleSpinBox* numberField(double low, double high, int decimals, double step, const QString& unit);
QSpinBox* wholeField(int low, int high, const QString& unit);

}  // namespace noonmark
