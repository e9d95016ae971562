#pragma once

#include "core/bench/contests/site.h"
#include "core/bench/work.h"
#include "core/engines/api/shadow_field.h"
#include "core/receivers/receivers.h"

namespace noonmark::bench {

/// A city with a tower of 40 x 40 x 200 m in its middle, and the receivers around it.
struct TowerPlace {
    City city;
    Receivers receivers;
};

/// Distance that the tower moves, towards the east.
inline constexpr float towerMoveM = 10;

/// The city with the tower `eastM` east of its middle. Shares the buildings of the site's city. Error: as for
/// the receivers.
Result<TowerPlace> placeTower(const BenchSite& site, float eastM, const Work& work);

/// Whether two fields are equal bit for bit, including cells that are not receivers.
bool haveSameMinutes(const ShadowField& a, const ShadowField& b);

}  // namespace noonmark::bench
