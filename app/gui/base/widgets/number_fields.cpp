#include "app/gui/base/widgets/number_fields.h"

#include <QDoubleSpinBox>
#include <QSpinBox>

namespace noonmark {

QDoubleSpinBox* numberField(double low, double high, int decimals, double step, const QString& unit) {
    auto* field = new QDoubleSpinBox;
    field->setDecimals(decimals);
    field->setRange(low, high);
    field->setSingleStep(step);
    field->setSuffix(unit);
    field->setKeyboardTracking(false);
    return field;
}

QSpinBox* wholeField(int low, int high, const QString& unit) {
    auto* field = new QSpinBox;
    field->setRange(low, high);
    field->setSuffix(unit);
    field->setKeyboardTracking(false);
    return field;
}

}  // namespace noonmark
