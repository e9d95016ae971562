#include "core/engines/horizon/counting/short_sums.h"

namespace noonmark {

namespace {
constexpr std::size_t cells = ReceiverBlocks::cells;
constexpr NumberRange wholeBlock{0, cells};
}  // namespace

void BlockSums::begin(std::size_t blockCount) {
    blockCount_ = blockCount;
    short_.reset();
    rows_.clear();
    columns_.clear();
}

void BlockSums::add(std::size_t blockIndex, bool swapped, const HorizonCode* codes,
                    std::span<const CountChange> suns) {
    if (codes == nullptr) return;
    if (!short_ || blockIndex != at_ || swapped != atSwapped_) moveTo(blockIndex, swapped);
    for (const CountChange& change : suns) short_->add(change, codes);
}

void BlockSums::add(std::size_t blockIndex, std::size_t cell, std::uint32_t steps) {
    if (rows_.empty()) rows_.assign(blockCount_ * cells, 0);
    rows_[blockIndex * cells + cell] += steps;
}

void BlockSums::moveTo(std::size_t blockIndex, bool swapped) {
    if (short_) short_->flush();
    std::vector<std::uint32_t>& all = swapped ? columns_ : rows_;
    if (all.empty()) all.assign(blockCount_ * cells, 0);
    short_.emplace(0, std::span(&wholeBlock, 1), all.data() + blockIndex * cells);
    at_ = blockIndex;
    atSwapped_ = swapped;
}

void BlockSums::addTo(const ReceiverBlocks& blocks, std::span<std::uint32_t> steps) {
    if (short_) short_->flush();
    for (std::size_t blockIndex = 0; blockIndex < blocks.blocks().size(); ++blockIndex) {
        const ReceiverBlocks::Block& block = blocks.blocks()[blockIndex];
        for (const bool swapped : {false, true}) {
            const std::vector<std::uint32_t>& all = swapped ? columns_ : rows_;
            const std::uint8_t* places = blocks.places(block, swapped);
            for (std::uint32_t n = 0; n < block.count && !all.empty(); ++n)
                steps[block.first + n] += all[blockIndex * cells + places[n]];
        }
    }
}

}  // namespace noonmark
