#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/points/point_sunlight.h"
#include "core/engines/points/sky_factors.h"
#include "core/engines/points/skyline.h"
#include "core/study/point_crowns.h"
#include "core/sun/civil_time.h"

namespace noonmark {

/// A question about the sun and sky of one point.
struct PointQuestion {
    LonLat at;
    std::optional<double> heightM;    ///< above the ground; none: on the ground, or on the roof of a building
    std::optional<double> facingDeg;  ///< azimuth from true north that a wall faces; none: a level surface
    CivilDate day{std::chrono::year{2026}, std::chrono::March,
                  std::chrono::day{21}};  ///< its year is measured, too
    std::string zone = "UTC";
    double stepMinutes = 1;  ///< 1/60 to 240
};

/// The buildings that hide the sky, one entry for each unbroken stretch of the skyline.
struct SkylineStretch {
    double fromDeg = 0, toDeg = 0;  ///< azimuths from true north
    std::uint32_t building = 0;     ///< index in City::buildings, or SkyObstacles::terrain
};

/// Azimuth from true north and altitude, degrees.
struct SkylinePlace {
    double azimuthDeg = 0;
    double altitudeDeg = 0;
};

/// Sky that overhangs hide above the skyline, within half a degree of azimuth (as in its middle).
struct OverhangSpan {
    double fromDeg = 0, toDeg = 0;   ///< azimuths from true north, 0 to 360
    double lowDeg = 0, highDeg = 0;  ///< altitudes
};

/// A time of the day in which one thing hides the sun, with the sun above the horizon.
struct ShadedTime {
    SunBand when;  ///< ends at sunlight are exact, those between two buildings lie on a step of the day
    std::uint32_t building = 0;  ///< index in City::buildings, or a constant of SkyObstacles
};

/// The sun and sky of a point in one city.
struct PointView {
    std::vector<SkylinePlace> skyline;  ///< 0 to 360 degrees, at most 1 degree apart; two entries at a jump
    std::vector<SkylineStretch> stretches;
    std::vector<OverhangSpan> overhangs;  ///< ascending azimuths
    SkyFactors factors;
    /// Sunlit times of the day, at steps of at most a minute, with ends to 0.1 s; bands shorter than such a
    /// step may be missing.
    std::vector<SunBand> sunlit;
    std::vector<ShadedTime> shadedTimes;  ///< of the day, in order
    /// Sunlit minutes of the year at the question's step, by month and hour of the wall clock.
    MonthHours minutes{};
    PointShadow year;
    ShadedSteps shaded;                 ///< of PointStudy::sun
    std::optional<PointCrowns> crowns;  ///< none: no tree is seen; all else is without trees
};

/// Days of the year on which a proposal takes sun, with gaps of at most three days.
struct SeasonOfLoss {
    CivilDate first, last;     ///< may run over the end of the year: first is then the later date
    int days = 0;              ///< on which sun is taken
    double minutesPerDay = 0;  ///< mean over those days
    /// Wall clock: the middle four fifths of the minutes taken lie between these.
    std::chrono::minutes mostlyFrom{0}, mostlyTo{0};
};

struct PointStudy {
    PointQuestion question;
    glm::vec3 position{};  ///< local metres
    bool onRoof = false;
    double possibleMin = 0;  ///< minutes of the year with the sun above the horizon
    SunSteps sun;            ///< of the year, from sunrise to sunset
    std::size_t day = 0;     ///< index in SunSteps::days
    PointView baseline;
    std::optional<PointView> scenario;
    std::vector<SeasonOfLoss> losses;  ///< the scenario's, most minutes first; at steps of a minute or less
    double seconds = 0;                ///< wall time of the computation
};

/// Measures the point in a city and, if given, in the city of a scenario. Error: the point is inside a
/// building or an overhang, the zone is unknown, a value out of range, cancelled(). In Midtown, of 100,000
/// edges, 0.14 s for one city and a year at one minute, 0.2 s with a scenario.
Result<PointStudy> runPointStudy(const City& baseline, const City* scenario, const PointQuestion& question,
                                 const std::stop_token& stop);

}  // namespace noonmark
