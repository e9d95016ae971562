#include "core/accumulate/horizon/bin_edit.h"

#include <algorithm>

namespace noonmark {

namespace {

constexpr int side = ReceiverBlocks::side;

bool any(const ReceiverBlocks::Masks& masks) {
    return std::ranges::any_of(masks, [](std::uint16_t mask) { return mask != 0; });
}

bool has(const ReceiverBlocks::Masks& masks, std::uint8_t place) {
    return (masks[std::size_t(place / side)] >> unsigned(place % side) & 1U) != 0;
}

void add(ReceiverBlocks::Masks& masks, std::uint8_t place) {
    masks[std::size_t(place / side)] |= std::uint16_t(1U << unsigned(place % side));
}

ShadowExtent extentOf(const ReceiverBlocks::Block& block, const ShadowAxes& axes, ShadowExtent extent) {
    const glm::dvec2 low(block.column, block.row);
    extent.addBox(axes, low - 1.0, low + double(side));
    return extent;
}

}  // namespace

void BinEdit::run(const TileEdit& edit, glm::dvec2 away, HorizonCode lowest, std::span<HorizonCode> codes,
                  const OnChange& changed) {
    const ShadowAxes axes(away);
    const ShadowExtent tile = noonmark::extentOf(edit.blocks.box(), axes);
    const WallList& list = edit.walls.list();
    removed_.begin(list, edit.change.removed, axes, tile, lowest, edit.cellM);
    added_.begin(list, edit.change.added, axes, tile, lowest, edit.cellM);
    findBlocks(edit, axes);
    findLost(edit, axes, codes);
    if (!lost_.empty()) findAgain(edit, axes, lowest, codes, changed);
    raise(edit, axes, codes, changed);
}

// The squares of each line across that the prisms' bands of q meet.
void BinEdit::findBlocks(const TileEdit& edit, const ShadowAxes& axes) {
    ShadowExtent extent;
    for (const auto* prisms : {&edit.change.removed, &edit.change.added})
        for (const StandingPrism& prism : *prisms) extent.addBox(axes, prism.low, prism.high);
    blocks_ = edit.newBlocks;
    const TileBox& box = edit.blocks.box();
    const glm::ivec2 squares = edit.blocks.squares();
    const int alongs = axes.swapped ? squares.x : squares.y, acrosses = axes.swapped ? squares.y : squares.x;
    for (int line = 0; line < alongs && extent.lowQ <= extent.highQ; ++line) {
        const int from = axes.swapped ? box.firstColumn : box.firstRow,
                  other = axes.swapped ? box.firstRow : box.firstColumn;
        const double a = axes.k * axes.sign * (from + line * side), b = a + axes.k * axes.sign * side;
        const double low = extent.lowQ + std::min(a, b) - other - 1,
                     high = extent.highQ + std::max(a, b) - other + 1;
        const int first = int(std::clamp(std::floor(low / side), 0.0, double(acrosses))),
                  end = int(std::clamp(std::floor(high / side) + 1, 0.0, double(acrosses)));
        for (int i = first; i < end; ++i)
            if (const int block = axes.swapped ? edit.blocks.blockAt(line, i) : edit.blocks.blockAt(i, line);
                block >= 0)
                blocks_.push_back(std::size_t(block));
    }
    std::ranges::sort(blocks_);
    blocks_.erase(std::unique(blocks_.begin(), blocks_.end()), blocks_.end());
}

void BinEdit::findLost(const TileEdit& edit, const ShadowAxes& axes, std::span<const HorizonCode> codes) {
    lost_.clear();
    for (const std::size_t i : blocks_) {
        const ReceiverBlocks::Block& block = edit.blocks.blocks()[i];
        Lost lost{i, axes.swapped ? edit.newColumns[i] : edit.newRows[i]};
        const std::uint8_t* places = edit.blocks.places(block, axes.swapped);
        const HorizonCode* of = codes.data() + block.first;
        if (const HorizonCode* gone = removed_.codes(block, edit.blocks.masks(i, axes.swapped)))
            for (std::uint32_t n = 0; n < block.count; ++n)
                if (const HorizonCode code = gone[places[n]]; code > noHorizon && code == of[n])
                    add(lost.masks, places[n]);
        if (any(lost.masks)) lost_.push_back(lost);
    }
}

void BinEdit::findAgain(const TileEdit& edit, const ShadowAxes& axes, HorizonCode lowest,
                        std::span<HorizonCode> codes, const OnChange& changed) {
    ShadowExtent extent;
    for (const Lost& lost : lost_) extent = extentOf(edit.blocks.blocks()[lost.block], axes, extent);
    edit.walls.across(axes, extent, prisms_);
    all_.begin(edit.walls.list(), prisms_, axes, extent, lowest, edit.cellM);
    for (const Lost& lost : lost_) {
        const ReceiverBlocks::Block& block = edit.blocks.blocks()[lost.block];
        const std::uint8_t* places = edit.blocks.places(block, axes.swapped);
        const HorizonCode* square = all_.codes(block, lost.masks);
        for (std::uint32_t n = 0; n < block.count; ++n) {
            if (!has(lost.masks, places[n])) continue;
            const HorizonCode before = codes[block.first + n],
                              after = square == nullptr ? noHorizon : square[places[n]];
            codes[block.first + n] = after;
            if (before != after) changed(block.first + n, before, after);
        }
    }
}

void BinEdit::raise(const TileEdit& edit, const ShadowAxes& axes, std::span<HorizonCode> codes,
                    const OnChange& changed) {
    for (const std::size_t i : blocks_) {
        const ReceiverBlocks::Block& block = edit.blocks.blocks()[i];
        const HorizonCode* square = added_.codes(block, edit.blocks.masks(i, axes.swapped));
        if (square == nullptr) continue;
        const std::uint8_t* places = edit.blocks.places(block, axes.swapped);
        for (std::uint32_t n = 0; n < block.count; ++n) {
            const HorizonCode before = codes[block.first + n], after = square[places[n]];
            if (after <= before) continue;
            codes[block.first + n] = after;
            changed(block.first + n, before, after);
        }
    }
}

}  // namespace noonmark
