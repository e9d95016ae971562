#include "core/engines/horizon/cache/tile_edit.h"

#include <algorithm>
#include <utility>

namespace noonmark {

namespace {
constexpr std::uint32_t blockNumbers = ReceiverBlocks::cells;  // all cells have numbers
}  // namespace

std::span<const GapChange> GapEdit::run(const TileEdit& edit, const Bin& bin, std::vector<Gap>& gaps) {
    begin(edit, bin);
    markHit(edit, bin, edit.change.removed.overhangs);
    markHit(edit, bin, edit.change.added.overhangs);
    if (numbers_.empty()) return changes_;
    recompute(edit, bin);
    findBlocks();
    rewritten_.clear();
    merged_.clear();
    auto found = found_.cbegin();
    for (const std::uint32_t block : blocks_) rewrite(bin, gaps, block, found);
    replace(gaps);
    clear();
    return changes_;
}

void GapEdit::begin(const TileEdit& edit, const Bin& bin) {
    changes_.clear();
    states_.resize(bin.codes.size(), untouched);
    before_.resize(bin.codes.size());
    horizons_.resize(bin.codes.size(), OverhangSweep::blind);
    for (const CodeChange& change : bin.changes) {
        mark(change.number, change.after < change.before ? stale : touched);
        before_[change.number] = change.before;
    }
    for (const std::uint32_t number : edit.cells.newNumbers) mark(number, State(stale | fresh));
    for (const std::uint32_t number : edit.cells.formerNumbers) mark(number, removed);
}

void GapEdit::mark(std::uint32_t number, State state) {
    if (states_[number] == untouched) numbers_.push_back(number);
    states_[number] |= state;
}

// Marks receivers for which removed or added overhangs reach above the current horizon. If the horizon was
// lower before, it has risen above the rest; if it was higher, the receiver is already marked.
void GapEdit::markHit(const TileEdit& edit, const Bin& bin, std::span<const OverhangShapes> shapes) {
    if (shapes.empty()) return;
    for (const Gap& gap : sweep_.intervals(viewOf(edit, bin, listOf(shapes)), bin.codes, edit.stop)) {
        if (edit.blocks.cell(gap.number) == ReceiverBlocks::padding) continue;
        if (states_[gap.number] == untouched) before_[gap.number] = bin.codes[gap.number];
        mark(gap.number, stale);
    }
}

OverhangView GapEdit::viewOf(const TileEdit& edit, const Bin& bin,
                             std::span<const OverhangShapes* const> shapes) {
    return {shapes, edit.overhangs, bin.away, bin.lowest, edit.cellM};
}

// Adds the suns that the gaps of marked receivers hid before, or hide now. Most receivers are not marked.
void GapEdit::add(const Bin& bin, std::span<const Gap> gaps, bool before) {
    if (bin.hidden == nullptr) return;
    const auto isOf = [](std::uint32_t number) {
        return [number](const Gap& gap) { return gap.number == number; };
    };
    for (auto first = gaps.begin(); first != gaps.end();) {
        const std::uint32_t number = first->number;
        const std::uint8_t state = states_[number];
        if (state == untouched) {
            ++first;
            continue;
        }
        const auto end = std::find_if_not(first, gaps.end(), isOf(number));
        const std::span<const Gap> own(std::exchange(first, end), end);
        if ((state & removed) != 0 || (before && (state & fresh) != 0)) continue;
        const std::uint32_t hidden =
            countHidden(before ? before_[number] : bin.codes[number], own, *bin.hidden);
        changes_.push_back({number, before ? 0 - hidden : hidden});
    }
}

void GapEdit::recompute(const TileEdit& edit, const Bin& bin) {
    const ShadowAxes axes(bin.away);
    const auto columns = std::uint32_t(edit.columns);
    ShadowExtent extent;
    for (const std::uint32_t number : numbers_) {
        const std::uint32_t cell = edit.blocks.cell(number);
        if ((states_[number] & stale) == 0 || cell == ReceiverBlocks::padding) continue;
        horizons_[number] = bin.codes[number];
        extent.add(axes.from({cell % columns, cell / columns}));
    }
    found_.clear();
    if (extent.lowQ > extent.highQ) return;
    extent = {extent.lowQ - 1, extent.highQ + 1, extent.lowAlong - 1, extent.highAlong + 1};
    edit.walls.overhangs().across(axes, extent, toTangent(bin.lowest), axes.alongPerDistance / edit.cellM,
                                  list_);
    OverhangView view = viewOf(edit, bin, list_);
    view.within = extent;
    const auto found = sweep_.intervals(view, horizons_, edit.stop);
    found_.assign(found.begin(), found.end());
}

// Blocks with marked numbers.
void GapEdit::findBlocks() {
    blocks_.clear();
    for (const std::uint32_t number : numbers_)
        if (const std::uint32_t block = number / blockNumbers; blocks_.empty() || blocks_.back() != block)
            blocks_.push_back(block);
    std::ranges::sort(blocks_);
    blocks_.erase(std::unique(blocks_.begin(), blocks_.end()), blocks_.end());
}

// `found`: the first new gap of this block or a later one; is advanced.
void GapEdit::rewrite(const Bin& bin, std::span<const Gap> gaps, std::uint32_t block, FoundGap& found) {
    const std::size_t before = rewritten_.empty() ? 0 : rewritten_.back().end;
    const auto from = std::ranges::lower_bound(gaps.subspan(before), block * blockNumbers, {}, &Gap::number),
               to = std::ranges::lower_bound(from, gaps.end(), (block + 1) * blockNumbers, {}, &Gap::number);
    const std::size_t merged = merged_.size();
    add(bin, {from, to}, true);
    merge({from, to}, (block + 1) * blockNumbers, found);
    add(bin, std::span(merged_).subspan(merged), false);
    rewritten_.push_back({std::size_t(from - gaps.begin()), std::size_t(to - gaps.begin()), merged_.size()});
}

// Merges remaining and recomputed gaps of numbers below `end`, by number.
void GapEdit::merge(std::span<const Gap> gaps, std::uint32_t end, FoundGap& found) {
    const auto stays = [&](const Gap& gap) { return (states_[gap.number] & (stale | removed)) == 0; };
    for (const Gap& gap : gaps) {
        if (!stays(gap)) continue;
        for (; found != found_.end() && found->number < gap.number; ++found) merged_.push_back(*found);
        merged_.push_back(gap);
    }
    for (; found != found_.end() && found->number < end; ++found) merged_.push_back(*found);
}

// Overwrites gaps in place while blocks keep their number of gaps, and rewrites the list from the first block
// that does not.
void GapEdit::replace(std::vector<Gap>& gaps) {
    std::size_t merged = 0;
    auto block = rewritten_.begin();
    for (; block != rewritten_.end() && block->mergedEnd - merged == block->end - block->first; ++block) {
        std::copy_n(merged_.begin() + std::ptrdiff_t(merged), block->end - block->first,
                    gaps.begin() + std::ptrdiff_t(block->first));
        merged = block->mergedEnd;
    }
    if (block == rewritten_.end()) return;
    const std::size_t kept = block->first;
    rest_.assign(gaps.begin() + std::ptrdiff_t(kept), gaps.end());
    gaps.resize(kept);
    const auto append = [&](const std::vector<Gap>& from, std::size_t first, std::size_t end) {
        gaps.insert(gaps.end(), from.begin() + std::ptrdiff_t(first), from.begin() + std::ptrdiff_t(end));
    };
    std::size_t at = kept;
    for (; block != rewritten_.end(); ++block) {
        append(rest_, at - kept, block->first - kept);
        append(merged_, merged, block->mergedEnd);
        merged = block->mergedEnd;
        at = block->end;
    }
    append(rest_, at - kept, rest_.size());
}

void GapEdit::clear() {
    for (const std::uint32_t number : numbers_) {
        states_[number] = untouched;
        horizons_[number] = OverhangSweep::blind;
    }
    numbers_.clear();
}

}  // namespace noonmark
