#include "app/window/editing/building_editing.h"

#include <algorithm>
#include <cmath>

#include "app/window/editing/building_facts.h"
#include "app/window/editing/selection_panel.h"
#include "app/window/massing/figure_words.h"
#include "app/window/widgets/error_words.h"
#include "app/window/widgets/height_words.h"
#include "app/window/widgets/number_words.h"
#include "core/city/terrain/building_ground.h"
#include "scenarios/massing/lot_edits.h"

namespace noonmark {

namespace {

City only(const std::shared_ptr<const Building>& building) {
    City some;
    some.buildings.push_back(building);
    return some;
}

std::optional<std::uint32_t> indexOf(const City& city, const std::string& id) {
    const auto found = std::ranges::find(city.buildings, id, [](const auto& b) { return b->sourceId; });
    if (id.empty() || found == city.buildings.end()) return std::nullopt;
    return std::uint32_t(found - city.buildings.begin());
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
    const std::string wanted = next_.empty() ? id_ : next_;
    next_.clear();
    selected_.reset();
    select(indexOf(context_.city->city(), wanted));
}

void BuildingEditing::select(std::optional<std::uint32_t> building) {
    if (context_.preview.shown()) context_.preview.clear();
    setMoving(false);
    selected_ = building;
    id_ = building ? this->building().sourceId : std::string();
    show();
    Q_EMIT selectionChanged();
}

void BuildingEditing::standBack() {
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
    overlay.show(OverlayBodies::Tint::selected, selected_ ? only(city.buildings[*selected_]) : City{});
    panel_.show(selected_ ? std::optional(collectFacts(building(), city)) : std::nullopt);
    showHandle();
}

void BuildingEditing::showHandle() {
    if (!selected_) return context_.handle.hide();
    const City& city = context_.city->city();
    const double ground = double(findGroundUnder(building(), city));
    const glm::dvec2 middle = findMiddle(building());
    context_.handle.stand({{middle.x, middle.y, ground},
                           double(heightM(building(), city)),
                           usualStoreyM,
                           computeElevation(city, {middle, ground})});
}

void BuildingEditing::hover(std::optional<std::uint32_t> building) {
    if (building == hovered_) return;
    hovered_ = building;
    const bool tinted = building && building != selected_;
    context_.panel.view().overlay().show(OverlayBodies::Tint::hovered,
                                         tinted ? only(context_.city->city().buildings[*building]) : City{});
}

void BuildingEditing::preview(const Edit& edit) {
    if (!selected_) return;
    const auto shown = context_.preview.show({edit});
    panel_.showError(shown ? QString() : describeError(shown.error()));
    context_.panel.view().overlay().show(OverlayBodies::Tint::selected, {});
    const auto& added = context_.preview.changes().added;
    if (added.empty() || context_.handle.dragging()) return;
    const glm::dvec2 middle = findMiddle(*added.front());
    const City& city = context_.city->city();
    const double ground = double(findGroundUnder(*added.front(), city));
    context_.handle.stand({{middle.x, middle.y, ground},
                           double(topM(*added.front())) - ground,
                           usualStoreyM,
                           computeElevation(city, {middle, ground})});
}

// The project answers with a changed city; until then the preview stays.
void BuildingEditing::make(const Edit& edit) {
    if (!selected_) return;
    if (const auto sound = applied(context_.city->city(), std::vector{edit}); !sound)
        return panel_.showError(describeError(sound.error()));
    preview(edit);
    Q_EMIT editsMade({edit}, describe(edit));
}

void BuildingEditing::demolish() {
    if (selected_) make(Demolish{id_});
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
    context_.handle.stand(
        {{middle.x, middle.y, ground}, facts.heightM, usualStoreyM, facts.groundElevationM});
    context_.handle.tell(tr("%1, %2\n%3 floor area")
                             .arg(describeHeight(facts.heightM, facts.groundElevationM),
                                  describeStoreys(facts.storeys), describeSmallArea(facts.grossFloorM2)));
}

void BuildingEditing::takeHeight(double heightM) {
    if (!selected_) return;
    const double before = double(noonmark::heightM(building(), context_.city->city()));
    if (std::abs(heightM - before) > 0.05) return make(ChangeHeight{id_, heightM});
    context_.preview.clear();
    show();
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
