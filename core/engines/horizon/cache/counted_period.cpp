#include "core/engines/horizon/cache/counted_period.h"

#include <tbb/parallel_for.h>

#include <utility>

namespace noonmark {

CountedPeriod::CountedPeriod(const SunSteps& sun, double binDeg)
    : binned_(binSun(sun, binDeg, BinDirection::middle)), steps_(makeTimedSteps(sun, binned_)) {}

const RunCount& CountedPeriod::runs() {
    if (!runs_) runs_.emplace(std::exchange(steps_, {}));
    return *runs_;
}

const HiddenByNumber& CountedPeriod::hidden(std::size_t bins) {
    if (!hidden_.empty()) return hidden_;
    tables_.resize(binned_.bins.size());
    tbb::parallel_for(std::size_t{0}, tables_.size(),
                      [&](std::size_t i) { tables_[i].emplace(binned_.bins[i].suns); });
    hidden_.resize(bins, nullptr);
    for (std::size_t i = 0; i < tables_.size(); ++i) hidden_[binned_.bins[i].number] = &*tables_[i];
    return hidden_;
}

const SunsByNumber& CountedPeriod::suns(std::size_t bins) {
    if (!suns_.empty()) return suns_;
    suns_.resize(bins);
    tbb::parallel_for(std::size_t{0}, binned_.bins.size(), [&](std::size_t i) {
        suns_[binned_.bins[i].number] = findSunChanges(binned_.bins[i].suns, {});
    });
    return suns_;
}

}  // namespace noonmark
