#include "app/gui/tools/massing/tower_editing.h"

#include <algorithm>
#include <utility>

#include "app/gui/base/widgets/height_words.h"
#include "app/gui/tools/massing/figure_words.h"
#include "app/gui/tools/massing/massing_panel.h"
#include "core/city/terrain/building_ground.h"

namespace noonmark {

namespace {

// The handle's position: the middle of the highest floor plate.
glm::dvec2 findMiddle(const Tier& tier) {
    Building building;
    for (const Footprint& piece : tier.plate) building.parts.push_back({.footprint = piece});
    return noonmark::findMiddle(building);
}

}  // namespace

TowerEditing::TowerEditing(EditContext& context, MassingPanel& panel, QObject* parent)
    : QObject(parent), context_(context), panel_(panel) {
    connect(&panel_, &MassingPanel::edited, this, &TowerEditing::take);
    connect(&panel_, &MassingPanel::applied, this, &TowerEditing::build);
    connect(&panel_, &MassingPanel::cancelled, this, &TowerEditing::cancel);
}

void TowerEditing::begin(const NamedLot& lot, const std::string& replaces, int storeys) {
    if (!context_.city) return;
    resume({.lot = lot,
            .settings = {.storeys = storeys},
            .tower = freeTowerName(context_.city->city()),
            .replaces = replaces});
}

std::optional<TowerDraft> TowerEditing::designOf(const Building& building) const {
    const auto found = towers_.find(building.sourceId);
    if (found == towers_.end() || found->second.changed) return std::nullopt;
    return designToCopy(building);
}

std::optional<TowerDraft> TowerEditing::designToCopy(const Building& building) const {
    const auto found = towers_.find(building.sourceId);
    if (found == towers_.end() || !found->second.design) return std::nullopt;
    const TowerDesign& design = *found->second.design;
    return TowerDraft{.lot = {design.lotName, design.lot},
                      .settings = design.settings,
                      .tower = building.sourceId,
                      .replaces = building.sourceId};
}

void TowerEditing::resume(TowerDraft draft) {
    if (!context_.city) return;
    draft_ = std::move(draft);
    Q_EMIT began();
    panel_.showDraft(*draft_);
    show();
}

void TowerEditing::take() {
    if (!draft_) return;
    draft_ = panel_.draft();
    show();
}

void TowerEditing::show() {
    if (!draft_) return;
    const auto tower = draftTower(context_.city->city(), *draft_);
    edits_.clear();
    if (!tower) return panel_.showError(tower.error());
    if (const auto shown = context_.preview.show(tower->edits); !shown)
        return panel_.showError(shown.error());
    edits_ = tower->edits;
    const City& city = context_.city->city();
    const auto& built = context_.preview.changes().added.back();
    const glm::dvec2 foot = findMiddle(tower->massing.tiers.back());
    const double ground = double(findGroundUnder(*built, city));
    const double elevation = computeElevation(city, {foot.x, foot.y, ground});
    panel_.showFigures(tower->massing.figures, context_.preview.changes().removed.size(), elevation);
    context_.handle.stand({{foot.x, foot.y, ground},
                           tower->massing.figures.heightM,
                           draft_->settings.storeyHeightM,
                           elevation});
    context_.handle.tell(describeFigures(tower->massing.figures, elevation));
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
