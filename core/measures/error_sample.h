#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/shadow_field.h"
#include "core/measures/sampled_error.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

struct ErrorSampleSettings {
    static constexpr int mostReceivers = 10'000;
    /// The most rays that are spent on it: one or two seconds on two cores. Periods of so many steps that
    /// `receivers` would take more are compared on fewer, but on no fewer than `leastReceivers`.
    static constexpr std::uint64_t mostRays = 60'000'000;
    static constexpr int leastReceivers = 30;

    int receivers =
        300;  ///< compared with the ray reference, 0 to mostReceivers; 0: the error is not measured
    std::uint32_t seed = 1;  ///< of the places; the same seed, the same places
    bool operator==(const ErrorSampleSettings&) const = default;
};

/// How many receivers are compared over so many steps.
std::size_t sampleSize(const ErrorSampleSettings& settings, std::size_t steps);

/// Up to `count` of the receivers, every one as likely as another, spread evenly over the region: the cells
/// at the points of a low-discrepancy sequence (R2: M. Roberts, 2018), moved by the seed. Ascending; fewer
/// where there are fewer, or where receivers are less than a thousandth of the grid. O(count).
std::vector<std::uint32_t> spreadReceivers(const Receivers& receivers, std::size_t count, std::uint32_t seed);

/// The receivers of one piece of a larger grid that lie at the first `points` places of such a sequence over
/// the whole: pieces together hold each place once. Ascending. O(points).
std::vector<std::uint32_t> spreadReceivers(const Receivers& piece, const Grid& whole, std::size_t points,
                                           std::uint32_t seed);

/// A copy with `cells` (ascending) as its only receivers; the other ground cells count as outside the region.
Receivers onlyReceivers(const Receivers& receivers, std::vector<std::uint32_t> cells);

/// The field of an engine at these receivers, beside what the ray reference finds there over all steps. Costs
/// cells x steps rays and a ray scene of the buildings in reach; hands out no running results.
Result<std::vector<ComparedCell>> compareWithReference(const City& city, const Receivers& receivers,
                                                       const SunSteps& sun, const ShadowField& field,
                                                       std::vector<std::uint32_t> cells, Progress& progress,
                                                       std::stop_token stop);

/// Minutes of the day with the most steps: 100 % of continuous shadow.
double longestDayMinutes(const SunSteps& sun);

/// All of it: a sample of the field's receivers, compared.
Result<SampledError> sampleError(const City& city, const Receivers& receivers, const SunSteps& sun,
                                 const ShadowField& field, const ErrorSampleSettings& settings,
                                 Progress& progress, std::stop_token stop);

}  // namespace noonmark
