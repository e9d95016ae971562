#include "app/window/massing/edit_preview.h"

#include <algorithm>

#include "app/window/open_city.h"
#include "app/window/view_panel.h"

namespace noonmark {

namespace {

using Buildings = std::vector<std::shared_ptr<const Building>>;

// The square whose shadow is shown: as much as the view shows of it, in cells that suit it.
double halfWidthM(const CameraPose& pose) { return std::clamp(0.6 * pose.distanceM, 150.0, 1000.0); }

City without(const City& city, const Buildings& removed) {
    City rest = city;
    std::erase_if(rest.buildings, [&](const auto& building) {
        return std::ranges::find(removed, building) != removed.end();
    });
    return rest;
}

QString noteOf(const LiveShadow& shadow) {
    if (shadow.moments() == shadow.momentsOfPeriod()) return QObject::tr("With the proposal");
    return QObject::tr("With the proposal, from %1 of %2 moments")
        .arg(shadow.moments())
        .arg(shadow.momentsOfPeriod());
}

}  // namespace

EditPreview::EditPreview(ViewPanel& panel, QObject* parent) : QObject(parent), panel_(panel) {}

void EditPreview::setCity(std::shared_ptr<const OpenCity> city) {
    city_ = std::move(city);  // what comes back when the preview goes is the new one's
    clear();
}

void EditPreview::setPeriod(const Period& period, const Observer& observer) {
    if (period_ == period && observer_ == observer) return;
    period_ = period;
    observer_ = observer;
    if (shown_) prepareShadow();
}

Result<void> EditPreview::show(const std::vector<Edit>& edits) {
    if (!city_) return {};
    auto edited = applied(city_->city(), edits);
    if (!edited) return tl::make_unexpected(edited.error());
    const bool others = !shown_ || changes_.removed != edited->changes.removed;
    changes_ = std::move(edited->changes);
    shown_ = true;
    City proposed;
    proposed.buildings = changes_.added;
    panel_.view().overlay().show(OverlayBodies::Tint::proposed, proposed);
    if (others) {
        hide(changes_.removed);
        prepareShadow();
    }
    showShadow();
    return {};
}

void EditPreview::clear() {
    if (!shown_) return;
    shown_ = false;
    changes_ = {};
    slot_.drop();
    shadow_.reset();
    panel_.view().overlay().show(OverlayBodies::Tint::proposed, {});
    panel_.results().setLive(nullptr, nullptr, {});
    hide({});
}

void EditPreview::hide(const Buildings& removed) {
    panel_.view().showChanges(differenceOf(*city_->arrays, without(city_->city(), removed)));
}

void EditPreview::prepareShadow() {
    shadow_.reset();
    const Box2 box = volumeOf(changes_).box;
    if (box.empty() || city_->city().terrain) return slot_.drop();
    const glm::dvec2 centre = glm::dvec2(box.low + box.high) / 2.0;
    slot_.start<std::shared_ptr<LiveShadow>>(
        tr("Live shadow"),
        [city = without(city_->city(), changes_.removed), centre, half = halfWidthM(panel_.view().pose()),
         period = period_, observer = observer_](Progress& progress, const std::stop_token& stop) {
            return LiveShadow::around(city, centre, half, period, observer, progress, stop);
        },
        [this](Result<std::shared_ptr<LiveShadow>> shadow) {
            if (!shadow) return;  // a night, or terrain: the bodies alone are shown
            shadow_ = *std::move(shadow);
            showShadow();
        });
}

void EditPreview::showShadow() {
    if (!shadow_ || !shown_) return;
    const auto field = shadow_->with(changes_.added);
    if (!field) return panel_.results().setLive(nullptr, nullptr, {});  // the bodies alone are shown
    panel_.results().setLive(&*field, &shadow_->receivers(), noteOf(*shadow_));
}

}  // namespace noonmark
