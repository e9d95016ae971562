#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "core/engines/horizon/geometry/azimuth_bins.h"

namespace noonmark {

/// Suns that a receiver does not see though they stand above its horizon: low <= code < high.
struct Gap {
    std::uint32_t number;  ///< of the receiver
    HorizonCode low, high;
};

/// By number, those of one receiver from below.
inline void sortByNumber(std::span<Gap> gaps) {
    std::ranges::sort(gaps, [](const Gap& a, const Gap& b) {
        return a.number != b.number ? a.number < b.number : a.low < b.low;
    });
}

/// Calls visit(own) for the gaps of each receiver that has any. `gaps`: by number.
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

/// Calls visit(gap, from) for each gap that reaches above all that the horizon and the gaps before it hide:
/// it adds the levels [from, gap.high). What begins a level above something that hides begins where that
/// ends: the two are one but for rounding. `gaps`: of one receiver, from below, joined or not; they may hold
/// more than a horizon. Gaps that are not `wanted` are passed over.
template <class Gaps, class Visit, class Wanted = EveryGap>
void forEachAdded(HorizonCode horizon, const Gaps& gaps, const Visit& visit, const Wanted& wanted = {}) {
    HorizonCode hidden = horizon;
    for (const auto& gap : gaps) {
        if (!wanted(gap) || gap.high <= hidden) continue;
        visit(gap, int(gap.low) <= int(hidden) + 1 ? hidden : gap.low);
        hidden = gap.high;
    }
}

/// How many suns gaps hide above the horizon. `hiddenBelow(code)`: suns below.
template <class Gaps, class HiddenBelow>
std::uint32_t countHidden(HorizonCode horizon, const Gaps& gaps, const HiddenBelow& hiddenBelow) {
    std::uint32_t hidden = 0;
    forEachAdded(horizon, gaps, [&](const auto& gap, HorizonCode from) {
        hidden += hiddenBelow(gap.high) - hiddenBelow(from);
    });
    return hidden;
}

}  // namespace noonmark
