#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/engines/projected/casters/ring_lines.h"
#include "core/engines/projected/casters/shadow_casters.h"
#include "core/engines/projected/counting/receiver_count.h"
#include "core/engines/projected/filling/bit_raster.h"
#include "core/engines/projected/filling/step_lanes.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Edges [first, end) of a ring, wrapping around, and bounds of their points.
struct EdgeArc {
    std::uint32_t first = 0, end = 0;
    glm::dvec2 low{}, high{};
};

/// The edges of a ring that face away from the sun, and the others; empty: first == end.
struct FarEdges {
    EdgeArc far, near;
    RingEdge chord;  ///< from the end of the far edges to their beginning
};

/// A caster's ring: counter-clockwise, in cells.
struct CasterRing {
    std::span<const glm::dvec2> points;
    std::span<const RingEdge> edges;
    [[nodiscard]] std::size_t before(std::size_t edge) const { return (edge ? edge : edges.size()) - 1; }
    [[nodiscard]] std::size_t after(std::size_t edge) const {
        return edge + 1 == edges.size() ? 0 : edge + 1;
    }
    /// The edges that face away from the sun at one of the eight steps; without bounds.
    [[nodiscard]] EdgeArc findFar(const StepOffsets& throws, std::size_t step) const;
    [[nodiscard]] FarEdges facingApart(const EdgeArc& far) const;

private:
    [[nodiscard]] bool isFar(std::size_t edge, const StepOffsets& throws, std::size_t step) const;
    void bound(EdgeArc& arc) const;
};

/// The shadow of a wall on the ground begins this far behind the wall, towards the sun, as a height in
/// metres: the rays of a receiver just behind the wall begin inside the building (placeRayOrigin()). No
/// receiver lies in that strip.
inline constexpr double behindWallM = 1e-3;

/// A rectangle of cells.
struct SweptBox {
    glm::dvec2 low, high;
};
/// Bounds of a caster's shadow over all these steps.
SweptBox computeSweptBox(const ShadowCaster& caster, const StepOffsets& throws);

/// Eight steps, and the rasters for their shadows.
struct FillTask {
    const ShadowCasters& casters;
    const StepOffsets& throws;
    BitLayout layout;
    RowBand band;
    std::span<std::uint64_t> rasters;
};

/// Fills the shadows of casters, eight steps of the sun at a time. The edges that face away from the sun
/// change rarely, so they are remembered from call to call. One per thread.
class CasterFill {
public:
    explicit CasterFill(const ShadowCasters& casters);

    /// Fills the shadows of some casters into rasters (convex_fill-inl.h). Cells under standing casters must
    /// already be set, or are not needed. Returns the number of rows visited. Cost: 50 ns per caster, and up
    /// to 10 ns per row. The same bits on every instruction set.
    std::uint64_t fill(std::span<const std::uint32_t> casters, const StepOffsets& throws,
                       const BitLayout& layout, const RowBand& band, std::span<std::uint64_t> rasters);

private:
    const ShadowCasters& casters_;
    std::vector<FarEdges> far_;  // result of the last call, per caster
};

// Filling of shadow polygons into bit rasters. step_lanes.h defines the data of eight consecutive steps, one
// lane each, and step_registers-inl.h the same in registers. bit_raster.h is the raster's layout.
// convex_fill-inl.h fills a convex shape at eight steps, depth_slice.h a single convex polygon. CasterFill
// fills casters, BuildingFill one building at a time for the cache, and StepFiller all casters of a window.

/// The work done by filling, and the work skipped.
struct FillCount {
    std::uint64_t rows = 0;        ///< rows visited, for eight steps each
    std::uint64_t outOfReach = 0;  ///< casters x steps whose shadow meets no receiver of a window
    FillCount& operator+=(const FillCount& other);
};

/// Fills the rasters of the sun's steps over a window of a grid. One per thread.
class StepFiller {
public:
    StepFiller(const ShadowCasters& casters, const ReceiverCount& where, const Receivers& receivers,
               const SunSteps& sun, const FillWindow& window);

    /// Overwrites `rasters` with those of eight steps from `first` on (convex_fill-inl.h). After the period
    /// they repeat its last step. Cells that are not receivers are set from the start, so that shadows that
    /// fall only on them need not be filled. Fastest with steps in time order.
    void fill(std::size_t first, std::span<std::uint64_t> rasters);

    [[nodiscard]] const BitLayout& layout() const { return layout_; }  ///< of the window
    [[nodiscard]] std::span<const std::uint64_t> noReceivers() const { return noReceivers_; }
    [[nodiscard]] const FillCount& count() const { return count_; }

private:
    using Indices = std::vector<std::uint32_t>;
    void reach(const StepOffsets& throws, const Indices& among, Indices& inReach) const;

    const ShadowCasters& casters_;
    const ReceiverCount& where_;
    const SunSteps& sun_;
    RowBand band_;
    BitLayout layout_;
    double cellM_;
    std::vector<std::uint64_t> noReceivers_;  // raster
    CasterFill caster_;
    Indices everInReach_, inReach_;  // casters in reach at any step; at the current eight
    FillCount count_;
};

/// Divides a grid into windows whose rasters stay in the first-level cache, with several per core: bands of
/// all its columns or, where receivers lie far apart, only the columns of a band that hold some.
std::vector<FillWindow> windowsOf(const Receivers& receivers);

/// A rectangle of raster words: word columns [west, east), rows [south, north).
struct WordBox {
    int west = 0, east = 0, south = 0, north = 0;
    [[nodiscard]] bool empty() const { return west >= east || south >= north; }
    [[nodiscard]] WordBox with(const WordBox& other) const;
};

/// Fills the shadows of buildings one at a time over some rows of a grid, each into an empty raster, without
/// regard to receivers. One per thread.
class BuildingFill {
public:
    /// `period`: the offsets of all steps to come.
    BuildingFill(const BuildingCasters& buildings, const BitLayout& layout, const RowBand& band,
                 const StepOffsets& period);

    /// Fills the shadow at eight steps and returns the words that may contain it. The raster must be clear.
    /// For an index beyond the last building: nothing.
    WordBox fill(std::size_t building, const StepOffsets& throws);
    void clear(const WordBox& box);

    /// Whether the building's shadow reaches these rows during the period.
    [[nodiscard]] bool reaches(std::size_t building) const {
        return building < reaches_.size() && reaches_[building];
    }

    /// The words of a column of 64 cells, row by row.
    [[nodiscard]] const StepWords* column(int words) const {
        return &raster_[std::size_t(words) * std::size_t(layout_.rows)];
    }

private:
    [[nodiscard]] WordBox computeBox(std::size_t building, const StepOffsets& throws) const;

    const BuildingCasters& buildings_;
    BitLayout layout_;
    RowBand band_;
    CasterFill caster_;
    std::vector<bool> reaches_;
    std::vector<StepWords> raster_;
};

}  // namespace noonmark
