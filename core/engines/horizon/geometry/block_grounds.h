#pragma once

#include <vector>

#include "core/engines/horizon/geometry/receiver_blocks.h"
#include "core/simd/simd_lanes.h"

namespace noonmark {

/// How high the cells of a block lie.
struct BlockGround {
    const Line<float>* linesM = nullptr;  ///< above the datum, line by line, 16 each; null: all lie on it
    float lowestM = 0;                    ///< of the receivers
};

/// The elevations of a tile's receivers, in the order of its blocks' lines; nothing where they are flat. They
/// are those of the reference's rays, a millimetre above the ground: both see their own ground alike.
class BlockGrounds {
public:
    BlockGrounds() = default;  ///< flat
    /// 2 kB a block.
    BlockGrounds(const Receivers& receivers, const ReceiverBlocks& blocks, double datumM);

    [[nodiscard]] bool flat() const { return rows_.empty(); }
    [[nodiscard]] BlockGround of(std::size_t block, bool swapped) const;

private:
    std::vector<Line<float>> rows_, columns_;  // side a block
    std::vector<float> lowestM_;               // of each block
};

}  // namespace noonmark
