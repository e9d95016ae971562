#pragma once

#include <cstdint>
#include <span>

#include "core/engines/inverse/lane_sources.h"

namespace noonmark {

/// The nearest few occluders of each place in a block of lanes, each building once.
class NearestLevels {
public:
    /// Works in block `into` of `sources`, of which nothing is known yet.
    NearestLevels(LaneSources& sources, int into);

    /// Lanes [first, end) of a block at one major position; 0 <= first < end <= 16.
    struct Span {
        int major = 0;
        int first = 0;
        int end = 0;
        float heightM = 0;  ///< of the occluding point above the ground, at lane 0
    };
    /// What the spans of one facet have in common.
    struct Facet {
        float perLaneM = 0;  ///< what a lane adds to the height
        float nearestM = 0;  ///< heights below this are left out
        std::uint32_t building = 0;
    };
    /// Keeps, place by place, the lowest of each building and the lowest buildings of all.
    void add(std::span<const Span> spans, const Facet& facet);

    /// To be called once, at the end: the block becomes as LaneSources has it.
    void finish();

private:
    LaneSources& sources_;
    std::size_t firstLine_, lines_;
};

}  // namespace noonmark
