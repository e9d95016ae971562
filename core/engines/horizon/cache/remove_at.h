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
    auto kept = std::size_t(std::ranges::lower_bound(ownerOf, owners.front()) - ownerOf.begin());
    for (std::size_t i = kept; i < items.size(); ++i) {
        while (!owners.empty() && owners.front() < ownerOf[i]) owners = owners.subspan(1);
        if (!owners.empty() && owners.front() == ownerOf[i]) {
            taken.push_back(std::move(items[i]));
            continue;
        }
        if (kept != i) items[kept] = std::move(items[i]);
        ownerOf[kept++] = ownerOf[i];
    }
    items.resize(kept);
    ownerOf.resize(kept);
    return taken;
}

}  // namespace noonmark
