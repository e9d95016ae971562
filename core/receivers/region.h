#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/city/footprints/footprint.h"
#include "core/geo/frame.h"

namespace noonmark {

/// The area of a study: one or more polygons in local metres.
struct Region {
    std::string name;
    std::vector<Footprint> polygons;
    bool operator==(const Region&) const = default;
};

/// The longitude/latitude box west, south, east, north (degrees) as a polygon in local metres; its sides
/// follow the curves of the projection. Across the antimeridian west is the larger number:
/// 179.9,-16.9,-179.9,-16.7. Error if the box is empty, more than 180 degrees wide, or a value is out of
/// range.
Result<Region> makeRegionFromLonLatBox(const Frame& frame, double westDeg, double southDeg, double eastDeg,
                                       double northDeg);

Region makeRegionFromLocalBox(const Box2& box);

Box2 bounds(const Region& region);

}  // namespace noonmark
