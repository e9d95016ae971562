#include "core/measures/outlines/day_isochrones.h"

#include <algorithm>
#include <cmath>

#include "core/engines/auto_engine.h"
#include "core/engines/ray/ray_reference.h"
#include "core/receivers/plane_receivers.h"

namespace noonmark {

namespace {

constexpr double mostCells = 90'000;

/// Everywhere in the area, whatever stands there.
Result<Receivers> placeEverywhere(const City& city, const IsochroneSettings& settings,
                                  const std::stop_token& stop) {
    const glm::dvec2 size(settings.area.high - settings.area.low);
    const double cellM = std::clamp(std::sqrt(size.x * size.y / mostCells), 0.5, 10.0);
    const City ground{city.frame, {}, city.terrain};
    auto receivers =
        placeReceiversOnGround(ground, makeRegionFromLocalBox(settings.area), {.cellM = cellM}, stop);
    if (receivers && settings.planeM) raiseToPlane(*receivers, *settings.planeM);
    return receivers;
}

}  // namespace

Result<DayIsochrones> traceDayIsochrones(const City& city, const SunSteps& day,
                                         const IsochroneSettings& settings, Progress& progress,
                                         const std::stop_token& stop) {
    const auto receivers = placeEverywhere(city, settings, stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    const auto field = settings.planeM ? RayReference().accumulate(city, *receivers, day, progress, stop)
                                       : AutoEngine().accumulate(city, *receivers, day, progress, stop);
    if (!field) return tl::make_unexpected(field.error());
    return DayIsochrones{field->grid.cellM, traceIsochrones(field->grid, field->grossMin, settings.levelsMin),
                         field->engine};
}

}  // namespace noonmark
