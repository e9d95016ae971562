#include "core/measures/outlines/day_isochrones.h"

#include <algorithm>
#include <cmath>

#include "core/engines/auto_engine.h"
#include "core/engines/ray/ray_reference.h"
#include "core/receivers/roof_receivers.h"

namespace noonmark {

namespace {

constexpr double maxCells = 600'000;
constexpr double maxCellsTraced = 90'000;  // a ray is much slower

/// Everywhere in the area, whatever stands there.
Result<Receivers> placeEverywhere(const City& city, const Box2& area, double cells,
                                  const std::stop_token& stop) {
    const glm::dvec2 size(area.high - area.low);
    const double cellM = std::clamp(std::sqrt(size.x * size.y / cells), 0.5, 10.0);
    const City ground{city.frame, {}, city.terrain};
    return placeReceiversOnGround(ground, makeRegionFromLocalBox(area), {.cellM = cellM}, stop);
}

}  // namespace

Result<DayIsochrones> traceDayIsochrones(const City& city, const SunSteps& day,
                                         const IsochroneSettings& settings, Progress& progress,
                                         const std::stop_token& stop) {
    const auto above = settings.planeM ? cutAbovePlane(city, *settings.planeM) : std::nullopt;
    const bool raysOnly = settings.planeM && !above;
    auto receivers = placeEverywhere(city, settings.area, raysOnly ? maxCellsTraced : maxCells, stop);
    if (!receivers) return tl::make_unexpected(receivers.error());
    if (raysOnly) raiseToPlane(*receivers, *settings.planeM);
    const auto field = raysOnly
                           ? RayReference().accumulate(city, *receivers, day, progress, stop)
                           : AutoEngine().accumulate(above ? *above : city, *receivers, day, progress, stop);
    if (!field) return tl::make_unexpected(field.error());
    return DayIsochrones{field->grid.cellM, traceIsochrones(field->grid, field->grossMin, settings.levelsMin),
                         field->engine};
}

}  // namespace noonmark
