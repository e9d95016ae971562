#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/study/elements/element_map.h"

namespace noonmark {

/// The facades whose sunlight is shown while a building is edited.
struct FacadeQuestion {
    using Buildings = std::vector<std::shared_ptr<const Building>>;

    std::shared_ptr<const City> rest;  ///< the city without the buildings that the edit replaces
    std::shared_ptr<const SunSteps> sun;
    FacadeSettings facades;
    Buildings shape;       ///< the edited buildings, not in `rest`
    Buildings neighbours;  ///< of `rest`, whose facades are shown too
    OwnStoreys storeys{};  ///< of the shape
};

/// The sunlight of these facades.
struct FacadeAnswer {
    ElementMap map;
    FacadeSettings facades;   ///< bays and storeys that were measured
    bool coarse = false;      ///< see measureFacadesCoarsely()
    double buildSeconds = 0;  ///< independent of the number of points
    double sweepSeconds = 0;
};

/// Measures every bay and storey. Error: what placeOnFacades() refuses, cancelled(). In Midtown some 0.3 s
/// and 1 ms a point for a year of minutes.
Result<FacadeAnswer> measureFacades(const FacadeQuestion& question, Progress& progress,
                                    const std::stop_token& stop);

/// The same while the shape moves: with bays and storeys so large that there are about `points`, and with
/// buildings only that rise above nearHorizonDeg or are within nearM of the shape. Sun below that altitude
/// may be missed, or counted where a far building hides it.
Result<FacadeAnswer> measureFacadesCoarsely(const FacadeQuestion& question, std::size_t points,
                                            Progress& progress, const std::stop_token& stop);
inline constexpr double nearHorizonDeg = 5, nearM = 150;

}  // namespace noonmark
