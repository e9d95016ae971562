#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/units.h"
#include "core/city/city.h"
#include "core/receivers/point_receivers.h"
#include "core/receivers/receivers.h"

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

/// A single point where sunlight is measured.
struct ListedPoint {
    static constexpr double maxHeightM = 2000;

    std::string id;  ///< never empty
    LonLat at;
    std::optional<double> heightM;    ///< above the ground; none: on the ground, or on the roof of a building
    std::optional<double> facingDeg;  ///< azimuth from true north that a wall faces; none: a level surface
    bool operator==(const ListedPoint&) const = default;
};
inline constexpr std::size_t maxListedPoints = 10'000;

/// Reads "LON,LAT[,H[,FACING]]": degrees, metres above the ground, degrees. The id is left empty. Error:
/// anything else, or a value out of range.
Result<ListedPoint> parsePoint(std::string_view text);
/// Writes what parsePoint() reads, without the id.
std::string formatText(const ListedPoint& point);

/// Reads a list of points as CSV, one a row. With a heading: columns lon and lat, and optionally id (or
/// name), height (or height_m, h) and facing (or facing_deg, azimuth), in any order; other columns are not
/// read. Without a heading: lon, lat, height, facing. A point without an id is named after its row: "point
/// 3". `source` names the text in errors. Error: no points, more than maxListedPoints, an id that is used
/// twice, a column that is missing, or a value that is no number or out of range (with its line).
Result<std::vector<ListedPoint>> parsePointList(std::string_view text, const std::string& source);

/// Writes what parsePointList() reads: "id,lon,lat,height,facing" and a row a point.
std::string toCsv(const std::vector<ListedPoint>& points);

}  // namespace noonmark
