#pragma once

#include "core/city/city.h"

namespace noonmark {

/// Where a city is although a few of its buildings lie far out: extracts of maps bring along huts in a lake
/// and a tower of the next town. First view, first region, ground map, scale and haze are fitted to it.
struct MainPart {
    Box2 box;                      ///< around all buildings but the far ones; empty without buildings
    std::size_t farBuildings = 0;  ///< buildings that are left aside
};

/// Groups buildings that are less than some 400 m apart, and takes the groups with most footprint area until
/// they hold 95 % of it. What lies no farther from their box than a quarter of its longer side (200 m at
/// least) belongs to it, too; the rest is far. O(buildings).
MainPart findMainPart(const City& city);

/// The densest box of this size: where its sides of some 50 m steps hold most footprint area, or in the
/// middle of `within` where that holds nearly as much. A side longer than that of `within` is cut to it.
/// Metres. O(buildings).
Box2 findDensestBox(const City& city, const Box2& within, glm::vec2 sizeM);

}  // namespace noonmark
