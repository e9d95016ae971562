#include "app/gui/tools/editing/building_editing.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/tools/editing/selection_panel.h"
#include "app/gui/tools/massing/massing_form.h"
#include "app/gui/tools/massing/massing_text.h"
#include "app/gui/view/panel/view_panel.h"
#include "core/city/terrain/building_ground.h"
#include "scenarios/massing/lot_edits.h"

namespace noonmark {

namespace {

constexpr double stepM = 0.1;

double roundToStep(double metres) { return std::round(metres / stepM) * stepM; }

}  // namespace

MoveTool::MoveTool(ViewPanel& panel, QObject* parent) : QObject(parent), panel_(panel) {
    next_.setSingleShot(true);
    next_.setInterval(0);
    connect(&next_, &QTimer::timeout, this, &MoveTool::follow);
    panel.navigator().addTarget(*this);
}

MoveTool::~MoveTool() { panel_.navigator().removeTarget(*this); }

void MoveTool::begin(std::uint32_t building) {
    building_ = building;
    panel_.view().setCursor(Qt::SizeAllCursor);
    Q_EMIT began();
}

void MoveTool::end() {
    if (!building_) return;
    building_.reset();
    from_.reset();
    next_.stop();
    panel_.view().unsetCursor();
    panel_.cursorLabel().hide();
}

bool MoveTool::grab(QPointF pixel) {
    const auto pick = building_ ? panel_.navigator().pickAt(pixel) : std::nullopt;
    if (!pick || pick->building != building_) return false;
    from_ = pick->position;
    byM_ = {0, 0};
    return true;
}

void MoveTool::dragTo(QPointF pixel) {
    pixel_ = pixel;
    if (!next_.isActive()) next_.start();
}

// Moves in the horizontal plane through the grabbed point, which so stays under the cursor.
void MoveTool::follow() {
    if (!from_) return;
    const CityView& view = panel_.view();
    const auto there =
        findPlaneHit(makeRayThrough(view.pose(), view.lens(), {pixel_.x(), pixel_.y()}), from_->z);
    if (!there) return;
    byM_ = {roundToStep(there->x - from_->x), roundToStep(there->y - from_->y)};
    panel_.cursorLabel().show(pixel_, describeMove(byM_));
    Q_EMIT dragged(byM_);
}

// A drag that Esc or another city ended has no effect.
void MoveTool::drop() {
    if (!from_) return;
    if (next_.isActive()) follow();
    next_.stop();
    from_.reset();
    panel_.cursorLabel().hide();
    Q_EMIT dropped(byM_);
}

namespace {

City only(const City& city, const std::vector<std::uint32_t>& buildings) {
    City some;
    for (const std::uint32_t building : buildings) some.buildings.push_back(city.buildings[building]);
    return some;
}

// Indices of those ids that the city still has.
std::vector<std::uint32_t> findIds(const City& city, const std::vector<std::string>& ids) {
    const std::unordered_set<std::string_view> wanted(ids.begin(), ids.end());
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < city.buildings.size(); ++i)
        if (wanted.contains(city.buildings[i]->sourceId)) found.push_back(i);
    return found;
}

QString describe(const Edit& edit) { return QString::fromStdString(noonmark::formatText(edit)); }

}  // namespace

BuildingEditing::BuildingEditing(EditContext& context, SelectionPanel& panel, QObject* parent)
    : QObject(parent), context_(context), panel_(panel), move_(context.panel) {
    connectPanel();
    connect(&move_, &MoveTool::dragged, this, [this](glm::dvec2 byM) {
        panel_.showMove(byM);
        preview(Move{id_, byM});
    });
    connect(&move_, &MoveTool::dropped, this, [this](glm::dvec2 byM) {
        panel_.showMove({0, 0});
        if (byM != glm::dvec2(0)) make(Move{id_, byM});
    });
}

void BuildingEditing::connectPanel() {
    connect(&panel_, &SelectionPanel::demolishRequested, this, &BuildingEditing::demolish);
    connect(&panel_, &SelectionPanel::moveToolRequested, this, &BuildingEditing::setMoving);
    connect(&panel_, &SelectionPanel::variantRequested, this, &BuildingEditing::makeVariant);
    connect(&panel_, &SelectionPanel::heightChanged, this, &BuildingEditing::previewHeight);
    connect(&panel_, &SelectionPanel::heightTaken, this, &BuildingEditing::takeHeight);
    connect(&panel_, &SelectionPanel::moveChanged, this, [this](glm::dvec2 byM) { preview(Move{id_, byM}); });
    connect(&panel_, &SelectionPanel::moveTaken, this, [this](glm::dvec2 byM) { make(Move{id_, byM}); });
    connect(&panel_, &SelectionPanel::turnChanged, this, [this](double degrees) {
        preview(Rotate{id_, degrees});
    });
    connect(&panel_, &SelectionPanel::turnTaken, this, [this](double degrees) {
        make(Rotate{id_, degrees});
    });
}

const Building& BuildingEditing::building() const { return *context_.city->city().buildings[*selected_]; }

void BuildingEditing::cityChanged() {
    move_.end();
    panel_.setMoving(false);
    hover(std::nullopt);
    const std::vector<std::string> wanted = next_.empty() ? ids_ : std::vector{next_};
    next_.clear();
    selected_.reset();
    all_.clear();
    selectAll(findIds(context_.city->city(), wanted));
}

void BuildingEditing::select(std::optional<std::uint32_t> building) {
    selectAll(building ? std::vector{*building} : std::vector<std::uint32_t>());
}

void BuildingEditing::selectAll(std::vector<std::uint32_t> buildings) {
    if (context_.preview.shown()) context_.preview.clear();
    setMoving(false);
    all_ = std::move(buildings);
    ids_.clear();
    for (const std::uint32_t one : all_) ids_.push_back(context_.city->city().buildings[one]->sourceId);
    selected_ = all_.size() == 1 ? std::optional(all_.front()) : std::nullopt;
    id_ = selected_ ? ids_.front() : std::string();
    show();
    Q_EMIT selectionChanged();
}

void BuildingEditing::toggle(std::uint32_t building) {
    std::vector<std::uint32_t> next = all_;
    if (std::erase(next, building) == 0) next.push_back(building);
    selectAll(std::move(next));
}

void BuildingEditing::deactivate() {
    setMoving(false);
    OverlayBodies& overlay = context_.panel.view().overlay();
    overlay.show(OverlayBodies::Tint::hovered, {});
    overlay.show(OverlayBodies::Tint::selected, {});
    context_.handle.hide();
}

void BuildingEditing::show() {
    if (!context_.city || context_.preview.shown()) return;
    OverlayBodies& overlay = context_.panel.view().overlay();
    overlay.show(OverlayBodies::Tint::hovered, {});
    const City& city = context_.city->city();
    overlay.show(OverlayBodies::Tint::selected, only(city, all_));
    showFacts();
    showHandle();
}

void BuildingEditing::showFacts() {
    const City& city = context_.city->city();
    if (all_.size() > 1) return panel_.showGroup(collectFacts(std::span(all_), city));
    const ReadSettings reading = context_.city->loaded.settings.value_or(ReadSettings{});
    panel_.show(selected_ ? std::optional(collectFacts(building(), city, context_.findTower(building()),
                                                       reading.metresPerLevel))
                          : std::nullopt);
}

void BuildingEditing::showHandle() {
    if (!selected_) return context_.handle.hide();
    const City& city = context_.city->city();
    const double ground = double(findGroundUnder(building(), city));
    const glm::dvec2 middle = findMiddle(building());
    context_.handle.place({{middle.x, middle.y, ground},
                           double(heightM(building(), city)),
                           defaultStoreyM,
                           computeElevation(city, {middle, ground})});
}

void BuildingEditing::hover(std::optional<std::uint32_t> building) {
    if (building == hovered_) return;
    hovered_ = building;
    const bool tinted = building && std::ranges::find(all_, *building) == all_.end();
    context_.panel.view().overlay().show(OverlayBodies::Tint::hovered,
                                         tinted ? only(context_.city->city(), {*building}) : City{});
}

void BuildingEditing::preview(const Edit& edit) {
    if (selected_) previewAll({edit});
}

void BuildingEditing::previewAll(const std::vector<Edit>& edits) {
    const auto shown = context_.preview.show(edits);
    panel_.showError(shown ? QString() : describeError(shown.error()));
    context_.panel.view().overlay().show(OverlayBodies::Tint::selected, {});
    const auto& added = context_.preview.changes().added;
    if (added.empty() || context_.handle.dragging()) return;
    const glm::dvec2 middle = findMiddle(*added.front());
    const City& city = context_.city->city();
    const double ground = double(findGroundUnder(*added.front(), city));
    context_.handle.place({{middle.x, middle.y, ground},
                           double(topM(*added.front())) - ground,
                           defaultStoreyM,
                           computeElevation(city, {middle, ground})});
}

void BuildingEditing::make(const Edit& edit) {
    if (selected_) makeAll({edit}, describe(edit));
}

// The project answers with a changed city; until then the preview stays.
void BuildingEditing::makeAll(const std::vector<Edit>& edits, const QString& what) {
    if (const auto sound = applyEdits(context_.city->city(), edits); !sound)
        return panel_.showError(describeError(sound.error()));
    previewAll(edits);
    Q_EMIT editsMade(edits, what);
}

void BuildingEditing::demolish() {
    if (selected_) return make(Demolish{id_});
    std::vector<Edit> edits;
    for (const std::string& id : ids_) edits.emplace_back(Demolish{id});
    if (edits.empty()) return;
    makeAll(edits,
            tr("demolish %1 building(s)", "", pluralNumber(edits.size())).arg(formatCount(edits.size())));
}

void BuildingEditing::setMoving(bool on) {
    if (on && selected_)
        move_.begin(*selected_);
    else
        move_.end();
    panel_.setMoving(move_.active());
}

void BuildingEditing::endTool() {
    if (!move_.active()) return select(std::nullopt);
    setMoving(false);
    context_.preview.clear();
    show();
}

void BuildingEditing::previewHeight(double heightM) {
    if (!selected_) return;
    panel_.showHeight(heightM);
    preview(ChangeHeight{id_, heightM});
    const auto& added = context_.preview.changes().added;
    if (added.empty() || !context_.handle.dragging()) return;
    const City& city = context_.city->city();
    const BuildingFacts facts = collectFacts(*added.front(), city);
    const double ground = double(findGroundUnder(building(), city));
    const glm::dvec2 middle = findMiddle(building());
    context_.handle.place(
        {{middle.x, middle.y, ground}, facts.heightM, defaultStoreyM, facts.groundElevationM});
    const QString height = describeHeight(facts.heightM, facts.groundElevationM);
    context_.handle.showFigures(facts.grossFloorM2 ? tr("%1, %2\n%3 floor area")
                                                         .arg(height, describeAssumedStoreys(facts.storeys),
                                                              describeSmallArea(*facts.grossFloorM2))
                                                   : height);
}

void BuildingEditing::takeHeight(double heightM) {
    if (!selected_) return;
    const double before = double(noonmark::heightM(building(), context_.city->city()));
    const ProposedTower* tower = context_.findTower(building());
    if (std::abs(heightM - before) > 0.05)
        return tower && tower->design && !tower->changed ? rebuild(*tower->design, heightM)
                                                         : make(ChangeHeight{id_, heightM});
    context_.preview.clear();
    show();
}

// A designed tower keeps its design: storeys, plates and setbacks with another height.
void BuildingEditing::rebuild(const TowerDesign& design, double heightM) {
    const auto tower =
        draftTower(context_.city->city(),
                   {{design.lotName, design.lot}, noonmark::withHeight(design.settings, heightM), id_, id_});
    if (tower) return makeAll(tower->edits, describe(ChangeHeight{id_, heightM}));
    context_.preview.clear();
    show();
    panel_.showError(describeError(tower.error()));
}

void BuildingEditing::makeVariant(double plateFactor) {
    const auto lot = this->lot();
    if (!selected_ || !lot) return;
    const auto variant = noonmark::makeVariant(context_.city->city(), *selected_, lot->outline, plateFactor);
    if (variant) return make(variant->edit);
    panel_.showError(describeError(variant.error()));
}

std::optional<NamedLot> BuildingEditing::lot() const {
    if (!selected_) return std::nullopt;
    const glm::dvec2 middle = findMiddle(building());
    for (const NamedLot& lot : context_.lots)
        if (contains(lot.outline, middle)) return lot;
    const auto footprint = lotUnder(building(), context_.city->city());
    if (!footprint) return std::nullopt;
    const std::string& name = building().name.empty() ? id_ : building().name;
    return NamedLot{"Lot of " + name, *footprint};
}

int BuildingEditing::storeys() const {
    return selected_ ? collectFacts(building(), context_.city->city()).storeys : 0;
}

}  // namespace noonmark
