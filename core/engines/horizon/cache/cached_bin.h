#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/engines/horizon/overhangs/overhang_intervals.h"

namespace noonmark {

/// Horizons of one azimuth in some blocks as they were without the buildings added by the last change. If
/// these buildings are removed or moved, no horizon in the blocks has to be recomputed. Each block has a page
/// with one code per cell, row by row.
class BaselineCodes {
public:
    static constexpr HorizonCode unknown = noHorizon;  ///< value of lowest(); no code is lower

    /// The page of a block; null if it has none.
    [[nodiscard]] HorizonCode* page(std::size_t block) {
        return block < pageOf_.size() && pageOf_[block] >= 0 ? codes_.data() + start(pageOf_[block])
                                                             : nullptr;
    }
    /// Blocks that have pages.
    [[nodiscard]] std::span<const std::uint32_t> blocks() const { return blocks_; }

    /// Creates the page of a block that has none. `blocks`: number of blocks of the tile.
    HorizonCode* add(std::size_t block, std::size_t blocks);
    void remove(std::size_t block);
    void clear();

    /// Lower bound of the codes of the block's known cells without those buildings.
    [[nodiscard]] HorizonCode lowest(std::size_t block) const {
        return block < lowest_.size() ? lowest_[block] : unknown;
    }
    void setLowest(std::size_t block, std::size_t blocks, HorizonCode lowest);

    [[nodiscard]] std::size_t bytes() const {
        return codes_.capacity() * sizeof(HorizonCode) + pageOf_.capacity() * sizeof(std::int32_t) +
               lowest_.capacity() * sizeof(HorizonCode);
    }

private:
    static std::size_t start(std::int32_t page) { return std::size_t(page) * ReceiverBlocks::cells; }

    std::vector<std::int32_t> pageOf_;   // one per block; -1: none
    std::vector<std::uint32_t> blocks_;  // block of each page
    std::vector<HorizonCode> codes_;
    std::vector<HorizonCode> lowest_;  // one per block
};

/// The cached horizons of a tile at one azimuth, exact for suns above `lowest`. Gaps that end exactly at a
/// sun's level are included, because a gap that begins one level higher adjoins them.
struct CachedBin {
    HorizonCode lowest = 0;
    std::vector<HorizonCode> codes;  ///< of obstacles on the ground, one per number; empty: not cached
    std::vector<Gap> gaps;  ///< gaps of receivers, by number: all overhangs that reach above the horizon
    BaselineCodes base;     ///< where the last change added buildings

    static HorizonCode below(const AzimuthBin& bin) {
        return HorizonCode(std::max(int(noHorizon), int(bin.lowest()) - 1));
    }
    [[nodiscard]] std::size_t bytes() const {
        return codes.capacity() * sizeof(HorizonCode) + gaps.capacity() * sizeof(Gap) + base.bytes();
    }
    [[nodiscard]] bool holds(const AzimuthBin& bin) const { return !codes.empty() && lowest <= below(bin); }
};

}  // namespace noonmark
