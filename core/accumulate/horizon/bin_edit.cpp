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

std::span<const CodeChange> BinEdit::run(const TileEdit& edit, glm::dvec2 away, HorizonCode lowest,
                                         std::span<HorizonCode> codes) {
    const ShadowAxes axes(away);
    const ShadowExtent tile = noonmark::extentOf(edit.blocks.box(), axes);
    const WallList& list = edit.walls.list();
    removed_.begin(list, edit.change.removed.standing(), away, tile, lowest, edit.cellM, edit.stop);
    added_.begin(list, edit.change.added.standing(), away, tile, lowest, edit.cellM, edit.stop);
    findBlocks(edit, axes, lowest);
    lost_.clear();
    changes_.clear();
    for (const std::uint32_t number : edit.cells.newNumbers) codes[number] = noHorizon;
    for (const std::size_t block : blocks_) look(edit, axes, block, codes);
    if (!lost_.empty()) findAgain(edit, away, lowest, codes);
    return changes_;
}

// As far as shadows of what went and came are long.
void BinEdit::findBlocks(const TileEdit& edit, const ShadowAxes& axes, HorizonCode lowest) {
    const double tan = double(steepnessOf(lowest)) / (1 - double(steepnessOf(lowest)));
    ShadowExtent extent;
    const auto add = [&](const auto& obstacle) {
        ShadowExtent own;
        own.addBox(axes, obstacle.low, obstacle.high);
        own.highAlong += double(obstacle.topM) * axes.alongPerDistance / (edit.cellM * tan) + 2;
        extent.add({own.lowQ, own.lowAlong - 1});
        extent.add({own.highQ, own.highAlong});
    };
    for (const WallSet* set : {&edit.change.removed, &edit.change.added}) {
        std::ranges::for_each(set->prisms, add);
        std::ranges::for_each(set->solids, add);
    }
    blocks_ = edit.cells.newBlocks;
    if (extent.lowQ <= extent.highQ) addSquares(edit, axes, extent);
    std::ranges::sort(blocks_);
    blocks_.erase(std::unique(blocks_.begin(), blocks_.end()), blocks_.end());
}

// Those that meet the extent's band of q.
void BinEdit::addSquares(const TileEdit& edit, const ShadowAxes& axes, const ShadowExtent& extent) {
    const TileBox& box = edit.blocks.box();
    const glm::ivec2 squares = edit.blocks.squares();
    const int alongs = axes.swapped ? squares.x : squares.y, acrosses = axes.swapped ? squares.y : squares.x;
    for (int line = 0; line < alongs; ++line) {
        const int from = axes.swapped ? box.firstColumn : box.firstRow,
                  other = axes.swapped ? box.firstRow : box.firstColumn;
        const double one = axes.sign * (from + line * side), last = one + axes.sign * (side - 1);
        if (std::max(one, last) < extent.lowAlong || std::min(one, last) > extent.highAlong) continue;
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
}

void BinEdit::put(std::span<HorizonCode> codes, std::uint32_t number, HorizonCode code) {
    if (codes[number] == code) return;
    changes_.push_back({number, codes[number], code});
    codes[number] = code;
}

// Where nothing is lost the horizon is the higher one of the old and what was added.
void BinEdit::look(const TileEdit& edit, const ShadowAxes& axes, std::size_t i,
                   std::span<HorizonCode> codes) {
    const ReceiverBlocks::Block& block = edit.blocks.blocks()[i];
    const ReceiverBlocks::Masks& receivers = edit.blocks.masks(i, axes.swapped);
    const std::uint8_t* places = edit.blocks.places(block, axes.swapped);
    const BlockGround ground = edit.grounds.of(i, axes.swapped);
    const HorizonCode* gone = removed_.codes(block, receivers, ground);
    const HorizonCode* come = added_.codes(block, receivers, ground);
    Lost lost{i, axes.swapped ? edit.cells.newColumns[i] : edit.cells.newRows[i]};
    const bool anyNew = any(lost.masks);
    if (gone == nullptr && come == nullptr && !anyNew) return;
    for (std::uint32_t n = 0; n < block.count; ++n) {
        const std::uint8_t place = places[n];
        const HorizonCode now = codes[block.first + n], raised = come == nullptr ? noHorizon : come[place];
        if (anyNew && has(lost.masks, place)) continue;
        if (raised >= now) {
            put(codes, block.first + n, raised);
        } else if (gone != nullptr && gone[place] == now) {
            add(lost.masks, place);
        }
    }
    if (any(lost.masks)) lost_.push_back(lost);
}

void BinEdit::findAgain(const TileEdit& edit, glm::dvec2 away, HorizonCode lowest,
                        std::span<HorizonCode> codes) {
    const ShadowAxes axes(away);
    const WallList& list = edit.walls.list();
    ShadowExtent extent;
    for (const Lost& lost : lost_) extent = extentOf(edit.blocks.blocks()[lost.block], axes, extent);
    edit.walls.across(axes, extent, prisms_);
    all_.begin(list, {prisms_, list.solids, list.terrain.get()}, away, extent, lowest, edit.cellM, edit.stop);
    for (const Lost& lost : lost_) {
        const ReceiverBlocks::Block& block = edit.blocks.blocks()[lost.block];
        const std::uint8_t* places = edit.blocks.places(block, axes.swapped);
        const HorizonCode* square = all_.codes(block, lost.masks, edit.grounds.of(lost.block, axes.swapped));
        for (std::uint32_t n = 0; n < block.count; ++n)
            if (has(lost.masks, places[n]))
                put(codes, block.first + n, square == nullptr ? noHorizon : square[places[n]]);
    }
}

}  // namespace noonmark
