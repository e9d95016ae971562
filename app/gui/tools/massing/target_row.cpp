#include "app/gui/tools/massing/target_row.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QPushButton>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/push_button.h"

namespace noonmark {

namespace {

enum TargetKind { floorAreaKind, ratioKind };

constexpr double firstAreaM2 = 10000, firstRatio = 5, largestAreaM2 = 1e7, largestRatio = 1000;

bool isInFeet() { return unitsInUse() == UnitSystem::imperial; }
double squareMetresShown() { return isInFeet() ? squareMetresPerSquareFoot : 1; }

}  // namespace

TargetRow::TargetRow(QWidget* parent)
    : QWidget(parent), kind_(new QComboBox), number_(numberField(0, 1, 0, 1, {})) {
    kind_->setObjectName(QStringLiteral("targetKind"));
    kind_->addItems({tr("Floor area"), tr("FAR")});
    kind_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    kind_->setMinimumContentsLength(7);
    number_->setObjectName(QStringLiteral("targetNumber"));
    number_->setMinimumWidth(70);  // its largest number is far wider than the usual ones
    kind_->setToolTip(
        tr("Gross floor area, or floor area ratio: gross floor area divided by the lot's area"));
    number_->setToolTip(tr("What the tower shall have; press a button below to reach it"));
    auto* storeys = pushButton(tr("Fit storeys"), "fitStoreys", tr("The most storeys that stay within it"));
    auto* plate =
        pushButton(tr("Fit plate"), "fitPlate", tr("The floor plate with which these storeys reach it"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(kind_, 0, 0);
    grid->addWidget(number_, 0, 1);
    grid->addWidget(storeys, 1, 0);
    grid->addWidget(plate, 1, 1);
    choose(floorAreaKind);
    connect(kind_, &QComboBox::activated, this, &TargetRow::choose);
    connect(storeys, &QPushButton::clicked, this,
            [this] { Q_EMIT fitRequested(target(FloorAreaBy::storeys)); });
    connect(plate, &QPushButton::clicked, this, [this] { Q_EMIT fitRequested(target(FloorAreaBy::plate)); });
}

// Sets the number's range, unit and first value.
void TargetRow::choose(int kind) {
    const bool ratio = kind == ratioKind;
    number_->setDecimals(ratio ? 2 : 0);
    number_->setSuffix(ratio ? QString() : isInFeet() ? tr(" sq ft") : QStringLiteral(" m²"));
    number_->setRange(ratio ? 0.01 : 1, ratio ? largestRatio : largestAreaM2 / squareMetresShown());
    number_->setSingleStep(ratio ? 0.5 : 500);
    number_->setValue(ratio ? firstRatio : firstAreaM2 / squareMetresShown());
}

FloorAreaTarget TargetRow::target(FloorAreaBy by) const {
    FloorAreaTarget target{.by = by};
    if (kind_->currentIndex() == ratioKind)
        target.floorAreaRatio = number_->value();
    else
        target.grossFloorM2 = number_->value() * squareMetresShown();
    return target;
}

}  // namespace noonmark
