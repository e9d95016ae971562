#pragma once

#include <stop_token>
#include <vector>

#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/receivers/point_receivers.h"
#include "core/receivers/points/point_list.h"

namespace noonmark {

/// Receivers at listed points, in their order, as `settlePoint` (settle_point.h) places them. A point inside
/// a building is left out, with a warning. Error: a value out of range, cancelled(). O(points x parts): in
/// Midtown some 2 ms a point.
Result<PointReceivers> placeListedPoints(const City& city, const std::vector<ListedPoint>& points,
                                         Warnings& warnings, const std::stop_token& stop = {});

}  // namespace noonmark
