#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace noonmark {

/// Removes the items of these owners from `items` and returns them. `ownerOf`, one per item, and `owners`
/// ascend.
template <class T>
std::vector<T> removeAt(std::vector<T>& items, std::vector<std::uint64_t>& ownerOf,
                        std::span<const std::uint64_t> owners) {
    std::vector<T> taken;
    if (owners.empty()) return taken;
    auto cached = std::size_t(std::ranges::lower_bound(ownerOf, owners.front()) - ownerOf.begin());
    for (std::size_t i = cached; i < items.size(); ++i) {
        while (!owners.empty() && owners.front() < ownerOf[i]) owners = owners.subspan(1);
        if (!owners.empty() && owners.front() == ownerOf[i]) {
            taken.push_back(std::move(items[i]));
            continue;
        }
        if (cached != i) items[cached] = std::move(items[i]);
        ownerOf[cached++] = ownerOf[i];
    }
    items.resize(cached);
    ownerOf.resize(cached);
    return taken;
}

}  // namespace noonmark
