#include "core/engines/common/shared_buildings.h"

#include <algorithm>
#include <functional>
#include <iterator>

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

}  // namespace noonmark
