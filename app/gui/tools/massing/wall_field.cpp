#include "app/gui/tools/massing/wall_field.h"

#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>

#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/translated.h"
#include "scenarios/massing/massing_fields.h"

namespace noonmark {

namespace {

QDoubleSpinBox* wallField(std::string_view flag, int decimals, const QString& unit) {
    const Field& field = *std::ranges::find(massingFields().rows(), flag, &Field::flag);
    const double times = field.shownTimes;
    auto* box = numberField(field.range->min * times, field.range->max * times, decimals, 5, unit);
    box->setToolTip(QStringLiteral("%1: %2").arg(translated(field.label), translated(field.help)));
    return box;
}

}  // namespace

QDoubleSpinBox* taperField() { return wallField("--taper", 0, QStringLiteral(" %")); }

QDoubleSpinBox* twistField() { return wallField("--twist", 1, QStringLiteral("°")); }

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
