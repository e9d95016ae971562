#include "app/gui/tools/massing/tower_tables.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QTableWidget>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_fields.h"
#include "scenarios/massing/massing_fields.h"

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

FurtherTable::FurtherTable(QWidget* parent)
    : FieldTable(2,
                 pushButton(tr("Add tower"), "addTower",
                            tr("Another tower on the lot, apart from the others: each has a piece of it")),
                 pushButton(tr("Remove"), "removeTower", tr("Removes the selected tower, or the last one")),
                 parent) {
    table().setObjectName(QStringLiteral("furtherTowers"));
    table().setHorizontalHeaderLabels({tr("Storeys"), tr("Plate")});
    table().setToolTip(
        tr("Further towers, which the same step builds; the lot is divided across its longest side"));
}

std::vector<FurtherTower> FurtherTable::towers() const {
    std::vector<FurtherTower> towers;
    for (int row = 0; row < table().rowCount(); ++row)
        towers.push_back({static_cast<const QSpinBox*>(table().cellWidget(row, 0))->value(),
                          static_cast<const PlateField*>(table().cellWidget(row, 1))->plate()});
    return towers;
}

// An unchanged table is not rebuilt, so that the field the user is in stays.
void FurtherTable::show(const std::vector<FurtherTower>& towers) {
    if (towers == this->towers()) return;
    removeRows();
    for (const FurtherTower& tower : towers) add(tower);
}

void FurtherTable::add(const FurtherTower& tower) {
    const ValueRange range = *furtherTowerFields().rows().front().range;
    auto* storeys = wholeField(int(range.min), int(range.max), {});
    storeys->setValue(tower.storeys);
    auto* plate = new PlateField;
    plate->show(tower.plate);
    addRow({storeys, plate});
    connect(storeys, &QSpinBox::valueChanged, this, &FurtherTable::edited);
    connect(plate, &PlateField::edited, this, &FurtherTable::edited);
}

namespace {

constexpr int longestUse = 30;  // letters: the project file takes 60 bytes

}  // namespace

UseTable::UseTable(QWidget* parent)
    : FieldTable(2, pushButton(tr("Add use"), "addUse", tr("Adds a use for the storeys above the others")),
                 pushButton(tr("Remove"), "removeUse", tr("Removes the selected use, or the last one")),
                 parent) {
    table().setObjectName(QStringLiteral("uses"));
    table().setHorizontalHeaderLabels({tr("Use"), tr("Storeys")});
    table().setToolTip(
        tr("What the storeys are used for, from the ground floor up: retail 2, offices 10, homes the rest"));
    connect(this, &UseTable::addRequested, this, &UseTable::addNext);
}

QStringList UseTable::defaultUses() const {
    return {tr("Retail"),    tr("Offices"), tr("Homes"), tr("Hotel"),
            tr("Community"), tr("Parking"), tr("Plant")};
}

std::vector<FloorUse> UseTable::uses() const {
    std::vector<FloorUse> uses;
    for (int row = 0; row < table().rowCount(); ++row) {
        const auto* use = static_cast<const QComboBox*>(table().cellWidget(row, 0));
        const auto* storeys = static_cast<const QSpinBox*>(table().cellWidget(row, 1));
        uses.push_back({use->currentText().trimmed().toStdString(), storeys->value()});
    }
    return uses;
}

// An unchanged table is not rebuilt, so that the field the user is in stays.
void UseTable::show(const std::vector<FloorUse>& uses) {
    if (uses == this->uses()) return;
    removeRows();
    for (const FloorUse& use : uses) add(use);
}

void UseTable::add(const FloorUse& use) {
    auto* name = new QComboBox;
    name->setEditable(true);
    name->setInsertPolicy(QComboBox::NoInsert);
    name->addItems(defaultUses());
    name->setCurrentText(QString::fromStdString(use.use));
    name->lineEdit()->setMaxLength(longestUse);
    name->setToolTip(tr("A use of the list, or any other text"));
    auto* storeys = wholeField(0, 500, {});
    storeys->setSpecialValueText(tr("the rest"));
    storeys->setValue(use.storeys);
    storeys->setToolTip(tr("How many storeys; 0: all storeys above, for the last use"));
    addRow({name, storeys});
    connect(name, &QComboBox::activated, this, &UseTable::edited);
    connect(name->lineEdit(), &QLineEdit::editingFinished, this, &UseTable::edited);
    connect(storeys, &QSpinBox::valueChanged, this, &UseTable::edited);
}

// The last use took all storeys above; now it must have a number.
void UseTable::addNext() {
    std::vector<FloorUse> now = uses();
    if (!now.empty() && now.back().storeys == 0) now.back().storeys = 1;
    const QStringList standard = defaultUses();
    now.push_back({standard[int(now.size()) % standard.size()].toStdString(), 0});
    show(now);
    Q_EMIT edited();
}

namespace {

enum Column { aboveColumn, insetColumn, taperColumn, twistColumn };

void showHeader(QTableWidget& table) {
    const bool datum = heightReferenceInUse() == HeightReference::datum;
    table.setHorizontalHeaderLabels({datum ? QObject::tr("From, above datum") : QObject::tr("From height"),
                                     QObject::tr("Inset"), QObject::tr("Taper"), QObject::tr("Twist")});
}

double valueAt(const QTableWidget& table, int row, int column) {
    return static_cast<const QDoubleSpinBox*>(table.cellWidget(row, column))->value();
}

}  // namespace

SetbackTable::SetbackTable(QWidget* parent)
    : FieldTable(
          4, pushButton(tr("Add setback"), "addSetback", tr("Adds a setback above the others")),
          pushButton(tr("Remove"), "removeSetback", tr("Removes the selected setback, or the last one")),
          parent) {
    showHeader(table());
    table().setToolTip(
        tr("Above each height the walls are set back by the inset, from bottom to top; taper and twist are "
           "those of the volume above it"));
}

std::vector<Setback> SetbackTable::setbacks() const {
    std::vector<Setback> setbacks;
    for (int row = 0; row < table().rowCount(); ++row)
        setbacks.push_back({.aboveM = valueAt(table(), row, aboveColumn),
                            .insetM = valueAt(table(), row, insetColumn),
                            .walls = {.taper = valueAt(table(), row, taperColumn) / 100,
                                      .twistDeg = valueAt(table(), row, twistColumn)}});
    return setbacks;
}

QWidget* SetbackTable::fieldOf(MassingNumber number, std::size_t setback) const {
    switch (number) {
        case MassingNumber::setbackAbove:
            return table().cellWidget(int(setback), aboveColumn);
        case MassingNumber::setbackInset:
            return table().cellWidget(int(setback), insetColumn);
        case MassingNumber::setbackTaper:
            return table().cellWidget(int(setback), taperColumn);
        case MassingNumber::setbackTwist:
            return table().cellWidget(int(setback), twistColumn);
        default:
            return nullptr;
    }
}

// An unchanged table is not rebuilt, so that the field the user is in stays.
void SetbackTable::show(const std::vector<Setback>& setbacks) {
    if (setbacks == this->setbacks()) return;
    removeRows();
    for (const Setback& setback : setbacks) add(setback);
}

void SetbackTable::setZero(double zeroM) {
    zeroM_ = zeroM;
    showHeader(table());
    for (int row = 0; row < table().rowCount(); ++row)
        static_cast<LengthField*>(table().cellWidget(row, aboveColumn))->setZero(zeroM);
}

void SetbackTable::add(const Setback& setback) {
    auto* from = lengthField(0.1, 2000, 1, 3.5);
    from->setZero(zeroM_);
    from->setToolTip(tr("Height from which the walls are set back"));
    auto* depth = lengthField(0.1, 500, 1, 0.5);
    depth->setToolTip(tr("How far every wall is set back, from the top of the volume below"));
    const std::array<QDoubleSpinBox*, 4> fields{from, depth, taperField(), twistField()};
    const std::array<double, 4> values{setback.aboveM, setback.insetM, setback.walls.taper * 100,
                                       setback.walls.twistDeg};
    for (std::size_t column = 0; column < fields.size(); ++column) {
        fields[column]->setValue(values[column]);
        connect(fields[column], &QDoubleSpinBox::valueChanged, this, &SetbackTable::edited);
    }
    addRow({fields[0], fields[1], fields[2], fields[3]});
}

}  // namespace noonmark
