#pragma once

#include <optional>
#include <vector>

#include "core/engines/horizon/counting/period_count.h"
#include "core/engines/horizon/counting/sun_change.h"

namespace noonmark {

/// A period's bins by number: null or empty if the period does not visit the bin.
using HiddenByNumber = std::vector<const HiddenSuns*>;
using SunsByNumber = std::vector<std::vector<CountChange>>;  ///< changes from an empty period

/// A period prepared for counting with cached horizons. Data that not every count needs is created on first
/// use. Not thread-safe.
class CountedPeriod {
public:
    CountedPeriod(const SunSteps& sun, double binDeg);

    [[nodiscard]] const BinnedSun& binned() const { return binned_; }
    /// O(steps) on the first call.
    const RunCount& runs();
    /// The same tables in two forms, for looking up one horizon and for a row of them. `bins`: number of
    /// possible bin numbers. Some 0.05 ms per bin on the first call.
    const HiddenByNumber& hidden(std::size_t bins);
    const SunsByNumber& suns(std::size_t bins);

private:
    BinnedSun binned_;
    std::vector<TimedStep> steps_;  // empty after runs_ is created
    std::optional<RunCount> runs_;
    std::vector<std::optional<HiddenSuns>> tables_;  // one per bin
    HiddenByNumber hidden_;
    SunsByNumber suns_;
};

}  // namespace noonmark
