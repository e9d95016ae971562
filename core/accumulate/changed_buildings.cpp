#include "core/accumulate/changed_buildings.h"

#include <algorithm>
#include <span>
#include <unordered_map>

namespace noonmark {

namespace {

using Stretch = std::span<const std::shared_ptr<const Building>>;

Buildings lacking(Stretch from, Stretch to) {
    std::unordered_map<const Building*, int> there;
    for (const auto& building : to) ++there[building.get()];
    Buildings missing;
    for (const auto& building : from)
        if (there[building.get()]-- <= 0) missing.push_back(building);
    return missing;
}

}  // namespace

ChangedBuildings changedBuildings(const Buildings& before, const Buildings& after) {
    const auto [first, firstAfter] = std::ranges::mismatch(before, after);
    Stretch gone(first, before.end()), come(firstAfter, after.end());
    while (!gone.empty() && !come.empty() && gone.back() == come.back()) {
        gone = gone.first(gone.size() - 1);
        come = come.first(come.size() - 1);
    }
    return {lacking(gone, come), lacking(come, gone)};
}

}  // namespace noonmark
