#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/engines/api/engine.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/api/step_sets.h"
#include "core/engines/ray/ray_scene.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// The minutes of one receiver by an engine, and by the ray reference over the same steps.
struct ComparedCell {
    glm::dvec2 centreM{0};  ///< local metres
    double grossMin = 0;    ///< minutes per day
    double referenceGrossMin = 0;
    double continuousMin = 0;  ///< NaN if runs were not counted
    double referenceContinuousMin = 0;
};

/// Statistics of the absolute differences of cells. In minutes; percent() converts to % of `wholeMin`.
struct CellError {
    double meanMin = 0;
    double meanStandardErrorMin = 0;  ///< standard error of the mean, from the spread of the sample
    double p99Min = 0;                ///< 99 % of the cells differ by no more than this
    double maxMin = 0;
    glm::dvec2 worstM{0};  ///< centre of the cell with the largest difference, local metres
    double wholeMin = 0;   ///< minutes that are 100 %

    [[nodiscard]] double percent(double minutes) const { return wholeMin > 0 ? 100 * minutes / wholeMin : 0; }
};

/// An engine's error on a sample of receivers. The area error is the engine's shadow area minus the
/// reference's, divided by the area of the receivers; the true error over all receivers lies within two
/// standard errors of it 19 times out of 20. The worst cell is the worst of the sample; other cells may be
/// worse.
struct SampledError {
    std::size_t receivers = 0;        ///< number of receivers compared
    std::size_t ofReceivers = 0;      ///< number of all receivers
    std::uint64_t rays = 0;           ///< rays traced for the reference
    double areaPct = 0;               ///< % of the receivers' area
    double areaStandardErrorPct = 0;  ///< standard error of areaPct, from the spread of the sample
    CellError gross;                  ///< 100 % is the sunlit minutes of a mean day
    CellError continuous;  ///< 100 % is the sunlit minutes of the longest day; minutes are NaN without runs

    /// The part of the error that engines' error targets limit.
    [[nodiscard]] SampledDeviation grossOff() const {
        return {gross.percent(gross.meanMin), gross.percent(gross.meanStandardErrorMin)};
    }
};

/// Statistics of a sample; all zero for an empty one. `sunlitMinutesPerDay` and `longestDayMin` are 100 % of
/// gross and continuous shadow, minutes. O(n log n).
SampledError errorOf(std::span<const ComparedCell> cells, double sunlitMinutesPerDay, double longestDayMin);

/// Compares an engine's field at some receivers with rays through an existing scene over all steps. The scene
/// must hold at least every building in reach of these receivers. Publishes no partial results.
Result<std::vector<ComparedCell>> compareByRays(const RayScene& scene, const Receivers& receivers,
                                                const SunSteps& sun, const ShadowField& field,
                                                std::span<const std::uint32_t> cells, Progress& progress,
                                                const std::stop_token& stop);

/// Minutes of the period in shadow at some cells, by set of steps and then by cell: of an engine, and by the
/// ray reference over the same steps.
struct ComparedSets {
    std::vector<std::vector<double>> minutes;
    std::vector<std::vector<double>> reference;
};

/// Minutes of the period in shadow at these receivers, ascending, by set and then by cell, by rays. Costs
/// cells x steps rays and a ray scene of the buildings in reach.
Result<std::vector<std::vector<double>>> traceSets(const City& city, const Receivers& receivers,
                                                   const SunSteps& sun, const StepSets& sets,
                                                   const std::vector<std::uint32_t>& cells,
                                                   Progress& progress, const std::stop_token& stop);

/// An engine's sums by set at the cells of these receivers, by set and then by cell.
std::vector<std::vector<double>> minutesAt(const ShadowBreakdown& sums,
                                           const std::vector<std::uint32_t>& cells);

/// Holds an engine's sums by set against the ray reference at these receivers, ascending. Costs as of
/// traceSets().
Result<ComparedSets> compareSets(const City& city, const Receivers& receivers, const SunSteps& sun,
                                 const ShadowBreakdown& sums, const std::vector<std::uint32_t>& cells,
                                 Progress& progress, const std::stop_token& stop);

struct ErrorSampleSettings {
    static constexpr int maxReceivers = 10'000;
    /// Maximum number of rays: one or two seconds on two cores. If `receivers` would take more over the
    /// period's steps, fewer are compared, but at least `minReceivers`.
    static constexpr std::uint64_t maxRays = 60'000'000;
    static constexpr int minReceivers = 30;

    /// Number of receivers to compare with the ray reference, 0 to maxReceivers; 0: do not measure the error
    int receivers = 300;
    std::uint32_t seed = 1;  ///< selects the receivers; the same seed gives the same receivers
    bool operator==(const ErrorSampleSettings&) const = default;
};

/// Number of receivers that are compared over `steps` steps.
std::size_t sampleSize(const ErrorSampleSettings& settings, std::size_t steps);

/// Selects up to `count` of the receivers, all equally likely, spread evenly over the region: the cells at
/// the points of a low-discrepancy sequence (R2: M. Roberts, 2018), shifted by the seed. Ascending; fewer if
/// there are fewer, or if receivers are less than a thousandth of the grid. O(count).
std::vector<std::uint32_t> spreadReceivers(const Receivers& receivers, std::size_t count, std::uint32_t seed);

/// The receivers of one piece of a larger grid at the first `points` points of such a sequence over the whole
/// grid: all pieces together hold each point once. Ascending. O(points).
std::vector<std::uint32_t> spreadReceivers(const Receivers& piece, const Grid& whole, std::size_t points,
                                           std::uint32_t seed);

/// A copy with `cells` (ascending) as its only receivers; the other ground cells count as outside the region.
Receivers onlyReceivers(const Receivers& receivers, std::vector<std::uint32_t> cells);

/// Compares an engine's field at these receivers with the ray reference over all steps. Costs cells x steps
/// rays and a ray scene of the buildings in reach; publishes no partial results.
Result<std::vector<ComparedCell>> compareWithReference(const City& city, const Receivers& receivers,
                                                       const SunSteps& sun, const ShadowField& field,
                                                       std::vector<std::uint32_t> cells, Progress& progress,
                                                       std::stop_token stop);

/// Minutes of the day with the most steps: 100 % of continuous shadow.
double longestDayMinutes(const SunSteps& sun);

/// Selects a sample of the field's receivers, compares them, and computes the error.
Result<SampledError> sampleError(const City& city, const Receivers& receivers, const SunSteps& sun,
                                 const ShadowField& field, const ErrorSampleSettings& settings,
                                 Progress& progress, std::stop_token stop);

/// Takes the error of a result, or states in a warning why it was not measured, which fails no study. Error:
/// cancelled().
Result<void> takeError(const Result<SampledError>& measured, std::optional<SampledError>& error,
                       Warnings& warnings);

}  // namespace noonmark
