#include "app/window/editing/edit_preview.h"

#include <algorithm>

#include "app/window/study/open_city.h"
#include "app/window/view/view_panel.h"
#include "app/window/widgets/error_words.h"
#include "app/window/widgets/number_words.h"

namespace noonmark {

namespace {

using Buildings = std::vector<std::shared_ptr<const Building>>;

// Half width of the square of the live shadow, metres: about the part of the ground that is visible.
double halfWidthM(const CameraPose& pose) { return std::clamp(0.6 * pose.distanceM, 150.0, 1000.0); }

City without(const City& city, const Buildings& removed) {
    City rest = city;
    std::erase_if(rest.buildings, [&](const auto& building) {
        return std::ranges::find(removed, building) != removed.end();
    });
    return rest;
}

}  // namespace

EditPreview::EditPreview(ViewPanel& panel, std::shared_ptr<SharedHorizonCache> horizons, QObject* parent)
    : QObject(parent), panel_(panel), live_(std::move(horizons)) {
    connect(&live_, &LiveFollower::changed, this, &EditPreview::showLive);
    connect(&live_, &LiveFollower::aged, this, &EditPreview::tellAge);
    connect(&live_, &LiveFollower::failed, this, &EditPreview::tellWhy);
    connect(&facades_, &LiveFacades::changed, this, &EditPreview::showLiveFacades);
    connect(&facades_, &LiveFacades::failed, this, [this](const Error& error) {
        panel_.results().setLiveFacades(std::nullopt);
        if (!isCancelled(error)) Q_EMIT told(tr("No live facades. %1").arg(describeError(error)));
    });
}

void EditPreview::setCity(std::shared_ptr<const OpenCity> city) {
    city_ = std::move(city);  // ending the preview must restore the new city's buildings
    clear();
}

void EditPreview::setQuestion(const LiveQuestion& question) {
    if (question_ == question) return;
    question_ = question;
    if (!shown_) return;
    begin();
    live_.follow(changes_.added);
    followFacades();
}

void EditPreview::setFacades(const FacadeSettings& facades) {
    if (facadeSettings_ == facades) return;
    facadeSettings_ = facades;
    beginFacades();
    followFacades();
}

void EditPreview::showFacades(bool shown) {
    facadesShown_ = shown;
    beginFacades();
    followFacades();
}

void EditPreview::toggleNeighbour(const std::shared_ptr<const Building>& building) {
    const auto found = std::ranges::find(neighbours_, building);
    found == neighbours_.end() ? neighbours_.push_back(building) : void(neighbours_.erase(found));
    followFacades();
}

Result<void> EditPreview::show(const std::vector<Edit>& edits) {
    if (!city_) return {};
    auto edited = applied(city_->city(), edits);
    if (!edited) return tl::make_unexpected(edited.error());
    const bool before = shown_;
    const bool others = !shown_ || changes_.removed != edited->changes.removed;
    changes_ = std::move(edited->changes);
    shown_ = true;
    City proposed;
    proposed.buildings = changes_.added;
    panel_.view().overlay().show(OverlayBodies::Tint::proposed, proposed);
    if (others) {
        hide(changes_.removed);
        begin();
    }
    live_.follow(changes_.added);
    followFacades();
    if (!before) Q_EMIT shownChanged(true);
    Q_EMIT shapeChanged(std::make_shared<const City>(std::move(edited->city)));
    return {};
}

void EditPreview::clear() {
    if (!shown_) return;
    shown_ = false;
    changes_ = {};
    live_.end();
    facades_.end();
    neighbours_.clear();
    panel_.results().setLiveFacades(std::nullopt);
    panel_.view().overlay().show(OverlayBodies::Tint::proposed, {});
    panel_.results().setLive(std::nullopt);
    hide({});
    Q_EMIT shownChanged(false);
    Q_EMIT shapeChanged(nullptr);
}

void EditPreview::hide(const Buildings& removed) {
    panel_.view().showChanges(computeDifference(*city_->arrays, without(city_->city(), removed)));
}

void EditPreview::begin() {
    const ChangedVolume volume = computeVolume(changes_);
    beginFacades();
    if (volume.box.empty()) return live_.end();
    live_.begin({without(city_->city(), changes_.removed), volume, halfWidthM(panel_.view().pose())},
                question_);
}

// Nothing is measured where nothing is built.
void EditPreview::beginFacades() {
    facades_.end();
    panel_.results().setLiveFacades(std::nullopt);
    if (!shown_ || !facadesShown_ || changes_.added.empty()) return;
    facades_.begin(without(city_->city(), changes_.removed), question_.sun, facadeSettings_);
}

void EditPreview::followFacades() {
    if (shown_) facades_.follow(changes_.added, neighbours_);
}

void EditPreview::showLiveFacades() {
    const auto answer = facades_.answer();
    const std::size_t points = answer->map.elements.size();
    const int form = pluralNumber(points);
    const QString note = answer->coarse ? tr("Facades: %1 point(s) while it moves", "", form)
                                        : tr("Facades: %1 point(s)", "", form);
    panel_.results().setLiveFacades(
        ElementView{std::shared_ptr<const ElementMap>(answer, &answer->map), note.arg(formatCount(points))});
}

void EditPreview::showLive() { panel_.results().setLive(makeGroundAnswer(live_.answer())); }

void EditPreview::tellAge() {
    const auto answer = makeGroundAnswer(live_.answer());
    panel_.results().noteLive(
        tr("%1. Shape of %2 s ago").arg(answer.note, groupDigits(live_.ageSeconds(), 1)));
}

// Without a live shadow only the buildings are shown.
void EditPreview::tellWhy(const Error& error) {
    panel_.results().setLive(std::nullopt);
    Q_EMIT told(isCancelled(error) ? tr("The live shadow was cancelled; it returns with the next design")
                                   : tr("No live shadow. %1").arg(describeError(error)));
}

}  // namespace noonmark
