#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/engines/common/shadow_mask.h"
#include "core/engines/inverse/lanes.h"
#include "core/simd/cache_line.h"

namespace noonmark {

/// The masks of some blocks of lanes, as a target for drawing.
struct LaneMasks {
    int majors = 0;
    std::vector<ShadowMask> masks;  ///< blocks x lanes of a block x majors
    /// Blocks x majors: for each lane the first position from this one on, and the last one up to this one,
    /// whose mask is wanted; majors and -1 if there is none. Masks of unwanted positions are unspecified
    /// after drawing.
    std::vector<CacheLine<std::int32_t>> nextWanted, lastWanted;

    /// Leaves the contents unspecified.
    void resize(int majorCount, int blocks) {
        majors = majorCount;
        masks.resize(std::size_t(blocks) * Lanes::perBlock * std::size_t(majors));
        nextWanted.resize(std::size_t(blocks) * std::size_t(majors));
        lastWanted.resize(nextWanted.size());
    }
    [[nodiscard]] int blocks() const { return int(nextWanted.size()) / majors; }

    /// Sets the wanted positions of a block; wanted(major, lane).
    void ask(int block, const auto& wanted) {
        CacheLine<std::int32_t>*next = &nextWanted[firstLine(block)], *last = &lastWanted[firstLine(block)];
        CacheLine<std::int32_t> seen;
        std::ranges::fill(seen.values, -1);
        for (int major = 0; major < majors; last[major++] = seen)
            for (int lane = 0; lane < Lanes::perBlock; ++lane)
                seen.values[lane] = wanted(major, lane) ? major : seen.values[lane];
        std::ranges::fill(seen.values, majors);
        for (int major = majors - 1; major >= 0; next[major--] = seen)
            for (int lane = 0; lane < Lanes::perBlock; ++lane)
                seen.values[lane] = last[major].values[lane] == major ? major : seen.values[lane];
    }

    /// Index of major position 0 of a block in nextWanted and lastWanted.
    [[nodiscard]] std::size_t firstLine(int block) const { return std::size_t(block) * std::size_t(majors); }
    [[nodiscard]] ShadowMask* lane(int block, int lane) {
        return &masks[std::size_t(block * Lanes::perBlock + lane) * std::size_t(majors)];
    }
    [[nodiscard]] const ShadowMask* lane(int block, int lane) const {
        return &masks[std::size_t(block * Lanes::perBlock + lane) * std::size_t(majors)];
    }
};

}  // namespace noonmark
