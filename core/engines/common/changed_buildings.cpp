#include "core/engines/common/changed_buildings.h"

#include <algorithm>
#include <unordered_map>

namespace noonmark {

namespace {

Buildings lacking(const Buildings& from, const Buildings& to) {
    if (to.empty()) return from;
    std::unordered_map<const Building*, int> there;
    for (const auto& building : to) ++there[building.get()];
    Buildings missing;
    for (const auto& building : from)
        if (there[building.get()]-- <= 0) missing.push_back(building);
    return missing;
}

// Walks both lists in parallel and skips buildings that only one of them contains.
ChangedBuildings outOfStep(const Buildings& before, const Buildings& after) {
    ChangedBuildings changed;
    const auto [first, firstAfter] = std::ranges::mismatch(before, after);
    changed.first = std::size_t(first - before.begin());
    auto a = first, b = Buildings::const_iterator(firstAfter);
    while (a != before.end() && b != after.end()) {
        const bool same = *a == *b, left = !same && a + 1 != before.end() && *(a + 1) == *b,
                   put = !same && !left && b + 1 != after.end() && *a == *(b + 1);
        if (!same && !put) changed.gone.push_back(*a);
        if (!same && !left) changed.come.push_back(*b);
        if (!put) ++a;
        if (!left) ++b;
    }
    changed.gone.insert(changed.gone.end(), a, before.end());
    changed.come.insert(changed.come.end(), b, after.end());
    return changed;
}

}  // namespace

ChangedBuildings findChangedBuildings(const Buildings& before, const Buildings& after) {
    const ChangedBuildings changed = outOfStep(before, after);
    return {lacking(changed.gone, changed.come), lacking(changed.come, changed.gone), changed.first};
}

// Copying a shared_ptr (atomic reference counting) costs more than the rest of this loop, so equal entries
// are left alone.
void updateBuildings(Buildings& buildings, const Buildings& now, std::size_t first) {
    buildings.resize(now.size());
    for (std::size_t i = first; i < now.size(); ++i)
        if (buildings[i] != now[i]) buildings[i] = now[i];
}

}  // namespace noonmark
