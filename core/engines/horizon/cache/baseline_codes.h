#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/horizon/geometry/horizon_code.h"
#include "core/engines/horizon/geometry/receiver_blocks.h"

namespace noonmark {

/// Horizons of one azimuth in some blocks as they were without the buildings that came last: when these go or
/// move, nothing is to be found again there. A page is a block's codes, one a cell, row by row.
class BaselineCodes {
public:
    static constexpr HorizonCode unknown = noHorizon;  ///< of lowest(): nothing is lower

    /// The page of a block; null: there is none.
    [[nodiscard]] HorizonCode* page(std::size_t block) {
        return block < pageOf_.size() && pageOf_[block] >= 0 ? codes_.data() + start(pageOf_[block])
                                                             : nullptr;
    }
    /// Blocks with pages.
    [[nodiscard]] std::span<const std::uint32_t> blocks() const { return blocks_; }

    /// Makes the page of a block that has none. `blocks`: of the tile.
    HorizonCode* add(std::size_t block, std::size_t blocks);
    void remove(std::size_t block);
    void clear();

    /// No known cell of the block has a lower code without those buildings.
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

    std::vector<std::int32_t> pageOf_;   // one a block; -1: none
    std::vector<std::uint32_t> blocks_;  // of each page
    std::vector<HorizonCode> codes_;
    std::vector<HorizonCode> lowest_;  // one a block
};

}  // namespace noonmark
