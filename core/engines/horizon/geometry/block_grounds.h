#pragma once

#include <vector>

#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/simd/cache_line.h"

namespace noonmark {

/// Ground heights of the cells of a block.
struct BlockGround {
    const CacheLine<float>* rowsM =
        nullptr;        ///< above the datum, row by row, 16 each; null: all at the datum
    float lowestM = 0;  ///< lowest of the receivers
};

/// Elevations of a tile's receivers, in the row order of its blocks; empty if they are flat. They are those
/// of the reference's rays, a millimetre above the ground, so that both treat a receiver's own ground alike.
class BlockGrounds {
public:
    BlockGrounds() = default;  ///< flat ground
    /// 2 kB per block.
    BlockGrounds(const Receivers& receivers, const ReceiverBlocks& blocks, double datumM);

    [[nodiscard]] bool flat() const { return rows_.empty(); }
    [[nodiscard]] BlockGround of(std::size_t block, bool swapped) const;

private:
    std::vector<CacheLine<float>> rows_, columns_;  // 16 per block
    std::vector<float> lowestM_;                    // one per block
};

}  // namespace noonmark
