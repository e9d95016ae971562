#pragma once

#include <stop_token>
#include <vector>

#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/receivers/point_receivers.h"

namespace noonmark {

/// Receivers on lines around a parcel.
struct LineSettings {
    static constexpr double minOffsetM = 0.1, maxOffsetM = 500;
    static constexpr double minSpacingM = 0.1, maxSpacingM = 100;
    std::vector<double> offsetsM{5, 10};  ///< distances of the lines from the parcel
    double spacingM = 1;                  ///< about this far apart on a line
    bool operator==(const LineSettings&) const = default;
};

/// Points on the lines around parcels at these distances, facing up at the local z `planeM`: each line in
/// equal parts that come nearest to the spacing, from its first corner on. Ids are "5 m, 1", "5 m, 2"; a line
/// of several rings goes on counting. Points inside a building are left out, with a warning, as those below
/// the ground. Error: a setting out of range, more than maxReceivers points, the polygons cannot be offset,
/// cancelled(). Some 1 us a point.
Result<PointReceivers> placeOnLines(const City& city, const std::vector<Footprint>& parcels,
                                    const LineSettings& settings, double planeM, Warnings& warnings,
                                    const std::stop_token& stop = {});

}  // namespace noonmark
