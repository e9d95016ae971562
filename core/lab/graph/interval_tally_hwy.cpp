#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/lab/graph/interval_tally_hwy.cpp"
#include <hwy/foreach_target.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/lab/graph/interval_tally.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {

// Without vectors: the later sets count bits with one instruction.
HWY_FLATTEN void measureMasks(const ShadowMask* masks, std::size_t count, int steps, MaskRuns* runs) {
    for (std::size_t i = 0; i < count; ++i) runs[i] = measureRuns(masks[i], steps);
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

namespace {

template <class Body>
void forReceivers(std::size_t count, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, 8192), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) body(i);
    });
}

// A run that crosses from one leg to the next is the suffix of one and the prefix of the other.
std::uint32_t longestAlong(const std::vector<PathLeg>& legs, std::size_t i) {
    std::uint32_t longest = 0;
    std::uint32_t run = 0;
    for (const PathLeg& leg : legs) {
        const MaskRuns runs = leg.runs[i];
        if (leg.breaksRun) run = 0;
        longest = std::max({longest, std::uint32_t(runs.longest), run + runs.prefix});
        run = runs.suffix == leg.steps ? run + runs.suffix : runs.suffix;
    }
    return longest;
}

}  // namespace

NOONMARK_KERNEL(measureMasks);
std::vector<MaskRuns> IntervalTally::addEdge(std::span<const ShadowMask> masks,
                                             const DirectionGraph::Edge& edge) {
    std::vector<MaskRuns> runs(masks.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, masks.size(), 8192), [&](const auto& range) {
        NOONMARK_CALL(measureMasks)
        (&masks[range.begin()], range.size(), edge.sun.steps, &runs[range.begin()]);
        for (std::size_t i = range.begin(); i < range.end(); ++i)
            gross_[i] += std::uint64_t(runs[i].gross) * edge.weight;
    });
    intervals_ += edge.weight;
    steps_ += std::uint64_t(edge.weight) * std::uint64_t(edge.sun.steps);
    return runs;
}

void IntervalTally::addPath(const std::vector<PathLeg>& legs) {
    forReceivers(longest_.size(),
                 [&](std::size_t i) { longest_[i] = std::max(longest_[i], longestAlong(legs, i)); });
}

void IntervalTally::writeTo(ShadowField& field, const Receivers& receivers,
                            const std::vector<PathLeg>& legs) const {
    forReceivers(gross_.size(), [&](std::size_t i) {
        const std::uint32_t cell = receivers.cells[i];
        const std::uint32_t longest = std::max(longest_[i], longestAlong(legs, i));
        field.grossMin[cell] = float(double(gross_[i]) * field.stepMinutes / field.days);
        field.continuousMin[cell] = float(double(longest) * field.stepMinutes);
    });
}

}  // namespace noonmark
#endif
