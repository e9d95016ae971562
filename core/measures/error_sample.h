#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/engines/api/shadow_field.h"
#include "core/measures/sampled_error.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

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
