#pragma once

// The folder core/receivers/parcels has the lines around parcels that rules measure at (this file): the
// parcel's own line moved out along roads, lines at a distance from it, and the ground between two of them.

#include <array>
#include <cstdint>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/city.h"
#include "core/city/footprints/footprint.h"
#include "core/receivers/point_receivers.h"

namespace noonmark {

/// The ground between two lines that run around polygons at a distance, metres, 0 <= inner < outer. Corners
/// are rounded by arcs of 16 chords a quarter, so that a line is at most 0.3 % of its distance too near.
/// Error: the polygons cannot be offset. Backend: parcel_lines_geos.cpp.
Result<std::vector<Footprint>> cutBelt(const std::vector<Footprint>& polygons, double innerM, double outerM);

/// The lines around polygons at a distance, metres, > 0: outer rings and the rings of holes. Corners and
/// errors as of cutBelt().
Result<std::vector<Ring>> drawLines(const std::vector<Footprint>& polygons, double offsetM);

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

/// Where a side of a parcel faces, in the local frame.
enum class ParcelSide : std::uint8_t { north, northeast, east, southeast, south, southwest, west, northwest };
/// All sides, clockwise from north: parcelSides[i] == ParcelSide(i).
inline constexpr std::array parcelSides{ParcelSide::north,     ParcelSide::northeast, ParcelSide::east,
                                        ParcelSide::southeast, ParcelSide::south,     ParcelSide::southwest,
                                        ParcelSide::west,      ParcelSide::northwest};
/// "north", "northeast", ...
std::string_view nameOf(ParcelSide side);

/// A road, water or railway along the edges of a parcel that face about `side`.
struct RoadFront {
    ParcelSide side = ParcelSide::north;
    double widthM = 0;  ///< minRoadM to maxRoadM
    bool operator==(const RoadFront&) const = default;
};
inline constexpr double minRoadM = 0.01, maxRoadM = 200;

/// "south=8, east=12.5"; no road: empty.
std::string formatText(const std::vector<RoadFront>& roads);
/// Reads what formatText() writes, in any case of letters. Error: no such side, a side named twice, a width
/// out of range.
Result<std::vector<RoadFront>> parseRoads(std::string_view text);

/// How a rule moves the line of a parcel out along a road.
struct RoadShift {
    double narrowM = 0;       ///< of a road up to this width, 0 to 1000,
    double share = 0;         ///< by this share of its width, 0 to 1;
    double fromFarSideM = 0;  ///< of a wider one to this distance inside its far side, 0 to narrowM
};
/// Metres, at least 0.
double shiftOf(const RoadShift& rule, double widthM);

/// The parcel and the ground between its line and the line moved out along its roads. An edge belongs to the
/// front whose side is nearest to where it faces, if that is within 45 degrees; of fronts that are equally
/// near, as for a corner cut off at 45 degrees, to the one that moves it least. Edges more than 1 m behind
/// the parcel's convex hull are on no road. At a corner of two fronts both lines run on until they meet; at
/// the end of a front the ground ends square to the edge. Error: the polygons cannot be joined. Backend:
/// parcel_lines_geos.cpp.
Result<std::vector<Footprint>> moveLineOut(const Footprint& parcel, const std::vector<RoadFront>& roads,
                                           const RoadShift& rule);

}  // namespace noonmark
