#pragma once

// The folder core/study/elements measures sunlight at points instead of cells: on facades, at windows, on a
// horizontal plane. runElementStudy() (this file) returns an ElementStudy; element_tables.h turns it into
// tables and JSON. place_elements.h places the points.

#include <limits>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/engines/points/point_horizons.h"
#include "core/study/elements/place_elements.h"

namespace noonmark {

/// Differences of one quantity from the ray reference, in percent.
struct QuantityError {
    double meanPct = 0, p99Pct = 0, largestPct = 0;
};

/// The error of a sample of the points, over all steps: percent of the sunlit minutes of the period for
/// gross, of the longest day's for unbroken times.
struct ElementError {
    std::size_t points = 0;
    std::uint64_t rays = 0;
    QuantityError gross, continuous;
    std::optional<QuantityError> longestSun;  ///< none in results of earlier versions
};

/// What the sweep of points aims at: the mean error of sunlit time, percent of the sunlit minutes of the
/// period. Twice what it is off by in cities whose parts stand on the ground (docs/user/limits.md).
inline constexpr double pointErrorTargetPct = 0.1;

/// "sunlit time 0.010 % mean, 0.080 % at the 99th percentile, 0.110 % largest; longest shadow ...; longest
/// sun ..., of 300 points"
std::string describe(const ElementError& error);

struct ElementStudy {
    City city;
    StudySettings settings;  ///< region, period, engine, cell of a plane, error sample
    ElementSettings elements;
    PointReceivers receivers;
    double planeM = 0;  ///< local z of the plane
    SunSteps sun;
    PointMonths minutes;                    ///< with unbroken times
    std::optional<ShadedPoints> trees;      ///< the same with trees; none: no tree reaches a point
    std::string engineKey;                  ///< "horizon" or "ray"
    std::string whyRays;                    ///< why "auto" went on to rays; empty: it did not
    std::optional<ElementError> error;      ///< none for the ray reference, or if none was asked for
    std::map<std::string, double> seconds;  ///< by stage, and "total"
    Warnings warnings;                      ///< from reading, placing and computing
    Provenance provenance;                  ///< what the city was made from; set by the caller
    std::optional<InputFile> glazingInput;  ///< set by the caller
    HeightFacts heights;

    /// Gross shadow of a point: minutes a day, mean over the days.
    [[nodiscard]] double grossMin(std::size_t point) const {
        return (minutes.possibleMin - minutes.sunlitOf(point)) / double(sun.dayCount());
    }
};

/// "horizons of points", "rays", "rays, since a sample ..."
std::string describeEngine(const ElementStudy& study);

/// Places the points, computes the sun in the middle of the region, and measures every point: engine
/// "horizon" sweeps horizons, "ray" traces every step; "auto" sweeps, and goes on to rays where a sample of
/// the points is off by more than pointErrorTargetPct in the mean. Points inside a building or below the
/// ground are left out, with a warning. Then with trees, as `settings.trees` asks. Error: a setting out of
/// range, another engine, a building that does not exist or lies outside the region, no points, what
/// readGlazing() refuses, a sun that never rises, cancelled().
Result<ElementStudy> runElementStudy(const City& city, const StudySettings& settings,
                                     const ElementSettings& elements, Progress& progress,
                                     const std::stop_token& stop);

/// The noonmark-cli command line that repeats a study at points, as makeRepeatCommand() of repeat_command.h.
Result<std::string> makeRepeatCommand(const ElementStudy& study,
                                      std::size_t width = std::numeric_limits<std::size_t>::max());

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
    std::size_t trees = 0;      ///< that can shade one of the measured points, by horizons
    double horizonSeconds = 0;  ///< of the whole study by horizons, with the error sample and without files
    double raySeconds = 0;      ///< of the whole study by rays; both with trees, where they are wanted
};

/// Does what the study does once for all points (placing, sun, scenes of horizons and of rays), measures 256
/// of the points by horizons and 16 by rays, evenly chosen, with their trees, and multiplies: so it holds for
/// the density of the city. docs/benchmarks.md states its error. Takes some 0.1 s in Monaco, a second in
/// Midtown. Errors as of runElementStudy() but for the choice of engine.
Result<ElementForecast> forecastElementStudy(const City& city, const StudySettings& settings,
                                             const ElementSettings& elements, Progress& progress,
                                             const std::stop_token& stop);

}  // namespace noonmark
