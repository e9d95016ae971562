#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/measures/step_counts_hwy.cpp"
#include <hwy/foreach_target.h>

#include "core/measures/places/place_sums.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {

StepCounts countStep(std::span<const std::uint64_t> baseline, std::span<const std::uint64_t> scenario) {
    const hn::ScalableTag<std::uint64_t> d;
    const std::size_t lanes = hn::Lanes(d), whole = baseline.size() / lanes * lanes;
    auto before = hn::Zero(d), after = hn::Zero(d), added = hn::Zero(d);
    for (std::size_t i = 0; i < whole; i += lanes) {
        const auto was = hn::LoadU(d, baseline.data() + i), is = hn::LoadU(d, scenario.data() + i);
        before = hn::Add(before, hn::PopulationCount(was));
        after = hn::Add(after, hn::PopulationCount(is));
        added = hn::Add(added, hn::PopulationCount(hn::AndNot(was, is)));
    }
    const auto sum = [&](auto lanesOf)
                         HWY_ATTR { return std::size_t(hn::GetLane(hn::SumOfLanes(d, lanesOf))); };
    StepCounts counts{sum(before), sum(after), sum(added)};
    for (std::size_t i = whole; i < baseline.size(); ++i) {
        counts.baseline += hwy::PopCount(baseline[i]);
        counts.scenario += hwy::PopCount(scenario[i]);
        counts.incremental += hwy::PopCount(scenario[i] & ~baseline[i]);
    }
    return counts;
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

NOONMARK_KERNEL(countStep);
StepCounts countStep(std::span<const std::uint64_t> baseline, std::span<const std::uint64_t> scenario) {
    return NOONMARK_CALL(countStep)(baseline, scenario);
}

}  // namespace noonmark
#endif
