#include "core/engines/common/changed_buildings.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <unordered_map>

namespace noonmark {

namespace {

using Address = const Building*;

std::vector<Address> sortedAddresses(const City& city) {
    std::vector<Address> addresses;
    for (const auto& building : city.buildings) addresses.push_back(building.get());
    std::ranges::sort(addresses, std::less<>{});
    addresses.erase(std::unique(addresses.begin(), addresses.end()), addresses.end());
    return addresses;
}

std::vector<Address> commonAddresses(std::span<const City* const> cities) {
    std::vector<Address> common = sortedAddresses(*cities.front());
    for (const City* city : cities.subspan(1)) {
        std::vector<Address> both;
        std::ranges::set_intersection(common, sortedAddresses(*city), std::back_inserter(both),
                                      std::less<>{});
        common = std::move(both);
    }
    return common;
}

}  // namespace

SharedBuildings findSharedBuildings(std::span<const City* const> cities) {
    SharedBuildings shared;
    if (cities.empty()) return shared;
    const std::vector<Address> common = commonAddresses(cities);
    for (const City* city : cities) {
        std::vector<std::uint32_t>& own = shared.own.emplace_back();
        for (std::uint32_t i = 0; i < city->buildings.size(); ++i) {
            const bool isCommon = std::ranges::binary_search(common, city->buildings[i].get(), std::less<>{});
            if (!isCommon)
                own.push_back(i);
            else if (city == cities.front())
                shared.common.push_back(i);
        }
    }
    return shared;
}

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
        if (!same && !put) changed.removed.push_back(*a);
        if (!same && !left) changed.added.push_back(*b);
        if (!put) ++a;
        if (!left) ++b;
    }
    changed.removed.insert(changed.removed.end(), a, before.end());
    changed.added.insert(changed.added.end(), b, after.end());
    return changed;
}

}  // namespace

ChangedBuildings findChangedBuildings(const Buildings& before, const Buildings& after) {
    const ChangedBuildings changed = outOfStep(before, after);
    return {lacking(changed.removed, changed.added), lacking(changed.added, changed.removed), changed.first};
}

// Copying a shared_ptr (atomic reference counting) costs more than the rest of this loop, so equal entries
// are left alone.
void updateBuildings(Buildings& buildings, const Buildings& now, std::size_t first) {
    buildings.resize(now.size());
    for (std::size_t i = first; i < now.size(); ++i)
        if (buildings[i] != now[i]) buildings[i] = now[i];
}

}  // namespace noonmark
