#pragma once

#include <cstdint>
#include <vector>

#include "core/engines/inverse/lanes.h"
#include "core/engines/inverse/source_runs.h"
#include "core/simd/cache_line.h"

namespace noonmark {

/// The shadow sources of the cells of some blocks of lanes at one instant: the heights of up to `levels`
/// occluding points on the way to the sun, nearest first, each on a different building (paper, section 5: the
/// slices of the inverse accrual map). A Line holds the lanes of a block at one major position, so a shadow
/// that moves along a lane is read from consecutive Lines.
struct LaneSources {
    int levels = 0;
    int majors = 0;
    std::vector<CacheLine<float>>
        heightM;  ///< blocks x majors x levels; above the ground, metres; 0: no occluder
    std::vector<CacheLine<std::uint32_t>> building;  ///< the same shape; `nobody` if there is no occluder
    static constexpr std::uint32_t nobody = ~std::uint32_t{0};

    /// Leaves the contents unspecified.
    void resize(int levelCount, int majorCount, int blocks = 1) {
        levels = levelCount;
        majors = majorCount;
        heightM.resize(std::size_t(blocks) * std::size_t(majors) * std::size_t(levels));
        building.resize(heightM.size());
    }

    [[nodiscard]] std::size_t line(int block, int major, int level = 0) const {
        return (std::size_t(block) * std::size_t(majors) + std::size_t(major)) * std::size_t(levels) +
               std::size_t(level);
    }

    /// `lane`: within its block.
    [[nodiscard]] CellSources of(int block, int major, int lane) const {
        CellSources found;
        for (std::size_t at = line(block, major); found.count < levels; ++found.count, ++at) {
            const float height = heightM[at].values[lane];
            if (height <= 0) break;
            found.heightM[std::size_t(found.count)] = height;
            found.building[std::size_t(found.count)] = building[at].values[lane];
        }
        return found;
    }

    /// Whether the cell is in shadow.
    [[nodiscard]] bool shades(int block, int major, int lane) const {
        return heightM[line(block, major)].values[lane] > 0;
    }
};

static_assert(Lanes::perBlock == sizeof(CacheLine<float>) / sizeof(float));

}  // namespace noonmark
