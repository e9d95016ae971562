#include "app/window/massing/live_shadow.h"

#include <algorithm>
#include <limits>

#include "core/accumulate/reach.h"

namespace noonmark {

namespace {

constexpr int cellsToASide = 400;

// Of a long period moments from many days and hours, as one day.
SunSteps spread(const SunSteps& sun) {
    const std::size_t all = sun.steps.size(), most = LiveShadow::someMoments;
    if (all <= LiveShadow::mostSteps) return sun;
    SunSteps chosen{.stepMinutes = sun.stepMinutes};
    for (std::size_t k = 0; k < most; ++k) chosen.steps.push_back(sun.steps[(2 * k + 1) * all / (2 * most)]);
    chosen.days.push_back({.count = std::uint32_t(most)});
    return chosen;
}

Result<SunSteps> daylight(const Period& period, const Observer& observer, const std::stop_token& stop) {
    auto sun = sunSteps(period, observer, stop);
    if (sun && sun->steps.empty())
        return failure("The sun is below the horizon all the time", textOf(period),
                       "Choose other hours or days");
    return sun;
}

// Only what can shade: each picture looks through it.
City shading(const City& city, const Receivers& receivers, const SunSteps& sun) {
    City around{.frame = city.frame, .terrain = city.terrain};
    for (const std::uint32_t building : buildingsInReach(city, receivers, sun))
        around.buildings.push_back(city.buildings[building]);
    return around;
}

}  // namespace

Result<std::shared_ptr<LiveShadow>> LiveShadow::around(const City& city, glm::dvec2 centre, double halfM,
                                                       const Period& period, const Observer& observer,
                                                       Progress& progress, const std::stop_token& stop) {
    const auto whole = daylight(period, observer, stop);
    if (!whole) return tl::make_unexpected(whole.error());
    const auto half = glm::vec2(float(halfM));
    const Region region = regionFromLocalBox({glm::vec2(centre) - half, glm::vec2(centre) + half});
    auto receivers = receiversOnGround(city, region, {.cellM = 2 * halfM / cellsToASide}, stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    const SunSteps sun = spread(*whole);
    City around = shading(city, *receivers, sun);
    auto kept = KeptShadows::make(around, *receivers, sun, progress, stop);
    if (!kept) return tl::make_unexpected(kept.error());
    std::shared_ptr<LiveShadow> live(
        new LiveShadow(std::move(around), *std::move(receivers), *std::move(kept)));
    live->moments_ = sun.steps.size();
    live->all_ = whole->steps.size();
    live->sunlitMinutesPerDay_ = whole->sunlitMinutes() / double(std::max<std::size_t>(1, whole->dayCount()));
    return live;
}

Result<ShadowField> LiveShadow::with(const std::vector<std::shared_ptr<const Building>>& shape) {
    City city = around_;
    city.buildings.insert(city.buildings.end(), shape.begin(), shape.end());
    NoProgress silent;
    if (const auto done = kept_.change(city, receivers_, silent, {}); !done)
        return tl::make_unexpected(done.error());
    ShadowField field = kept_.field();
    if (moments_ == all_) return field;
    const double minutes = sunlitMinutesPerDay_ / field.sunlitMinutesPerDay;
    for (float& gross : field.grossMin) gross = float(double(gross) * minutes);
    field.sunlitMinutesPerDay = sunlitMinutesPerDay_;
    std::ranges::fill(field.continuousMin, std::numeric_limits<float>::quiet_NaN());
    return field;
}

}  // namespace noonmark
