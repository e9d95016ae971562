#pragma once

#include <vector>

#include "core/city/building.h"

namespace noonmark {

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
