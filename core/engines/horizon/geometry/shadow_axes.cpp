#include "core/engines/horizon/geometry/shadow_axes.h"

#include <limits>

#include "core/engines/ray/ray_reference.h"

namespace noonmark {

namespace {
constexpr std::size_t blockSide = ReceiverBlocks::side;
static_assert(sizeof(CacheLine<float>) == blockSide * sizeof(float));
}  // namespace

BlockGrounds::BlockGrounds(const Receivers& receivers, const ReceiverBlocks& blocks, double datumM) {
    if (receivers.flat()) return;
    rows_.resize(blocks.blocks().size() * blockSide);
    columns_.resize(rows_.size());
    lowestM_.assign(blocks.blocks().size(), std::numeric_limits<float>::max());
    for (std::size_t i = 0; i < blocks.blocks().size(); ++i) {
        const ReceiverBlocks::Block& block = blocks.blocks()[i];
        const std::uint8_t* places = blocks.places(block, false);
        for (std::uint32_t n = 0; n < block.count; ++n) {
            const std::uint32_t cell = blocks.cell(block.first + n);
            if (cell == ReceiverBlocks::padding) continue;
            const auto heightM = float(double(placeRayOrigin(receivers.position(cell)).z) - datumM);
            const std::size_t row = places[n] / blockSide, column = places[n] % blockSide;
            rows_[i * blockSide + row].values[column] = columns_[i * blockSide + column].values[row] =
                heightM;
            lowestM_[i] = std::min(lowestM_[i], heightM);
        }
    }
}

BlockGround BlockGrounds::of(std::size_t block, bool swapped) const {
    if (rows_.empty()) return {};
    return {(swapped ? columns_ : rows_).data() + block * blockSide, lowestM_[block]};
}

}  // namespace noonmark
