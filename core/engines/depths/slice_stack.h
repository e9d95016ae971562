#pragma once

#include <tbb/enumerable_thread_specific.h>
#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <stop_token>
#include <vector>

#include "core/engines/common/run_counter.h"
#include "core/engines/common/sun_interval.h"
#include "core/engines/depths/caster_faces.h"
#include "core/engines/depths/depth_slice.h"

namespace noonmark {

/// Transposes 64 words of 64 bits: bit j of word i becomes bit i of word j. Source of the method: Warren,
/// Hacker's Delight, section 7-3.
inline void transpose(std::array<std::uint64_t, 64>& words) {
    std::uint64_t mask = 0x00000000FFFFFFFFULL;
    for (unsigned width = 32; width != 0; width >>= 1, mask ^= mask << width)
        for (unsigned i = 0; i < 64; i = ((i | width) + 1) & ~width) {
            const std::uint64_t swap = ((words[i] >> width) ^ words[i | width]) & mask;
            words[i] ^= swap << width;
            words[i | width] ^= swap;
        }
}

/// The work done to draw a slice.
struct SliceCost {
    std::uint64_t faces = 0;
    std::uint64_t rows = 0;
};

/// Draws slices; one per thread.
class SliceDrawer {
public:
    /// Clears the slice and draws the depth map of the sun direction with this shear. The result depends only
    /// on the arguments, to the last bit.
    SliceCost draw(const IntervalCasters& casters, const MapFrame& frame, glm::dvec2 shear, CasterSide side,
                   DepthSlice& slice);

private:
    /// A point in the map of this step.
    struct Seen {
        glm::dvec3 texel;  ///< MapFrame::homogeneous
        double depth;      ///< w, not divided by q
    };
    void drawFace(const CasterFace& face, CasterSide side, DepthSlice& slice, SliceCost& cost);

    std::vector<Seen> seen_;
    DepthPainter painter_;
};

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
