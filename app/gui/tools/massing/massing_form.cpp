#include "app/gui/tools/massing/massing_form.h"

#include <fmt/format.h>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSpinBox>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/tools/massing/tower_tables.h"
#include "core/city/building_heights.h"
#include "scenarios/massing/lot_edits.h"
#include "scenarios/massing/massing_fields.h"
#include "scenarios/massing/tower_design.h"

namespace noonmark {

namespace {

template <class IsTaken>
std::string firstFree(const char* word, IsTaken&& isTaken) {
    for (int number = 1;; ++number)
        if (std::string name = fmt::format("{} {}", word, number); !isTaken(name)) return name;
}

// The demolitions on the lot, without that of the replaced building, of which only a corner may be on the
// lot.
std::vector<Edit> clearLot(const City& city, const TowerDraft& draft) {
    std::vector<Edit> edits = clearing(city, draft.lot.outline);
    std::erase_if(edits,
                  [&](const Edit& edit) { return std::get<Demolish>(edit).building == draft.replaces; });
    return edits;
}

}  // namespace

Result<DraftedTower> draftTower(const City& city, const TowerDraft& draft) {
    auto massing = makeMassing(draft.lot.outline, draft.settings);
    if (!massing) return tl::make_unexpected(massing.error());
    auto building = buildingOf(*massing, draft.tower);
    if (!building) return tl::make_unexpected(building.error());
    auto shape = std::make_shared<const Building>(*std::move(building));
    const auto design =
        std::make_shared<const TowerDesign>(TowerDesign{draft.lot.name, draft.lot.outline, draft.settings});
    std::vector<Edit> edits = clearLot(city, draft);
    if (draft.replaces.empty())
        edits.emplace_back(AddBuilding{std::move(shape), design});
    else
        edits.emplace_back(Replace{draft.replaces, std::move(shape), design});
    return DraftedTower{*std::move(massing), std::move(edits)};
}

std::string freeTowerName(const City& city) {
    return firstFree("Tower", [&](const std::string& name) {
        return std::ranges::any_of(city.buildings,
                                   [&](const auto& building) { return building->sourceId == name; });
    });
}

std::string freeLotName(const std::vector<NamedLot>& lots) {
    return firstFree("Lot", [&](const std::string& name) {
        return std::ranges::any_of(lots, [&](const NamedLot& lot) { return lot.name == name; });
    });
}

namespace {

const Field& towerField(std::string_view flag) {
    return *std::ranges::find(massingFields().rows(), flag, &Field::flag);
}

QDoubleSpinBox* rotationField() {
    const ValueRange range = *towerField("--turn").range;
    return numberField(range.min, range.max, 1, 1, QStringLiteral("°"));
}

// Of a narrow panel: fields that are read together share a row.
QHBoxLayout* sideBySide(std::initializer_list<QWidget*> widgets) {
    auto* row = new QHBoxLayout;
    for (QWidget* widget : widgets) row->addWidget(widget, qobject_cast<QLabel*>(widget) ? 0 : 1);
    return row;
}

void explain(QWidget& widget, std::string_view flag) { widget.setToolTip(translated(towerField(flag).help)); }

}  // namespace

MassingForm::MassingForm(QWidget* parent)
    : QWidget(parent),
      storeys_(wholeField(1, maxStoreys, {})),
      storeyHeight_(lengthField(towerField("--storey-height").range->min,
                                towerField("--storey-height").range->max, 2, 0.1)),
      height_(lengthField(2, tallestBuildingM, 1, 3.5)),
      heightLabel_(new QLabel),
      plate_(new PlateField),
      turn_(rotationField()),
      walls_(new WallField),
      podium_(new QGroupBox(tr("Podium"))),
      podiumStoreys_(wholeField(1, maxStoreys - 1, {})),
      podiumPlate_(new PlateField),
      podiumWalls_(new WallField),
      setbacks_(new SetbackTable),
      uses_(new UseTable),
      further_(new FurtherTable),
      gap_(lengthField(towerField("--gap").range->min, towerField("--gap").range->max, 1, 1)) {
    settings_.storeys = 10;
    makeFields();
    connectFields();
    show(settings_);
}

void MassingForm::makeFields() {
    storeys_->setObjectName(QStringLiteral("storeys"));
    height_->setObjectName(QStringLiteral("totalHeight"));
    turn_->setObjectName(QStringLiteral("towerTurn"));
    walls_->setObjectName(QStringLiteral("towerWalls"));
    podiumWalls_->setObjectName(QStringLiteral("podiumWalls"));
    explain(*storeys_, "--storeys");
    explain(*storeyHeight_, "--storey-height");
    height_->setToolTip(tr("One storey to %1; or drag the arrow on the tower, or type a number over the view")
                            .arg(describeLength(2000, 0)));
    explain(*turn_, "--turn");
    podiumStoreys_->setToolTip(tr("Fewer than all storeys"));
    placePodium();
    auto* form = new QFormLayout;
    form->addRow(translated(towerField("--storeys").label),
                 sideBySide({storeys_, new QLabel(QStringLiteral("×")), storeyHeight_}));
    form->addRow(heightLabel_, height_);
    form->addRow(tr("Floor plate"), plate_);
    form->addRow(tr("Turn, taper, twist"), sideBySide({turn_, walls_}));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(form);
    column->addWidget(setbacks_);
    column->addWidget(podium_);
    column->addWidget(uses_);
    gap_->setObjectName(QStringLiteral("towerGap"));
    explain(*gap_, "--gap");
    auto* apart = new QFormLayout;
    apart->addRow(translated(towerField("--gap").label), gap_);
    column->addWidget(further_);
    column->addLayout(apart);
    setGround(0);
}

// Folded until there is one, so that what towers have more often is in sight on low screens.
void MassingForm::placePodium() {
    podium_->setCheckable(true);
    podium_->setChecked(false);
    auto* fields = new QWidget;
    auto* rows = new QFormLayout(fields);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addRow(tr("Storeys"), podiumStoreys_);
    rows->addRow(tr("Plate"), podiumPlate_);
    rows->addRow(tr("Taper, twist"), podiumWalls_);
    auto* column = new QVBoxLayout(podium_);
    column->addWidget(fields);
    const auto fold = [this, fields, column](bool has) {
        const int marginPx = has ? style()->pixelMetric(QStyle::PM_LayoutTopMargin) : 0;
        column->setContentsMargins(marginPx, marginPx, marginPx, marginPx);
        fields->setVisible(has);
    };
    connect(podium_, &QGroupBox::toggled, fields, fold);
    fold(false);
}

void MassingForm::setGround(double groundElevationM) {
    const bool datum = heightReferenceInUse() == HeightReference::datum;
    heightLabel_->setText(datum ? tr("Top above datum") : tr("Height above ground"));
    height_->setZero(heightZeroM(groundElevationM));
    setbacks_->setZero(heightZeroM(groundElevationM));
}

void MassingForm::connectFields() {
    // What show() writes into one field is not an entry that decides about the others.
    connect(storeys_, &QSpinBox::valueChanged, this, [this](int storeys) {
        if (showing_) return;
        settings_.storeys = storeys;
        settings_.heightM = 0;
        takeHeight();
    });
    connect(storeyHeight_, &QDoubleSpinBox::valueChanged, this, [this](double height) {
        if (showing_) return;
        settings_.storeyHeightM = height;
        takeHeight();
    });
    connect(height_, &QDoubleSpinBox::valueChanged, this, [this](double height) {
        if (showing_) return;
        settings_ = withHeight(settings_, height);
        takeHeight();
    });
    connect(turn_, &QDoubleSpinBox::valueChanged, this, &MassingForm::takeRest);
    connect(plate_, &PlateField::edited, this, &MassingForm::takeRest);
    for (WallField* field : {walls_, podiumWalls_})
        connect(field, &WallField::edited, this, &MassingForm::takeRest);
    connect(uses_, &UseTable::edited, this, &MassingForm::takeRest);
    connect(further_, &FurtherTable::edited, this, &MassingForm::takeRest);
    connect(further_, &FurtherTable::addRequested, this, &MassingForm::addTower);
    connect(gap_, &QDoubleSpinBox::valueChanged, this, &MassingForm::takeRest);
    connect(podium_, &QGroupBox::toggled, this, &MassingForm::takeRest);
    connect(podiumStoreys_, &QSpinBox::valueChanged, this, &MassingForm::takeRest);
    connect(podiumPlate_, &PlateField::edited, this, &MassingForm::takeRest);
    connect(setbacks_, &SetbackTable::edited, this, &MassingForm::takeRest);
    connect(setbacks_, &SetbackTable::addRequested, this, &MassingForm::addSetback);
}

// One of storeys, storey height and total height was changed: the others follow.
void MassingForm::takeHeight() {
    show(settings_);
    Q_EMIT edited();
}

void MassingForm::takeRest() {
    if (showing_) return;
    settings_.clockwiseDeg = turn_->value();
    settings_.plate = plate_->plate();
    settings_.podium.reset();
    if (podium_->isChecked())
        settings_.podium = Podium{podiumStoreys_->value(), podiumPlate_->plate(), podiumWalls_->walls()};
    settings_.walls = walls_->walls();
    settings_.setbacks = setbacks_->setbacks();
    settings_.uses = uses_->uses();
    settings_.further = further_->towers();
    settings_.gapM = gap_->value();
    gap_->setEnabled(!settings_.further.empty());
    Q_EMIT edited();
}

// As high as the first, on as large a plate as fits its piece of the lot.
void MassingForm::addTower() {
    settings_.further.push_back(
        {.storeys = std::max(1, int(heightOf(settings_) / settings_.storeyHeightM + 1e-6)),
         .plate = settings_.further.empty() ? settings_.plate : settings_.further.back().plate});
    show(settings_);
    Q_EMIT edited();
}

// Adds a setback at the storey half way between the last one and the top.
void MassingForm::addSetback() {
    const double top = heightOf(settings_);
    double from = settings_.podium ? settings_.podium->storeys * settings_.storeyHeightM : 0;
    if (!settings_.setbacks.empty()) from = settings_.setbacks.back().aboveM;
    const double storeyM = settings_.storeyHeightM;
    const double below = storeyM > 0 ? std::max(1.0, std::floor((top - from) / 2 / storeyM)) * storeyM : 0;
    const bool fits = below > 0 && from + below < top;
    settings_.setbacks.push_back({.aboveM = fits ? from + below : (from + top) / 2, .insetM = 3});
    show(settings_);
    Q_EMIT edited();
}

QWidget* MassingForm::fieldOf(const NearestFit& fit) const {
    switch (fit.number) {
        case MassingNumber::height:
            return settings_.storeys > 0 ? static_cast<QWidget*>(storeys_) : height_;
        case MassingNumber::storeyHeight:
            return storeyHeight_;
        case MassingNumber::turn:
            return turn_;
        case MassingNumber::plate:
            return plate_->sizeField();
        case MassingNumber::taper:
            return walls_->taperBox();
        case MassingNumber::twist:
            return walls_->twistBox();
        case MassingNumber::podiumStoreys:
            return podiumStoreys_;
        case MassingNumber::podiumPlate:
            return podiumPlate_->sizeField();
        case MassingNumber::podiumTaper:
            return podiumWalls_->taperBox();
        case MassingNumber::podiumTwist:
            return podiumWalls_->twistBox();
        case MassingNumber::setbackAbove:
        case MassingNumber::setbackInset:
        case MassingNumber::setbackTaper:
        case MassingNumber::setbackTwist:
            break;
    }
    return setbacks_->fieldOf(fit.number, fit.setback);
}

void MassingForm::markWrong(const NearestFit* fit) {
    if (wrong_) wrong_->setPalette({});
    wrong_ = fit == nullptr ? nullptr : fieldOf(*fit);
    if (!wrong_) return;
    const NoteColours colours = errorColours(themeInUse());
    QPalette palette = wrong_->palette();
    palette.setColor(QPalette::Base, colours.background);
    palette.setColor(QPalette::Text, colours.text);
    wrong_->setPalette(palette);
}

void MassingForm::show(const MassingSettings& settings) {
    settings_ = settings;
    showing_ = true;
    const double height = heightOf(settings);
    storeys_->setValue(settings.storeys > 0 ? settings.storeys : int(height / settings.storeyHeightM + 1e-6));
    storeyHeight_->setValue(settings.storeyHeightM);
    height_->setValue(height);
    plate_->show(settings.plate);
    turn_->setValue(settings.clockwiseDeg);
    walls_->show(settings.walls);
    podium_->setChecked(settings.podium.has_value());
    if (settings.podium) {
        podiumStoreys_->setValue(settings.podium->storeys);
        podiumPlate_->show(settings.podium->plate);
        podiumWalls_->show(settings.podium->walls);
    }
    setbacks_->show(settings.setbacks);
    uses_->show(settings.uses);
    further_->show(settings.further);
    gap_->setValue(settings.gapM);
    gap_->setEnabled(!settings.further.empty());
    showing_ = false;
}

}  // namespace noonmark
