#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/horizon/counting/walk_steps_hwy.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>

#include "core/engines/horizon/counting/walk_steps.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {
namespace {

using Horizons = std::span<const RunLanes>;
using D = LanesUpTo<std::int16_t, lanesPerPart>;
using V = hn::Vec<D>;
constexpr D d;
constexpr std::size_t lanes = hn::MaxLanes(d);

/// Number of vectors that are walked together, as many as leave registers for their runs and longest runs.
constexpr std::size_t together = std::min<std::size_t>(4, lanesPerPart / lanes);

HWY_INLINE HorizonCode codeOf(const TimedStep& step) { return step.place.sun; }
HWY_INLINE HorizonCode codeOf(const SpanStep& step) { return step.sun; }

/// Runs of some neighbouring lanes.
struct Runs {
    V run[together], longest[together];
};

/// The horizons of 64 lanes at a step.
struct BelowHorizon {
    const HorizonCode* codes;
    HWY_INLINE auto hide(V sun, std::size_t at) const { return hn::Gt(hn::Load(d, codes + at), sun); }
};
struct OutsideSpan {
    SpanLanes span;
    HWY_INLINE auto hide(V sun, std::size_t at) const {
        return hn::Or(hn::Gt(hn::Load(d, span.below + at), sun), hn::Gt(sun, hn::Load(d, span.above + at)));
    }
};

// `lanesOf`: what hides suns from a step's 64 lanes.
template <class Step, class LanesOf>
HWY_INLINE void walkSome(std::span<const Step> steps, const LanesOf& lanesOf, std::size_t first,
                         std::int16_t* longest) {
    const V one = hn::Set(d, 1);
    Runs runs;
    HWY_UNROLL(4)
    for (std::size_t i = 0; i < together; ++i) {
        runs.run[i] = hn::Zero(d);
        runs.longest[i] = hn::Load(d, longest + first + i * lanes);
    }
    for (const Step& step : steps) {
        const auto of = lanesOf(step);
        const V sun = hn::Set(d, codeOf(step));
        HWY_UNROLL(4)
        for (std::size_t i = 0; i < together; ++i) {
            if (step.startsRun) runs.run[i] = hn::Zero(d);
            const auto hidden = of.hide(sun, first + i * lanes);
            runs.run[i] = hn::IfThenElseZero(hidden, hn::Add(runs.run[i], one));
            runs.longest[i] = hn::Max(runs.longest[i], runs.run[i]);
        }
    }
    HWY_UNROLL(4)
    for (std::size_t i = 0; i < together; ++i) hn::Store(runs.longest[i], d, longest + first + i * lanes);
}

}  // namespace

void walkSteps(Horizons horizons, std::span<const TimedStep> steps, RunLanes& longest) {
    const auto lanesOf = [&](const TimedStep& step) { return BelowHorizon{horizons[step.place.bin].values}; };
    for (std::size_t first = 0; first < lanesPerPart; first += together * lanes)
        walkSome(steps, lanesOf, first, longest.values);
}

void walkSpans(std::span<const SpanLanes> spans, std::span<const SpanStep> steps, RunLanes& longest) {
    const auto lanesOf = [&](const SpanStep& step) { return OutsideSpan{spans[step.span]}; };
    for (std::size_t first = 0; first < lanesPerPart; first += together * lanes)
        walkSome(steps, lanesOf, first, longest.values);
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

std::vector<TimedStep> makeTimedSteps(const SunSteps& sun, const BinnedSun& binned) {
    std::vector<TimedStep> steps(sun.steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i)
        steps[i] = {binned.places[i], i == 0 || sun.steps[i].slot != sun.steps[i - 1].slot + 1};
    for (const SunDay& day : sun.days)
        if (day.count > 0) steps[day.first].startsRun = true;
    return steps;
}

std::vector<DaySteps> findDays(std::span<const TimedStep> steps) {
    std::vector<DaySteps> days;
    for (std::uint32_t step = 0; step < steps.size(); ++step) {
        if (steps[step].startsRun) days.push_back({step, step});
        days.back().end = step + 1;
    }
    return days;
}

NOONMARK_KERNEL(walkSteps);
void walkSteps(std::span<const RunLanes> horizons, std::span<const TimedStep> steps, RunLanes& longest) {
    NOONMARK_CALL(walkSteps)(horizons, steps, longest);
}

NOONMARK_KERNEL(walkSpans);
void walkSpans(std::span<const SpanLanes> spans, std::span<const SpanStep> steps, RunLanes& longest) {
    NOONMARK_CALL(walkSpans)(spans, steps, longest);
}

}  // namespace noonmark
#endif
