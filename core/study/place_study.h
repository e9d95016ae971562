#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/engines/api/engine.h"
#include "core/measures/places/place_sums.h"
#include "core/measures/places/place_timeline.h"
#include "core/receivers/place.h"
#include "core/sun/period.h"

namespace noonmark {

struct PlaceStudySettings {
    Period period;
    double cellM = 1;          ///< 0.25 to 10
    bool allSteps = true;      ///< hold the areas of every step of every day (40 bytes each)
    bool longestStays = true;  ///< and the longest stay at one spot of every day
};

/// A place's shadow over the days of a period.
struct PlaceTimeline {
    Place place;
    std::vector<DayTimeline> days;
    PlaceSums sums;
    /// Where the longest stay of incremental shadow is, of each day, degrees; none without one.
    std::vector<std::optional<LonLat>> longestIncrementalAt;
};

struct PlaceStudy {
    std::vector<PlaceTimeline> places;  ///< in the order given
    std::string engine;                 ///< "Projected shadows"
    double cellM = 1;
    double stepMinutes = 1;
    Warnings warnings;  ///< places without a cell
};

/// The timelines of places in a baseline and in a scenario (null: the baseline alone). The sun is that of the
/// city's middle (observerOfPlaces()). Days without sun are listed with no steps. Error: no place, a period
/// out of range, the sun below the horizon at all steps; errors of Engine::shadeSteps(); cancelled().
Result<PlaceStudy> runPlaceStudy(const City& baseline, const City* scenario, const std::vector<Place>& places,
                                 const PlaceStudySettings& settings, const Engine& engine, Progress& progress,
                                 std::stop_token stop);

}  // namespace noonmark
