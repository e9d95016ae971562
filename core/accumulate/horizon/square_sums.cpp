#include "core/accumulate/horizon/square_sums.h"

namespace noonmark {

namespace {
constexpr std::size_t cells = ReceiverBlocks::cells;
constexpr Stretch wholeSquare{0, cells};
}  // namespace

void SquareSums::begin(std::size_t squares) {
    squares_ = squares;
    short_.reset();
    rows_.clear();
    columns_.clear();
}

void SquareSums::add(std::size_t square, bool swapped, const HorizonCode* codes,
                     std::span<const SunChange> suns) {
    if (codes == nullptr) return;
    if (!short_ || square != at_ || swapped != atSwapped_) moveTo(square, swapped);
    for (const SunChange& change : suns) short_->add(change, codes);
}

void SquareSums::add(std::size_t square, std::size_t cell, std::uint32_t steps) {
    if (rows_.empty()) rows_.assign(squares_ * cells, 0);
    rows_[square * cells + cell] += steps;
}

void SquareSums::moveTo(std::size_t square, bool swapped) {
    if (short_) short_->flush();
    std::vector<std::uint32_t>& all = swapped ? columns_ : rows_;
    if (all.empty()) all.assign(squares_ * cells, 0);
    short_.emplace(0, std::span(&wholeSquare, 1), all.data() + square * cells);
    at_ = square;
    atSwapped_ = swapped;
}

void SquareSums::addTo(const ReceiverBlocks& blocks, std::span<std::uint32_t> steps) {
    if (short_) short_->flush();
    for (std::size_t square = 0; square < blocks.blocks().size(); ++square) {
        const ReceiverBlocks::Block& block = blocks.blocks()[square];
        for (const bool swapped : {false, true}) {
            const std::vector<std::uint32_t>& all = swapped ? columns_ : rows_;
            const std::uint8_t* places = blocks.places(block, swapped);
            for (std::uint32_t n = 0; n < block.count && !all.empty(); ++n)
                steps[block.first + n] += all[square * cells + places[n]];
        }
    }
}

}  // namespace noonmark
