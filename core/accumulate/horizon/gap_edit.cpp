#include "core/accumulate/horizon/gap_edit.h"

#include <algorithm>
#include <utility>

namespace noonmark {

std::span<const GapChange> GapEdit::run(const TileEdit& edit, const Bin& bin, std::vector<Gap>& gaps) {
    begin(edit, bin);
    markHit(edit, bin, edit.change.removed.open);
    markHit(edit, bin, edit.change.added.open);
    if (numbers_.empty()) return changes_;
    const auto [first, last] = std::ranges::minmax(numbers_);
    const auto low = std::ranges::lower_bound(gaps, first, {}, &Gap::number),
               high = std::ranges::upper_bound(gaps, last, {}, &Gap::number);
    add(bin, {low, high}, true);
    findAgain(edit, bin);
    merge({low, high});
    add(bin, merged_, false);
    replace(gaps, std::size_t(low - gaps.begin()), std::size_t(high - gaps.begin()));
    clear();
    return changes_;
}

void GapEdit::begin(const TileEdit& edit, const Bin& bin) {
    changes_.clear();
    states_.resize(bin.codes.size(), untouched);
    before_.resize(bin.codes.size());
    horizons_.resize(bin.codes.size(), OpenSweep::blind);
    for (const CodeChange& change : bin.changes) {
        mark(change.number, change.after < change.before ? again : touched);
        before_[change.number] = change.before;
    }
    for (const std::uint32_t number : edit.cells.newNumbers) mark(number, State(again | fresh));
    for (const std::uint32_t number : edit.cells.goneNumbers) mark(number, gone);
}

void GapEdit::mark(std::uint32_t number, State state) {
    if (states_[number] == untouched) numbers_.push_back(number);
    states_[number] |= state;
}

// Where parts reach above the horizon as it is now. Where it was lower it has risen over them; where it was
// higher it is marked already.
void GapEdit::markHit(const TileEdit& edit, const Bin& bin, std::span<const OpenShapes> shapes) {
    if (shapes.empty()) return;
    for (const Gap& gap : sweep_.intervals(viewOf(edit, bin, listOf(shapes)), bin.codes, edit.stop)) {
        if (edit.blocks.cell(gap.number) == ReceiverBlocks::padding) continue;
        if (states_[gap.number] == untouched) before_[gap.number] = bin.codes[gap.number];
        mark(gap.number, again);
    }
}

OpenView GapEdit::viewOf(const TileEdit& edit, const Bin& bin, std::span<const OpenShapes* const> shapes) {
    return {shapes, edit.open, bin.away, bin.lowest, edit.cellM};
}

// What the gaps hid before, or hide now, of those that are marked. Most are not.
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
        if ((state & gone) != 0 || (before && (state & fresh) != 0)) continue;
        const std::uint32_t hidden = hiddenIn(before ? before_[number] : bin.codes[number], own, *bin.hidden);
        changes_.push_back({number, before ? 0 - hidden : hidden});
    }
}

void GapEdit::findAgain(const TileEdit& edit, const Bin& bin) {
    const ShadowAxes axes(bin.away);
    const auto columns = std::uint32_t(edit.columns);
    ShadowExtent extent;
    for (const std::uint32_t number : numbers_) {
        const std::uint32_t cell = edit.blocks.cell(number);
        if ((states_[number] & again) == 0 || cell == ReceiverBlocks::padding) continue;
        horizons_[number] = bin.codes[number];
        extent.add(axes.from({cell % columns, cell / columns}));
    }
    found_.clear();
    if (extent.lowQ > extent.highQ) return;
    extent = {extent.lowQ - 1, extent.highQ + 1, extent.lowAlong - 1, extent.highAlong + 1};
    edit.walls.open().across(axes, extent, tanOf(bin.lowest), axes.alongPerDistance / edit.cellM, list_);
    OpenView view = viewOf(edit, bin, list_);
    view.within = extent;
    const auto found = sweep_.intervals(view, horizons_, edit.stop);
    found_.assign(found.begin(), found.end());
}

// Of both, by number.
void GapEdit::merge(std::span<const Gap> gaps) {
    merged_.clear();
    const auto stays = [&](const Gap& gap) { return (states_[gap.number] & (again | gone)) == 0; };
    auto found = found_.begin();
    for (const Gap& gap : gaps) {
        if (!stays(gap)) continue;
        for (; found != found_.end() && found->number < gap.number; ++found) merged_.push_back(*found);
        merged_.push_back(gap);
    }
    merged_.insert(merged_.end(), found, found_.end());
}

void GapEdit::replace(std::vector<Gap>& gaps, std::size_t first, std::size_t end) const {
    const std::size_t common = std::min(merged_.size(), end - first);
    const auto from = gaps.begin() + std::ptrdiff_t(first), to = gaps.begin() + std::ptrdiff_t(end);
    const auto written = std::copy_n(merged_.begin(), common, from);
    gaps.erase(written, to);
    gaps.insert(gaps.begin() + std::ptrdiff_t(first + common), merged_.begin() + std::ptrdiff_t(common),
                merged_.end());
}

void GapEdit::clear() {
    for (const std::uint32_t number : numbers_) {
        states_[number] = untouched;
        horizons_[number] = OpenSweep::blind;
    }
    numbers_.clear();
}

}  // namespace noonmark
