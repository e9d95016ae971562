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

/// How far the tower moves, east.
inline constexpr float towerMoveM = 10;

/// The tower so far east of the middle. Shares the buildings of the site's city. Error: of the receivers.
Result<TowerPlace> placeTower(const BenchSite& site, float eastM, const Work& work);

/// Whether two fields have the same bits, where no receiver is, too.
bool haveSameMinutes(const ShadowField& a, const ShadowField& b);

}  // namespace noonmark::bench
