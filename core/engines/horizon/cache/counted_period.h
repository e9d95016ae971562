#pragma once

#include <optional>
#include <vector>

#include "core/engines/horizon/counting/period_count.h"
#include "core/engines/horizon/counting/sun_change.h"

namespace noonmark {

/// A period's bins by number: null or none where it does not visit the bin.
using HiddenByNumber = std::vector<const HiddenSuns*>;
using SunsByNumber = std::vector<std::vector<SunChange>>;  ///< from none

/// A period as kept horizons count it. What not every count needs is made when it is first asked for. Not for
/// several threads at a time.
class CountedPeriod {
public:
    CountedPeriod(const SunSteps& sun, double binDeg);

    [[nodiscard]] const BinnedSun& binned() const { return binned_; }
    /// O(steps) the first time.
    const RunCount& runs();
    /// The same twice, to look up one or a row. `bins`: numbers that there may be. Some 0.05 ms a bin the
    /// first time.
    const HiddenByNumber& hidden(std::size_t bins);
    const SunsByNumber& suns(std::size_t bins);

private:
    BinnedSun binned_;
    std::vector<TimedStep> steps_;  // empty once runs_ is there
    std::vector<DaySteps> days_;
    std::optional<RunCount> runs_;
    std::vector<std::optional<HiddenSuns>> tables_;  // one a bin
    HiddenByNumber hidden_;
    SunsByNumber suns_;
};

}  // namespace noonmark
