#include "app/gui/tools/massing/wall_field.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include "app/gui/base/widgets/number_fields.h"

namespace noonmark {

QDoubleSpinBox* taperField() {
    auto* field = numberField(0, 95, 0, 5, QStringLiteral(" %"));
    field->setToolTip(
        QObject::tr("Taper: how much narrower the volume is at its top than at its bottom, 0 to 95 %"));
    return field;
}

QDoubleSpinBox* twistField() {
    auto* field = numberField(-360, 360, 1, 5, QStringLiteral("°"));
    field->setToolTip(
        QObject::tr("Twist: clockwise turn from the bottom of the volume to its top, in proportion to the "
                    "height; it must stay on the lot"));
    return field;
}

WallField::WallField(QWidget* parent) : QWidget(parent), taper_(taperField()), twist_(twistField()) {
    taper_->setObjectName(QStringLiteral("taper"));
    twist_->setObjectName(QStringLiteral("twist"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    for (QDoubleSpinBox* field : {taper_, twist_}) {
        row->addWidget(field, 1);
        connect(field, &QDoubleSpinBox::valueChanged, this, &WallField::edited);
    }
}

WallShape WallField::walls() const { return {.taper = taper_->value() / 100, .twistDeg = twist_->value()}; }

void WallField::show(const WallShape& walls) {
    const QSignalBlocker block(this);
    taper_->setValue(walls.taper * 100);
    twist_->setValue(walls.twistDeg);
}

}  // namespace noonmark
