#pragma once

#include <vector>

#include "core/city/building.h"

namespace noonmark {

/// Where a part meets the ground, as polygons: nobody stands there. A part that does not hang: its footprint.
/// A prism that hangs: nothing. A mesh with open air below some of it (eaves, a passage, stilts): those of
/// its faces that look down and lie within 0.5 m of the ground or below it; where it reaches the ground but
/// has no such face (it is open below), what its walls enclose. Walls that enclose nothing and stand under
/// less than walledEnough of its outline (the posts and the back wall of a shelter) leave the ground below
/// free; else it is the whole footprint. `groundM`: local z.
std::vector<Footprint> findGroundContact(const Part& part, float groundM);

}  // namespace noonmark
