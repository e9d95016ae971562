#include "core/engines/horizon/cache/tile_edit.h"

#include <algorithm>
#include <bit>

#include "core/simd/cache_line.h"

namespace noonmark {

namespace {

bool any(const ReceiverBlocks::Masks& masks) {
    return std::ranges::any_of(masks, [](std::uint16_t mask) { return mask != 0; });
}

void forEachPlace(const ReceiverBlocks::Masks& masks, const auto& visit) {
    for (std::size_t row = 0; row < masks.size(); ++row)
        for (unsigned mask = masks[row]; mask != 0; mask &= mask - 1)
            visit(std::uint32_t(row), std::uint32_t(std::countr_zero(mask)));
}

}  // namespace

std::span<const CodeChange> BinEdit::run(const TileEdit& edit, glm::dvec2 away, CachedBin& bin,
                                         std::span<const CountChange> suns, TileSteps& steps) {
    bin_ = &bin;
    suns_ = suns;
    steps_ = &steps;
    away_ = away;
    axes_ = ShadowAxes(away);
    lost_.clear();
    changes_.clear();
    begin(edit, added_, addedSweep_, edit.change.added);
    begin(edit, removed_, removedSweep_, edit.undoesLast ? WallSet{} : edit.change.removed);
    findBlocks(edit);
    for (const std::size_t block : blocks_) look(edit, block);
    if (!lost_.empty()) recompute(edit);
    return changes_;
}

void BinEdit::begin(const TileEdit& edit, ShadedBlocks& shaded, BlockSweep& sweep, const WallSet& set) {
    shaded.begin(set, axes_, toTangent(bin_->lowest), edit.cellM);
    if (shaded.empty()) return;
    const ShadowExtent extent = shaded.extentIn(extentOf(edit.blocks.box(), axes_));
    sweep.begin(edit.walls.list(), set.obstacles(), away_, extent, bin_->lowest, edit.cellM, edit.stop);
}

void BinEdit::findBlocks(const TileEdit& edit) {
    marks_.begin(edit.blocks.blocks().size());
    blocks_.clear();
    const auto add = [&](std::size_t block) {
        if (marks_.mark(block)) blocks_.push_back(block);
    };
    std::ranges::for_each(edit.cells.newBlocks, add);
    std::ranges::for_each(bin_->base.blocks(), add);
    added_.find(edit.blocks, axes_, marks_, blocks_);
    removed_.find(edit.blocks, axes_, marks_, blocks_);
}

void BinEdit::look(const TileEdit& edit, std::size_t block) {
    Lost lost{block, (axes_.swapped ? edit.cells.unknownColumns : edit.cells.unknownRows)[block]};
    addLost(edit, lost);
    if (any(lost.masks))
        lost_.push_back(lost);
    else
        raise(edit, block, nullptr);
}

// Adds the cells where the removed occluders give the current code.
void BinEdit::addLost(const TileEdit& edit, Lost& lost) {
    if (removed_.empty()) return;
    const ReceiverBlocks::Block& block = edit.blocks.blocks()[lost.block];
    const HorizonCode* now = bin_->codes.data() + block.first;
    if (edit.level) {
        const int below = int(lowestIn(edit, lost.block, now)) - 1;
        if (!removed_.mayRaise(block, axes_, HorizonCode(std::max(int(bin_->lowest), below)))) return;
    }
    const ReceiverBlocks::Masks& known = edit.known.masks(lost.block, axes_.swapped);
    const HorizonCode* removed =
        removedSweep_.codes(block, known, edit.grounds.of(lost.block, axes_.swapped));
    if (removed == nullptr) return;
    if (axes_.swapped) {
        transpose(now, turned_);
        now = turned_.values;
    }
    ReceiverBlocks::Masks equal;
    findEqual(removed, now, known, equal);
    if (!edit.level) leaveOutRaised(edit, lost.block, now, equal);
    for (std::size_t row = 0; row < equal.size(); ++row) lost.masks[row] |= equal[row];
}

// Leaves out cells whose horizons the added occluders reach anyway: without pages, horizons without the added
// occluders are not needed.
void BinEdit::leaveOutRaised(const TileEdit& edit, std::size_t i, const HorizonCode* now,
                             ReceiverBlocks::Masks& masks) {
    if (added_.empty() || !any(masks)) return;
    const HorizonCode* added = addedSweep_.codes(edit.blocks.blocks()[i], edit.known.masks(i, axes_.swapped),
                                                 edit.grounds.of(i, axes_.swapped));
    if (added == nullptr) return;
    const ReceiverBlocks::Masks all = masks;
    forEachPlace(all, [&](std::uint32_t row, std::uint32_t place) {
        const std::uint32_t at = row * ReceiverBlocks::side + place;
        if (added[at] >= now[at]) masks[row] &= std::uint16_t(~(1U << place));
    });
}

void BinEdit::recompute(const TileEdit& edit) {
    ShadowExtent extent;
    for (const Lost& lost : lost_) {
        const ReceiverBlocks::Block& block = edit.blocks.blocks()[lost.block];
        const glm::dvec2 low(block.column, block.row);
        extent.addBox(axes_, low - 1.0, low + double(ReceiverBlocks::side));
    }
    edit.walls.across(axes_, extent, prisms_);
    allSweep_.begin(edit.walls.list(), edit.walls.before(prisms_), away_, extent, bin_->lowest, edit.cellM,
                    edit.stop);
    for (const Lost& lost : lost_) recompute(edit, lost);
}

void BinEdit::recompute(const TileEdit& edit, const Lost& lost) {
    const ReceiverBlocks::Block& block = edit.blocks.blocks()[lost.block];
    const HorizonCode* swept = allSweep_.codes(block, lost.masks, edit.grounds.of(lost.block, axes_.swapped));
    const HorizonCode* page = bin_->base.page(lost.block);
    BlockCodes base;
    std::copy_n(page != nullptr ? page : bin_->codes.data() + block.first, ReceiverBlocks::cells,
                base.values);
    forEachPlace(lost.masks, [&](std::uint32_t row, std::uint32_t place) {
        const std::uint32_t cell =
            axes_.swapped ? place * ReceiverBlocks::side + row : row * ReceiverBlocks::side + place;
        base.values[cell] = swept == nullptr ? noHorizon : swept[row * ReceiverBlocks::side + place];
    });
    bin_->base.setLowest(lost.block, edit.blocks.blocks().size(), BaselineCodes::unknown);
    raise(edit, lost.block, &base);
}

// Starts from the horizons without the buildings of the last change: those just recomputed, or those of the
// page, or else the current ones.
void BinEdit::raise(const TileEdit& edit, std::size_t block, const BlockCodes* found) {
    const std::uint32_t first = edit.blocks.blocks()[block].first;
    HorizonCode* page = bin_->base.page(block);
    const HorizonCode* base = found != nullptr  ? found->values
                              : page != nullptr ? page
                                                : bin_->codes.data() + first;
    const HorizonCode* added = addedCodes(edit, block, base);
    if (added == nullptr && page == nullptr && found == nullptr && !any(edit.cells.newRows[block])) return;
    BlockCodes codes;
    std::copy_n(base, ReceiverBlocks::cells, codes.values);
    if (added != nullptr) {
        if (edit.level && page == nullptr) page = bin_->base.add(block, edit.blocks.blocks().size());
        if (page != nullptr && page != base) std::ranges::copy(codes.values, page);
        noonmark::raise(added, codes);
    } else if (page != nullptr) {
        bin_->base.remove(block);
    }
    write(edit, block, codes);
}

// Row by row; null if the added occluders raise nothing.
const HorizonCode* BinEdit::addedCodes(const TileEdit& edit, std::size_t i, const HorizonCode* base) {
    if (added_.empty()) return nullptr;
    const ReceiverBlocks::Block& block = edit.blocks.blocks()[i];
    if (edit.level && !added_.mayRaise(block, axes_, std::max(bin_->lowest, lowestIn(edit, i, base))))
        return nullptr;
    prefetch(edit, i);
    const HorizonCode* swept =
        addedSweep_.codes(block, edit.known.masks(i, axes_.swapped), edit.grounds.of(i, axes_.swapped));
    if (swept == nullptr || !axes_.swapped) return swept;
    transpose(swept, turned_);
    return turned_.values;
}

// Prefetches data that is needed after the walls have been searched.
void BinEdit::prefetch(const TileEdit& edit, std::size_t block) const {
    const std::uint32_t first = edit.blocks.blocks()[block].first;
    for (std::uint32_t cell = 0; cell < ReceiverBlocks::cells; cell += 32) {
        prefetchForWrite(bin_->codes.data() + first + cell);
        prefetchForWrite(steps_->more.data() + first + cell);
        prefetchForWrite(steps_->more.data() + first + cell + 16);
    }
}

HorizonCode BinEdit::lowestIn(const TileEdit& edit, std::size_t block, const HorizonCode* base) {
    HorizonCode lowest = bin_->base.lowest(block);
    if (lowest != BaselineCodes::unknown) return lowest;
    lowest = findLowest(base, edit.known.masks(block, false));
    bin_->base.setLowest(block, edit.blocks.blocks().size(), lowest);
    return lowest;
}

// New receivers start from noHorizon, so that all their hidden suns are counted.
void BinEdit::write(const TileEdit& edit, std::size_t block, const BlockCodes& codes) {
    HorizonCode* now = bin_->codes.data() + edit.blocks.blocks()[block].first;
    forEachPlace(edit.cells.newRows[block], [&](std::uint32_t row, std::uint32_t x) {
        now[row * ReceiverBlocks::side + x] = noHorizon;
    });
    ReceiverBlocks::Masks differ;
    findDifferences(codes.values, now, edit.known.masks(block, false), differ);
    count(edit, block, codes, differ);
    for (std::size_t row = 0; row < differ.size(); ++row)
        if (differ[row] != 0)
            std::copy_n(codes.values + row * ReceiverBlocks::side, ReceiverBlocks::side,
                        now + row * ReceiverBlocks::side);
}

// Counts receivers only. A part of 64 numbers is marked as changed only if some sum changed; otherwise its
// runs stay valid.
void BinEdit::count(const TileEdit& edit, std::size_t block, const BlockCodes& codes,
                    const ReceiverBlocks::Masks& differ) {
    const std::uint32_t first = edit.blocks.blocks()[block].first;
    const HorizonCode* now = bin_->codes.data() + first;
    ReceiverBlocks::Masks counted = edit.blocks.masks(block, false);
    for (std::size_t row = 0; row < counted.size(); ++row) counted[row] &= differ[row];
    unsigned rows = 0;
    for (const CountChange& suns : suns_)
        rows |= suns.addDifference(now, codes.values, counted, steps_->more.data() + first);
    for (; rows != 0; rows &= rows - 1)
        steps_->parts[(first + std::uint32_t(std::countr_zero(rows) * ReceiverBlocks::side)) / lanesPerPart] =
            1;
    if (!edit.isOverhanging) return;
    forEachPlace(counted, [&](std::uint32_t row, std::uint32_t x) {
        const std::uint32_t cell = row * ReceiverBlocks::side + x;
        changes_.push_back({first + cell, now[cell], codes.values[cell]});
    });
}

}  // namespace noonmark
