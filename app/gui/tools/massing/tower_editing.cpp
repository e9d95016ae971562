#include "app/gui/tools/massing/tower_editing.h"

#include <algorithm>
#include <utility>

#include "app/gui/base/widgets/number_text.h"
#include "app/gui/tools/massing/massing_panel.h"
#include "app/gui/tools/massing/massing_text.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/city/terrain/building_ground.h"
#include "scenarios/massing/floor_plate.h"

namespace noonmark {

namespace {

// The handle's position, on the roof of the highest volume whatever its shape.
glm::dvec2 findMiddle(const Tier& tier) {
    const auto size = [](const Footprint& piece) { return area(piece); };
    const Footprint& largest = *std::ranges::max_element(tier.plate, {}, size);
    const glm::dvec2 middle = findMiddle(std::vector{largest});
    return contains(largest, middle) ? middle : findPointInside(largest);
}

}  // namespace

TowerEditing::TowerEditing(EditContext& context, MassingPanel& panel, QObject* parent)
    : QObject(parent), context_(context), panel_(panel) {
    connect(&panel_, &MassingPanel::edited, this, &TowerEditing::take);
    connect(&panel_, &MassingPanel::fitRequested, this, &TowerEditing::fit);
    connect(&panel_, &MassingPanel::nearestTaken, this, &TowerEditing::takeNearest);
    connect(&panel_, &MassingPanel::applyRequested, this, &TowerEditing::build);
    connect(&panel_, &MassingPanel::regionRequested, this, [this] {
        const auto& added = context_.preview.changes().added;
        if (context_.city && !added.empty())
            Q_EMIT regionRequested(makeRegionAround(added, context_.preview.region(),
                                                    context_.city->city().frame.origin().latDeg));
    });
    connect(&panel_, &MassingPanel::cancelled, this, &TowerEditing::cancel);
}

void TowerEditing::setTowers(std::map<std::string, ProposedTower> towers) {
    context_.towers = std::move(towers);
    std::vector<NamedLot> lots;
    for (const auto& [id, tower] : context_.towers)
        if (tower.design && !tower.changed) lots.push_back({tower.design->lotName, tower.design->lot});
    panel_.setDesignedLots(std::move(lots));
}

CopiedMassing TowerEditing::lastValuesOn(const Footprint& lot) const {
    const CopiedMassing first{.settings = {.storeys = 10}};
    if (!built_) return first;
    return copyMassing(built_->lot.outline, built_->settings, lot).value_or(first);
}

void TowerEditing::begin(const NamedLot& lot, const std::string& replaces, const MassingSettings& settings) {
    if (!context_.city) return;
    resume({.lot = lot,
            .settings = settings,
            .tower = freeTowerName(context_.city->city()),
            .replaces = replaces});
}

std::optional<TowerDraft> TowerEditing::designOf(const Building& building) const {
    const ProposedTower* tower = context_.findTower(building);
    if (tower == nullptr || tower->changed) return std::nullopt;
    return designToCopy(building);
}

std::optional<TowerDraft> TowerEditing::designToCopy(const Building& building) const {
    const ProposedTower* tower = context_.findTower(building);
    if (tower == nullptr || !tower->design) return std::nullopt;
    const TowerDesign& design = *tower->design;
    return TowerDraft{.lot = {design.lotName, design.lot},
                      .settings = design.settings,
                      .tower = building.sourceId,
                      .replaces = building.sourceId};
}

void TowerEditing::resume(TowerDraft draft) {
    if (!context_.city) return;
    draft_ = std::move(draft);
    possible_.reset();
    fit_.reset();
    Q_EMIT began();
    panel_.showDraft(*draft_);
    show();
}

// A further tower that is added takes the plate of the one before it, where its piece of the lot has room.
void TowerEditing::take() {
    if (!draft_) return;
    const std::size_t before = draft_->settings.further.size();
    draft_ = panel_.draft();
    auto& further = draft_->settings.further;
    if (further.size() > before && !draftTower(context_.city->city(), *draft_)) {
        further.back().plate = {};
        panel_.showDraft(*draft_);
    }
    show();
}

void TowerEditing::fit(const FloorAreaTarget& target) {
    if (!draft_) return;
    const Footprint& lot = draft_->lot.outline;
    const double wantedM2 = *target.areaOn(lot);
    // The other button for the same area begins with the tower as it was before the first.
    const bool isOther = fit_ && fit_->wantedM2 == wantedM2 && fit_->fitted == draft_->settings;
    const MassingSettings from = isOther ? fit_->from : draft_->settings;
    const auto fitted = fitFloorArea(lot, from, wantedM2, target.by);
    if (!fitted) return panel_.showNotReached(fitted.error());
    fit_ = {wantedM2, from, *fitted};
    draft_->settings = *fitted;
    panel_.showDraft(*draft_);
    show();
}

void TowerEditing::takeNearest() {
    if (!draft_ || !nearest_) return;
    draft_->settings = nearest_->settings;
    panel_.showDraft(*draft_);
    show();
}

void TowerEditing::showImpossible(const Error& error) {
    nearest_ = possible_ ? findNearestFit(draft_->lot.outline, *possible_, draft_->settings) : std::nullopt;
    panel_.showError(error, nearest_ ? &*nearest_ : nullptr);
}

void TowerEditing::show() {
    if (!draft_) return;
    const auto tower = draftTower(context_.city->city(), *draft_);
    edits_.clear();
    if (!tower) return showImpossible(tower.error());
    possible_ = draft_->settings;
    if (const auto shown = context_.preview.show(tower->edits); !shown)
        return panel_.showError(shown.error());
    edits_ = tower->edits;
    showInRegion();
    const City& city = context_.city->city();
    const auto& built = context_.preview.changes().added.back();
    const glm::dvec2 foot = findMiddle(tower->massing.tiers[tower->massing.firstTiers - 1]);
    const double ground = double(findGroundUnder(*built, city));
    const double elevation = computeElevation(city, {foot.x, foot.y, ground});
    panel_.showFigures(tower->massing, context_.preview.changes().removed.size(), elevation);
    context_.handle.place(
        {{foot.x, foot.y, ground}, heightOf(draft_->settings), draft_->settings.storeyHeightM, elevation});
    context_.handle.showFigures(describeFigures(tower->massing.figures, elevation));
}

void TowerEditing::showInRegion() {
    if (draft_)
        panel_.showInRegion(findInRegion(context_.preview.changes().added, context_.preview.region()));
}

void TowerEditing::setHeight(double heightM) {
    if (!draft_) return;
    draft_->settings = withHeight(draft_->settings, heightM);
    panel_.showDraft(*draft_);
    show();
}

// The preview stays until the changed city arrives with the tower in it.
void TowerEditing::build() {
    if (!draft_ || edits_.empty()) return;
    const TowerDraft done = *draft_;
    built_ = done;
    draft_.reset();
    context_.handle.hide();
    panel_.showNone();
    Q_EMIT ended();
    Q_EMIT editsMade(std::exchange(edits_, {}), tr("Build %1").arg(QString::fromStdString(done.tower)),
                     done.tower);
}

void TowerEditing::cancel() {
    if (!draft_) return;
    draft_.reset();
    edits_.clear();
    context_.handle.hide();
    context_.preview.clear();
    panel_.showNone();
    Q_EMIT ended();
}

}  // namespace noonmark
