#include "core/engines/accrual/slice_stack.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/engines/accrual/mask_transpose.h"

namespace noonmark {

namespace {
// A fifth of an hour. Groups are not smaller, because all threads wait for the slowest slice of each group.
constexpr int watchedSlices = 12;
}  // namespace

SliceStack::SliceStack(int columns, int rows)
    : workspaces_([columns, rows] {
          return Workspace{DepthSlice(columns, rows), {}, {}};
      }) {}

void SliceStack::shade(const IntervalCasters& casters, const MapFrame& frame, const SunInterval& interval,
                       CasterSide side, const LookUpStep& lookUp, std::span<ShadowMask> masks,
                       const std::stop_token& stop, const MaskWatcher* watcher) {
    const std::size_t words = (masks.size() + 63) / 64;
    shaded_.resize(std::size_t(interval.steps) * words);
    const int atOnce = watcher ? watchedSlices : interval.steps;
    for (int first = 0; first < interval.steps; first += atOnce) {
        const int end = std::min(first + atOnce, interval.steps);
        tbb::parallel_for(tbb::blocked_range<int>(first, end, 1), [&](const auto& range) {
            Workspace& workspace = workspaces_.local();
            for (int step = range.begin(); step < range.end() && !stop.stop_requested(); ++step) {
                const SliceCost cost = workspace.drawer.draw(casters, frame, frame.shearOf(interval.at(step)),
                                                             side, workspace.slice);
                workspace.cost.faces += cost.faces;
                workspace.cost.rows += cost.rows;
                lookUp(workspace.slice, step, std::span(shaded_).subspan(std::size_t(step) * words, words));
            }
        });
        if (stop.stop_requested()) return;
        const bool shown = end < interval.steps && watcher && watcher->wants();
        if (shown || end == interval.steps) takeMasks(end, words, masks);
        if (shown) watcher->show(end);
    }
}

SliceCost SliceStack::cost() const {
    SliceCost sum;
    for (const Workspace& workspace : workspaces_) {
        sum.faces += workspace.cost.faces;
        sum.rows += workspace.cost.rows;
    }
    return sum;
}

void SliceStack::takeMasks(int steps, std::size_t words, std::span<ShadowMask> masks) const {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, words, 256), [&](const auto& range) {
        for (std::size_t word = range.begin(); word < range.end(); ++word) {
            std::array<std::uint64_t, 64> bits{};
            for (std::size_t step = 0; step < std::size_t(steps); ++step)
                bits[step] = shaded_[step * words + word];
            transpose(bits);
            const auto here = masks.subspan(word * 64, std::min<std::size_t>(64, masks.size() - word * 64));
            std::copy_n(bits.begin(), here.size(), here.begin());
        }
    });
}

}  // namespace noonmark
