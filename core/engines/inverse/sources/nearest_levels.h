#pragma once

#include <cstdint>
#include <span>

#include "core/engines/inverse/lane_sources.h"

namespace noonmark {

/// A block's levels in memory; those of one major position are contiguous.
struct BlockLevels {
    CacheLine<float>* heightM;
    CacheLine<std::uint32_t>* building;
    int count;
};

/// The nearest few occluders of each position in a block of lanes, each building once.
class NearestLevels {
public:
    /// Writes to block `into` of `sources`, which starts out empty.
    NearestLevels(LaneSources& sources, int into);

    /// Lanes [first, end) of a block at one major position; 0 <= first < end <= 16.
    struct Span {
        int major = 0;
        int first = 0;
        int end = 0;
        float heightM = 0;  ///< height of the occluding point above the ground, at lane 0
    };
    /// Values shared by the spans of one facet.
    struct Facet {
        float perLaneM = 0;  ///< change of height from lane to lane
        float nearestM = 0;  ///< smaller heights are ignored
        std::uint32_t building = 0;
    };
    /// Keeps, for each position, the lowest height of each building and the buildings with the lowest
    /// heights.
    void add(std::span<const Span> spans, const Facet& facet);

    /// Converts the block to the form of LaneSources; call once, at the end.
    void finish();

private:
    [[nodiscard]] BlockLevels levels() const;
    LaneSources& sources_;
    std::size_t firstLine_, lines_;
};

}  // namespace noonmark
