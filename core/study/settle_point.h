#pragma once

#include "core/study/point_study.h"

namespace noonmark {

struct SettledPoint {
    SkyPoint point;
    bool onRoof = false;
};

/// Where the point of a question is in a city: on the ground or the roof, or at its height. Its normal is
/// level towards `facingDeg`, or up. Error: it is inside a building or an overhang. O(parts).
Result<SettledPoint> settlePoint(const City& city, const PointQuestion& question);

}  // namespace noonmark
