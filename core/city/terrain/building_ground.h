#pragma once

#include <vector>

#include "core/city/city.h"

namespace noonmark {

/// Local z of the ground from which a building's heights are counted: the underside of its lowest part that
/// stands on the ground (reachesGround()); if all parts are overhangs, the terrain under its middle (0
/// without terrain).
float findGroundUnder(const Building& building, const City& city);

/// Height of a building's highest point above that ground, metres.
float heightM(const Building& building, const City& city);

/// The area where a part touches the ground, as polygons: no receivers there. For a part that is not an
/// overhang: its footprint. For an overhanging prism, or a mesh that does not reach the ground: nothing. For
/// a mesh with open air below some of it (eaves, a passage, stilts): its downward faces that lie within 0.5 m
/// of the ground or below it. If it has no such face (it is open below): the area that its walls enclose;
/// else nothing if walls stand under some, but less than walledEnough, of its outline (the posts and the back
/// wall of a shelter); else the whole footprint. `groundM`: local z.
std::vector<Footprint> findGroundContact(const Part& part, float groundM);

/// Whether a part stands on the ground: it is no overhang, or a mesh with open air below some of it (eaves, a
/// twisted volume) that reaches down to within 0.5 m of the ground. O(1).
bool reachesGround(const Part& part, float groundM);

}  // namespace noonmark
