#pragma once

#include "core/city/city.h"
#include "core/sun/solar_position.h"

namespace noonmark {

/// Where a city is although a few of its buildings lie far out: extracts of maps bring along huts in a lake
/// and a tower of the next town. First view, first region, ground map, scale and haze are fitted to it.
struct MainPart {
    Box2 box;                      ///< around all buildings but the far ones; empty without buildings
    std::size_t farBuildings = 0;  ///< buildings that the first view leaves out
};

/// Groups buildings that are less than some 400 m apart, and takes the groups with most footprint area until
/// they hold 95 % of it. What lies no farther from their box than a quarter of its longer side (200 m at
/// least) belongs to it, too; the rest is far. O(buildings).
MainPart findMainPart(const City& city);

/// The densest box of this size: where its sides of some 50 m steps hold most footprint area, or in the
/// middle of `within` where that holds nearly as much. A side longer than that of `within` is cut to it.
/// Metres. O(buildings).
Box2 findDensestBox(const City& city, const Box2& within, glm::vec2 sizeM);

/// The observer of the sun at `local` (metres in the city's frame), in standard air. Every direction of the
/// sun that is applied to a city's geometry comes from here: the frame of the geometry has the north and the
/// vertical of the frame's origin, which differ from the observer's own away from the origin.
///
/// frameFromPlace is the differential, at the observer, of the map from the ground to the city's geometry:
/// - east and north: Frame::localFromEastNorth (north turns by the convergence: 0.46 deg at 27 km east of the
///   origin at a latitude of 62 deg);
/// - flat ground: up stays up, since all heights are heights above the ground;
/// - terrain: elevations were lowered by earthDropM, a paraboloid about the origin. About the observer this
///   is the same paraboloid plus a slope (earthDropSlope), which is applied to the sun too.
///
/// For the error elsewhere in a region, where the vertical is not the observer's, see
/// computeVerticalErrorDeg.
Observer placeObserver(const City& city, glm::dvec2 local);

/// Largest error of the direction of this observer's sun at a place `distanceM` away, degrees. On flat ground
/// it is the angle between the two verticals, 0.009 deg per km (2 s of the sun's motion). On terrain, whose
/// drop accounts for most of that angle, it is about an eighth of the angle while the sun is low.
double computeVerticalErrorDeg(double distanceM);

}  // namespace noonmark
