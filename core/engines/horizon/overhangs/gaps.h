#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "core/engines/horizon/geometry/azimuth_bins.h"

namespace noonmark {

/// An interval of sun codes that are hidden although they lie above the receiver's horizon: low <= code <
/// high.
struct Gap {
    std::uint32_t number;  ///< of the receiver
    HorizonCode low, high;
};

/// Sorts by number, and by altitude within a receiver.
inline void sortByNumber(std::span<Gap> gaps) {
    std::ranges::sort(gaps, [](const Gap& a, const Gap& b) {
        return a.number != b.number ? a.number < b.number : a.low < b.low;
    });
}

/// Calls visit(own) with the gaps of each receiver that has any. `gaps`: sorted by number.
template <class T, class Visit>
void forEachReceiver(std::span<const T> gaps, const Visit& visit) {
    for (std::size_t first = 0, end = 0; first < gaps.size(); first = end) {
        while (end < gaps.size() && gaps[end].number == gaps[first].number) ++end;
        visit(gaps.subspan(first, end - first));
    }
}

struct EveryGap {
    constexpr bool operator()(const auto& /*gap*/) const { return true; }
};

/// Calls visit(gap, from) for each gap that extends above the horizon and all earlier gaps: it adds the
/// levels [from, gap.high). A gap that begins one level above the end of another interval is treated as
/// adjoining it, since only rounding separates them. `gaps`: of one receiver, sorted by altitude, possibly
/// overlapping; elements may have more fields than Gap. Gaps that are not `wanted` are skipped.
template <class Gaps, class Visit, class Wanted = EveryGap>
void forEachAdded(HorizonCode horizon, const Gaps& gaps, const Visit& visit, const Wanted& wanted = {}) {
    HorizonCode hidden = horizon;
    for (const auto& gap : gaps) {
        if (!wanted(gap) || gap.high <= hidden) continue;
        visit(gap, int(gap.low) <= int(hidden) + 1 ? hidden : gap.low);
        hidden = gap.high;
    }
}

/// How many suns the gaps hide above the horizon. `hiddenBelow(code)`: number of suns below this code.
template <class Gaps, class HiddenBelow>
std::uint32_t countHidden(HorizonCode horizon, const Gaps& gaps, const HiddenBelow& hiddenBelow) {
    std::uint32_t hidden = 0;
    forEachAdded(horizon, gaps, [&](const auto& gap, HorizonCode from) {
        hidden += hiddenBelow(gap.high) - hiddenBelow(from);
    });
    return hidden;
}

}  // namespace noonmark
