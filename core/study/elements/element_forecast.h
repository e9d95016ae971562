#pragma once

#include <stop_token>

#include "core/study/elements/element_study.h"

namespace noonmark {

/// Measures a sample of the study's points by rays and compares. Points are taken at equal distances in the
/// list, beginning at a place that the seed chooses; as many as the settings ask for and as maxRays allows.
/// `scene`: of the study's city; none: made here.
Result<ElementError> sampleElementError(const ElementStudy& study, const std::optional<RayScene>& scene,
                                        Progress& progress, const std::stop_token& stop);

/// Up to `count` indices of `all` points, ascending and evenly spread; the seed shifts them.
std::vector<std::size_t> choosePoints(std::size_t all, std::size_t count, std::uint32_t seed);
SurfacePoints pointsAt(const SurfacePoints& all, const std::vector<std::size_t>& chosen);

/// What a study at points is expected to take on this machine.
struct ElementForecast {
    std::size_t points = 0;
    std::size_t steps = 0;      ///< with the sun up
    double horizonSeconds = 0;  ///< of the whole study by horizons, with the error sample and without files
    double raySeconds = 0;      ///< of the whole study by rays
};

/// Does what the study does once for all points (placing, sun, scenes of horizons and of rays), measures 256
/// of the points by horizons and 16 by rays, evenly chosen, and multiplies: so it holds for the density of
/// the city. docs/benchmarks.md states its error. Takes some 0.1 s in Monaco, a second in Midtown. Errors as
/// of runElementStudy() but for the choice of engine.
Result<ElementForecast> forecastElementStudy(const City& city, const StudySettings& settings,
                                             const ElementSettings& elements, Progress& progress,
                                             const std::stop_token& stop);

}  // namespace noonmark
