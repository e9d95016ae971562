#pragma once

#include <stop_token>

#include "core/study/elements/element_study.h"

namespace noonmark {

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
