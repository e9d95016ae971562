#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/engines/accrual/slice_drawer.h"
#include "core/engines/common/interval_engine.h"
#include "core/engines/common/shadow_mask.h"

namespace noonmark {

/// Computes the shadow of all receivers at a step: bit i % 64 of word i / 64 is set if receiver i is in
/// shadow. Called on several threads at the same time.
using LookUpStep = std::function<void(const DepthSlice& slice, int step, std::span<std::uint64_t> shaded)>;

/// Draws the slices of an interval in parallel on all cores and looks up each as soon as it is drawn. Only
/// one slice per thread is in memory, whatever their number.
class SliceStack {
public:
    SliceStack(int columns, int rows);

    /// Sets masks[i] to the shadow of receiver i. Incomplete after a stop request. With a watcher, draws a
    /// few slices at a time. Throws std::bad_alloc.
    void shade(const IntervalCasters& casters, const MapFrame& frame, const SunInterval& interval,
               CasterSide side, const LookUpStep& lookUp, std::span<ShadowMask> masks,
               const std::stop_token& stop, const MaskWatcher* watcher = nullptr);

    /// Faces drawn and rows filled by all slices so far.
    [[nodiscard]] SliceCost cost() const;

private:
    /// Per-thread memory.
    struct Workspace {
        DepthSlice slice;
        SliceDrawer drawer;
        SliceCost cost;
    };
    void takeMasks(int steps, std::size_t words, std::span<ShadowMask> masks) const;

    tbb::enumerable_thread_specific<Workspace> workspaces_;
    std::vector<std::uint64_t> shaded_;  // steps x words
};

}  // namespace noonmark
