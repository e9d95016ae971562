#pragma once

#include <stop_token>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/receivers/point_receivers.h"
#include "core/receivers/receivers.h"
#include "core/receivers/region.h"

namespace noonmark {

/// The points of a horizontal plane.
struct PlanePoints {
    PointReceivers receivers;
    double planeM = 0;  ///< local z of the plane
    std::size_t insideBuildings =
        0;  ///< cells of the region that are left out, as the plane cuts a building there
    std::size_t belowGround = 0;  ///< cells that are left out, as the ground rises above the plane
};

inline constexpr double maxPlaneHeightM = 1000;

/// Local z of the mean of a region's ground, from cells of about 1 m, or of 1/1000 of its size where that is
/// larger.
double findMeanGroundM(const City& city, const Region& region);

/// One receiver in the middle of each cell of the region, on the horizontal plane `heightM` above the mean of
/// the region's ground, facing up. Ids are "column,row" of the grid that gridOver() makes. Error: a height
/// outside 0 to maxPlaneHeightM, a cell out of range, more than maxReceivers cells, cancelled().
Result<PlanePoints> placeOnPlane(const City& city, const Region& region, const ReceiverSettings& settings,
                                 double heightM, const std::stop_token& stop = {});

}  // namespace noonmark
