#include "core/accumulate/horizon/gaps.h"

namespace noonmark {

void GapMerge::run(std::vector<Gap>& gaps, std::size_t numbers) {
    sort_.run(
        gaps, numbers, [](const Gap& gap) { return gap.number; },
        [](const Gap& a, const Gap& b) { return a.low < b.low; });
    std::size_t kept = 0;
    for (const Gap& gap : gaps) {
        Gap* last = kept > 0 ? &gaps[kept - 1] : nullptr;
        if (last != nullptr && last->number == gap.number && int(gap.low) <= int(last->high) + 1)
            last->high = std::max(last->high, gap.high);
        else
            gaps[kept++] = gap;
    }
    gaps.resize(kept);
}

std::vector<Gap> openAbove(std::span<const Gap> gaps, HorizonCode lowest, const HiddenSuns& hidden,
                           std::span<HorizonCode> codes) {
    std::vector<Gap> open;
    for (const Gap& gap : gaps) {
        HorizonCode& horizon = codes[gap.number];
        // What begins a level above ends there too: the two are one but for rounding. And below the lowest
        // sun there is nothing to see.
        if (int(gap.low) <= std::max(int(horizon) + 1, int(lowest)))
            horizon = std::max(horizon, gap.high);
        else if (gap.high > horizon && hidden(gap.high) != hidden(gap.low))
            open.push_back(gap);
    }
    return open;
}

}  // namespace noonmark
