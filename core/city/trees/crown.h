#pragma once

#include <glm/vec3.hpp>

#include "core/city/trees/tree.h"

namespace noonmark {

/// A crown as rays meet it: around its vertical axis, between two elevations. An ellipsoid fills that height,
/// a cone has its apex at the top, a cylinder is as wide everywhere.
struct Crown {
    double x = 0, y = 0;           ///< local metres of its axis
    double bottomM = 0, topM = 0;  ///< local z; topM > bottomM
    double radiusM = 0;            ///< > 0
    CrownShape shape = CrownShape::ellipsoid;
    double leafOnPerM = 0;   ///< optical depth of a metre of path in leaf
    double leafOffPerM = 0;  ///< and out of season; of evergreens the same
};

/// The crown of a tree. The optical depth of a metre is -ln(transmissivity) / the crown's mean chord.
Crown makeCrown(const Tree& tree);

/// Mean length of the chords of a crown by lines of all places and directions, metres: 4 x volume / surface
/// (Cauchy).
double computeMeanChord(CrownShape shape, double radiusM, double heightM);

/// Length of the ray's path through the crown, metres, from its origin on: an origin inside the crown has the
/// rest of the chord only. `direction`: a unit vector that does not point downwards. Exact to about 1e-12 of
/// the distance. Some 10 ns.
double computeChord(const Crown& crown, glm::dvec3 origin, glm::dvec3 direction);

}  // namespace noonmark
