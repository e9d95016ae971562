#include "app/gui/tools/editing/selection_panel.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/study/region_text.h"
#include "app/gui/tools/massing/massing_text.h"
#include "core/city/terrain/building_ground.h"
#include "core/io/formats/format.h"
#include "scenarios/massing/copy_massing.h"
#include "scenarios/massing/lot_edits.h"

namespace noonmark {

namespace {

QString describeSource(HeightSource source) {
    switch (source) {
        case HeightSource::measured:
            return QObject::tr("measured");
        case HeightSource::levels:
            return QObject::tr("from its storeys");
        case HeightSource::assumed:
            return QObject::tr("assumed");
        case HeightSource::mesh:
            return QObject::tr("from its mesh");
        case HeightSource::designed:
            return QObject::tr("designed");
        case HeightSource::madeUp:
            return QObject::tr("synthetic");
    }
    return {};
}

Result<PreservedFloorArea> massOf(const Building& building, const City& city,
                                  double storeyHeightM = defaultStoreyM) {
    return massOf(building, double(findGroundUnder(building, city)), storeyHeightM);
}

}  // namespace

namespace {

// The height of a part from the ground it stands on; of one that stands on others that of the building.
double findHeightOfPart(const Part& part, const City& city, double buildingM) {
    constexpr float nearGroundM = 0.5F;
    if (part.footprint.outer.empty()) return buildingM;
    const float groundM = groundAt(city, glm::dvec2(part.footprint.outer.front()));
    return part.bottomM > groundM + nearGroundM ? buildingM : double(part.topM) - double(part.bottomM);
}

// The height of its highest part, and where that height comes from.
void addHeights(BuildingFacts& facts, const Building& building, const City& city, double levelM) {
    facts.heightM = double(heightM(building, city));
    facts.groundElevationM =
        computeElevation(city, {findMiddle(building), double(findGroundUnder(building, city))});
    facts.hasElevations = city.terrain != nullptr || city.frame.originElevationM() != 0;
    const auto highest = std::ranges::max_element(building.parts, {}, &Part::topM);
    if (highest == building.parts.end()) return;
    facts.highestPartM = findHeightOfPart(*highest, city, facts.heightM);
    facts.heightSource = describeSource(highest->heightSource);
    facts.storeysAreStated = highest->heightSource == HeightSource::levels;
    if (facts.storeysAreStated) facts.storeyHeightM = levelM;
}

}  // namespace

BuildingFacts collectFacts(const Building& building, const City& city, const ProposedTower* tower,
                           double levelM) {
    BuildingFacts facts;
    facts.id = QString::fromStdString(building.sourceId);
    facts.title = building.name.empty() ? facts.id : QString::fromStdString(building.name);
    facts.parts = building.parts.size();
    addHeights(facts, building, city, levelM);
    if (tower != nullptr && tower->storeyHeightM > 0) facts.storeyHeightM = tower->storeyHeightM;
    facts.storeys = int(std::lround(facts.heightM / facts.storeyHeightM));
    if (const auto mass = massOf(building, city, facts.storeyHeightM)) {
        facts.planM2 = area(mass->plate);
        facts.grossFloorM2 = mass->grossFloorM2;
        facts.estimatedStoreys = mass->estimatedStoreys;
    } else {
        facts.planM2 = area(computeOutline(building));
    }
    const auto figures = tower != nullptr ? figuresOf(*tower) : std::nullopt;
    if (!figures) return facts;
    facts.designed = facts.storeysAreStated = true;
    facts.storeys = figures->storeys;
    facts.grossFloorM2 = figures->grossFloorM2;
    return facts;
}

GroupFacts collectFacts(std::span<const std::uint32_t> buildings, const City& city) {
    GroupFacts facts{.buildings = buildings.size()};
    for (const std::uint32_t building : buildings) {
        const auto mass = massOf(*city.buildings[building], city);
        mass ? void(facts.grossFloorM2 += mass->grossFloorM2) : void(++facts.unmeasured);
    }
    return facts;
}

std::optional<Footprint> lotUnder(const Building& building, const City& city) {
    const auto mass = massOf(building, city);
    if (!mass) return std::nullopt;
    return *std::ranges::max_element(mass->plate, {}, [](const Footprint& piece) { return area(piece); });
}

namespace {

QString describeEstimate(int storeys) {
    if (storeys == 0) return {};
    return QObject::tr("; mesh is open: %1 estimated").arg(describeStoreys(storeys));
}

QString row(const QString& name, const QString& value) {
    return QStringLiteral("<tr><td>%1&nbsp;&nbsp;</td><td>%2</td></tr>").arg(name, value.toHtmlEscaped());
}

QString makeRows(const GroupFacts& facts) {
    QString floors = describeSmallArea(facts.grossFloorM2) +
                     QObject::tr(", storeys of %1").arg(describeLength(defaultStoreyM));
    if (facts.unmeasured > 0)
        floors += QObject::tr("; %1 without a storey on the ground").arg(facts.unmeasured);
    const QString selected = QObject::tr("%1 building(s) selected", "", pluralNumber(facts.buildings))
                                 .arg(formatCount(facts.buildings));
    return QStringLiteral("<b>%1</b><table>").arg(selected) + row(QObject::tr("Floor area"), floors) +
           QStringLiteral("</table>");
}

// Heights count from the lowest ground under the building; a part that stands higher than that is less high.
QString describeHighestPart(const BuildingFacts& facts) {
    constexpr double shownM = 0.1;
    if (facts.parts < 2 || facts.heightM - facts.highestPartM < shownM) return {};
    return QObject::tr("; highest part %1").arg(describeLength(facts.highestPartM));
}

// As the files count them, from the lowest ground under it to its highest point.
QString describeElevations(const BuildingFacts& facts) {
    if (!facts.hasElevations) return {};
    return row(QObject::tr("Elevation"), QObject::tr("%1 to %2 above datum")
                                             .arg(describeLength(facts.groundElevationM),
                                                  describeLength(facts.groundElevationM + facts.heightM)));
}

QString makeRows(const BuildingFacts& facts) {
    const QString storeys =
        facts.storeys == 0
            ? QString()
            : QStringLiteral(", ") + (facts.storeysAreStated ? describeStoreys(facts.storeys)
                                                             : describeAssumedStoreys(facts.storeys));
    const QString floors = facts.grossFloorM2
                               ? describeSmallArea(*facts.grossFloorM2) + storeys +
                                     QObject::tr(" of %1").arg(describeLength(facts.storeyHeightM)) +
                                     describeEstimate(facts.estimatedStoreys)
                               : QObject::tr("not counted: no storey stands on the ground");
    return QStringLiteral("<b>%1</b><table>").arg(facts.title.toHtmlEscaped()) +
           (facts.title == facts.id ? QString() : row(QObject::tr("Id"), facts.id)) +
           row(QObject::tr("Height"),
               QStringLiteral("%1 (%2)").arg(describeHeight(facts.heightM, facts.groundElevationM),
                                             facts.heightSource) +
                   describeHighestPart(facts)) +
           describeElevations(facts) + row(QObject::tr("Parts"), QString::number(facts.parts)) +
           row(QObject::tr("Plan"), describeArea(facts.planM2)) + row(QObject::tr("Floor area"), floors) +
           QStringLiteral("</table>");
}

}  // namespace

SelectionPanel::SelectionPanel(QWidget* parent)
    : QWidget(parent),
      facts_(new QLabel),
      tools_(new QWidget),
      demolishAll_(pushButton(tr("Demolish all"), "demolishAll",
                              tr("Removes the selected buildings, as one step of undo (Delete)"))),
      height_(lengthField(0.1, 2000, 1, 3.5)),
      heightLabel_(new QLabel),
      east_(lengthField(-10000, 10000, 1, 1)),
      north_(lengthField(-10000, 10000, 1, 1)),
      turn_(numberField(-360, 360, 1, 1, QStringLiteral("°"))),
      effect_(new QLabel),
      error_(new QLabel) {
    facts_->setWordWrap(true);
    facts_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    effect_->setWordWrap(true);
    effect_->setTextFormat(Qt::PlainText);
    effect_->setObjectName(QStringLiteral("editEffect"));
    effect_->hide();
    error_->setWordWrap(true);
    showAsError(*error_);
    auto* inside = new QVBoxLayout(tools_);
    inside->setContentsMargins(0, 0, 0, 0);
    inside->addWidget(makeButtons());
    inside->addWidget(makeFields());
    inside->addWidget(makeVariants());
    auto* import =
        pushButton(tr("Import mesh..."), "importMesh",
                   tr("Adds a building from a file (%1), placed by a click on the ground")
                       .arg(QString::fromStdString(listNames({FileKind::mesh, FileKind::cityJson}))));
    auto* column = new QVBoxLayout(this);
    column->addWidget(facts_);
    column->addWidget(tools_);
    column->addWidget(demolishAll_);
    column->addWidget(effect_);
    column->addWidget(error_);
    column->addWidget(import);
    column->addStretch(1);
    connect(demolishAll_, &QPushButton::clicked, this, &SelectionPanel::demolishRequested);
    connect(import, &QPushButton::clicked, this, &SelectionPanel::importRequested);
    connectFields();
    show(std::nullopt);
}

QWidget* SelectionPanel::makeButtons() {
    auto* demolish = pushButton(tr("Demolish"), "demolish", tr("Removes the building (Delete)"));
    replace_ = pushButton({}, "replace", {});
    setDesigned(false);
    auto* lot = pushButton(tr("Lot from footprint"), "lotFromFootprint",
                           tr("Creates a lot from its outline on the ground"));
    moveTool_ =
        pushButton(tr("Move"), "moveTool", tr("Drag the building over the ground; Esc ends the tool"));
    moveTool_->setCheckable(true);
    connect(demolish, &QPushButton::clicked, this, &SelectionPanel::demolishRequested);
    connect(replace_, &QPushButton::clicked, this, &SelectionPanel::replaceRequested);
    connect(lot, &QPushButton::clicked, this, &SelectionPanel::lotRequested);
    connect(moveTool_, &QPushButton::toggled, this, &SelectionPanel::moveToolRequested);
    auto* buttons = new QWidget;
    auto* grid = new QGridLayout(buttons);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(demolish, 0, 0);
    grid->addWidget(replace_, 0, 1);
    grid->addWidget(moveTool_, 1, 0);
    grid->addWidget(lot, 1, 1);
    return buttons;
}

void SelectionPanel::setDesigned(bool designed) {
    replace_->setText(designed ? tr("Edit tower") : tr("Replace by tower"));
    replace_->setToolTip(designed
                             ? tr("Designs the tower further, with the values it was built with")
                             : tr("Replaces it by a tower on its lot or, if it has none, on its footprint"));
}

QWidget* SelectionPanel::makeFields() {
    height_->setObjectName(QStringLiteral("buildingHeight"));
    turn_->setObjectName(QStringLiteral("buildingTurn"));
    east_->setObjectName(QStringLiteral("moveEast"));
    north_->setObjectName(QStringLiteral("moveNorth"));
    height_->setToolTip(
        tr("%1 to %2 above the ground; View > Heights above datum shows it as an elevation. Or drag the "
           "arrow on the building. Press Enter to apply")
            .arg(describeLength(0.1), describeLength(2000, 0)));
    turn_->setToolTip(tr("Clockwise about its middle. Press Enter to apply"));
    for (QDoubleSpinBox* field : {east_, north_})
        field->setToolTip(tr("Negative: west, south. Press Enter to apply"));
    auto* fields = new QWidget;
    auto* form = new QFormLayout(fields);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(heightLabel_, height_);
    form->addRow(tr("Move east"), east_);
    form->addRow(tr("Move north"), north_);
    form->addRow(tr("Rotate"), turn_);
    return fields;
}

QWidget* SelectionPanel::makeVariants() {
    auto* group = new QWidget;
    auto* column = new QVBoxLayout(group);
    column->setContentsMargins(0, 6, 0, 0);
    column->addWidget(new QLabel(tr("Same floor area on its lot:")));
    auto* row = new QHBoxLayout;
    column->addLayout(row);
    const auto variant = [&](const QString& text, double factor, const QString& tip) {
        auto* made = pushButton(text, "variant", tip);
        connect(made, &QPushButton::clicked, this, [this, factor] { Q_EMIT variantRequested(factor); });
        row->addWidget(made);
    };
    variant(tr("Wider"), 2, tr("Shorter, on a floor plate twice as large"));
    variant(tr("Widest"), largestPlate, tr("As short as the lot allows"));
    variant(tr("Slimmer"), 0.5, tr("Taller, on half the floor plate"));
    return group;
}

glm::dvec2 SelectionPanel::move() const { return {east_->value(), north_->value()}; }

void SelectionPanel::connectFields() {
    const auto changed = [this](auto* field, auto notify) {
        connect(field, &QDoubleSpinBox::valueChanged, this, [this, notify] {
            if (!showing_) notify();
        });
    };
    changed(height_, [this] { Q_EMIT heightChanged(height_->value()); });
    changed(turn_, [this] { Q_EMIT turnChanged(turn_->value()); });
    for (QDoubleSpinBox* field : {east_, north_}) {
        changed(field, [this] { Q_EMIT moveChanged(move()); });
        onEnter(*field, &SelectionPanel::takeMove);
    }
    onEnter(*height_, &SelectionPanel::takeHeight);
    onEnter(*turn_, &SelectionPanel::takeTurn);
}

// Not editingFinished, which is also emitted when the field loses focus.
void SelectionPanel::onEnter(const QDoubleSpinBox& field, void (SelectionPanel::*take)()) {
    connect(field.findChild<QLineEdit*>(), &QLineEdit::returnPressed, this, take);
}

// The fields are reset after an edit: a second Enter before the changed city arrives must not repeat it.
void SelectionPanel::takeMove() {
    const glm::dvec2 byM = move();
    showMove({0, 0});
    if (byM != glm::dvec2(0)) Q_EMIT moveTaken(byM);
}

void SelectionPanel::takeHeight() {
    const double before = std::exchange(heightM_, height_->value());
    if (std::abs(heightM_ - before) > 0.05) Q_EMIT heightTaken(heightM_);
}

void SelectionPanel::takeTurn() {
    const double degrees = turn_->value();
    const QSignalBlocker block(turn_);
    turn_->setValue(0);
    if (degrees != 0) Q_EMIT turnTaken(degrees);
}

void SelectionPanel::show(const std::optional<BuildingFacts>& facts) {
    showing_ = true;
    facts_->setText(facts ? makeRows(*facts)
                          : tr("Click a building in the view to select it. Ctrl+click selects another too, a "
                               "drag with Ctrl+Shift all in a rectangle."));
    tools_->setVisible(facts.has_value());
    demolishAll_->hide();
    heightM_ = facts ? facts->heightM : 0;
    const bool datum = heightReferenceInUse() == HeightReference::datum;
    heightLabel_->setText(datum ? tr("Top above datum") : tr("Height above ground"));
    height_->setZero(heightZeroM(facts ? facts->groundElevationM : 0));
    height_->setValue(heightM_);
    for (QDoubleSpinBox* field : {east_, north_, turn_}) field->setValue(0);
    showing_ = false;
    showError({});
}

void SelectionPanel::showGroup(const GroupFacts& facts) {
    show(std::nullopt);
    facts_->setText(makeRows(facts));
    demolishAll_->show();
}

void SelectionPanel::showHeight(double heightM) {
    const QSignalBlocker block(height_);
    height_->setValue(heightM);
}

void SelectionPanel::showMove(glm::dvec2 byM) {
    const QSignalBlocker blockEast(east_), blockNorth(north_);
    east_->setValue(byM.x);
    north_->setValue(byM.y);
}

void SelectionPanel::setMoving(bool moving) {
    const QSignalBlocker block(moveTool_);
    moveTool_->setChecked(moving);
}

void SelectionPanel::showEffect(const QString& words) {
    effect_->setText(words);
    effect_->setVisible(!words.isEmpty());
}

void SelectionPanel::showError(const QString& text) {
    error_->setText(text);
    error_->setVisible(!text.isEmpty());
}

QString SelectionPanel::message() const { return error_->text(); }

}  // namespace noonmark
