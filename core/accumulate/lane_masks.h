#pragma once

#include <cstdint>
#include <vector>

#include "core/accumulate/horizon/lanes16.h"
#include "core/accumulate/lanes.h"
#include "core/accumulate/shadow_mask.h"

namespace noonmark {

/// The masks of some blocks of lanes, to be drawn into.
struct LaneMasks {
    int majors = 0;
    std::vector<ShadowMask> masks;  ///< blocks x lanes of a block x majors
    /// Blocks x (majors + 1): how many places of each lane before this one are asked for. What a drawer
    /// leaves in the masks of the others is open.
    std::vector<Line<std::int32_t>> wantedBefore;

    /// Nothing is asked for yet.
    void resize(int majorCount, int blocks) {
        majors = majorCount;
        masks.resize(std::size_t(blocks) * Lanes::perBlock * std::size_t(majors));
        wantedBefore.resize(std::size_t(blocks) * std::size_t(majors + 1));
    }

    [[nodiscard]] ShadowMask* lane(int block, int lane) {
        return &masks[std::size_t(block * Lanes::perBlock + lane) * std::size_t(majors)];
    }
    [[nodiscard]] const ShadowMask* lane(int block, int lane) const {
        return &masks[std::size_t(block * Lanes::perBlock + lane) * std::size_t(majors)];
    }
    [[nodiscard]] Line<std::int32_t>* wanted(int block) {
        return &wantedBefore[std::size_t(block) * std::size_t(majors + 1)];
    }
    [[nodiscard]] const Line<std::int32_t>* wanted(int block) const {
        return &wantedBefore[std::size_t(block) * std::size_t(majors + 1)];
    }
};

}  // namespace noonmark
