#include "app/window/massing/plate_field.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include "app/window/widgets/number_fields.h"

namespace noonmark {

namespace {

enum Kind { wholeLot, share, squareMetres };

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
    const bool area = kind == squareMetres;
    size_->setSuffix(area ? QStringLiteral(" m²") : QStringLiteral(" %"));
    size_->setRange(1, area ? 1e6 : 100);
    size_->setSingleStep(area ? 50 : 5);
    size_->setValue(area ? 500 : kind == share ? 60 : 100);
}

PlateSize PlateField::plate() const {
    PlateSize plate;
    if (kind_->currentIndex() == share) plate.shareOfLot = size_->value() / 100;
    if (kind_->currentIndex() == squareMetres) plate.areaM2 = size_->value();
    return plate;
}

void PlateField::show(const PlateSize& plate) {
    const int kind = plate.areaM2 ? squareMetres : plate.shareOfLot ? share : wholeLot;
    kind_->setCurrentIndex(kind);
    choose(kind);
    const QSignalBlocker block(size_);
    if (plate.areaM2) size_->setValue(*plate.areaM2);
    if (plate.shareOfLot) size_->setValue(*plate.shareOfLot * 100);
}

}  // namespace noonmark
