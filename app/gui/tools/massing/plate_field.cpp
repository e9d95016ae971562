#include "app/gui/tools/massing/plate_field.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <cmath>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/number_fields.h"

namespace noonmark {

namespace {

enum Kind { wholeLot, share, givenArea };

constexpr double largestM2 = 1e6;

// An area is typed in square feet where lengths are in feet.
bool showsFeet() { return unitsInUse() == UnitSystem::imperial; }
double squareMetresPerUnit() { return showsFeet() ? squareMetresPerSquareFoot : 1; }

}  // namespace

PlateField::PlateField(QWidget* parent)
    : QWidget(parent), kind_(new QComboBox), size_(numberField(1, 100, 0, 5, QStringLiteral(" %"))) {
    kind_->addItems({tr("Whole lot"), tr("Share of the lot"), tr("Area")});
    kind_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    kind_->setMinimumContentsLength(9);
    kind_->setToolTip(tr("A smaller plate keeps the lot's shape, inset from all sides"));
    size_->setObjectName(QStringLiteral("plateSize"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(kind_, 1);
    row->addWidget(size_, 1);
    show({});
    connect(kind_, &QComboBox::activated, this, [this](int kind) {
        choose(kind);
        Q_EMIT edited();
    });
    connect(size_, &QDoubleSpinBox::valueChanged, this, &PlateField::edited);
}

// Sets the field's range, unit and initial value.
void PlateField::choose(int kind) {
    const QSignalBlocker block(size_);
    size_->setEnabled(kind != wholeLot);
    if (kind == givenArea) return chooseArea();
    size_->setSuffix(QStringLiteral(" %"));
    size_->setRange(1, 100);
    size_->setSingleStep(5);
    size_->setValue(kind == share ? 60 : 100);
}

void PlateField::chooseArea() {
    size_->setSuffix(showsFeet() ? tr(" sq ft") : QStringLiteral(" m²"));
    size_->setRange(1, std::floor(largestM2 / squareMetresPerUnit()));
    size_->setSingleStep(showsFeet() ? 500 : 50);
    size_->setValue(showsFeet() ? 5000 : 500);
}

PlateSize PlateField::plate() const {
    PlateSize plate;
    if (kind_->currentIndex() == share) plate.shareOfLot = size_->value() / 100;
    if (kind_->currentIndex() == givenArea) plate.areaM2 = typedM2();
    return plate;
}

// Whole square feet are shown: an area that was not typed anew is kept as it is.
double PlateField::typedM2() const {
    const double unit = squareMetresPerUnit();
    const bool same = areaM2_ && std::round(*areaM2_ / unit) == size_->value();
    return same ? *areaM2_ : size_->value() * unit;
}

void PlateField::show(const PlateSize& plate) {
    const int kind = plate.areaM2 ? givenArea : plate.shareOfLot ? share : wholeLot;
    kind_->setCurrentIndex(kind);
    choose(kind);
    const QSignalBlocker block(size_);
    areaM2_ = plate.areaM2;
    if (plate.areaM2) size_->setValue(*plate.areaM2 / squareMetresPerUnit());
    if (plate.shareOfLot) size_->setValue(*plate.shareOfLot * 100);
}

}  // namespace noonmark
