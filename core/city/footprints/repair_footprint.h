#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/city/footprints/footprint.h"

namespace noonmark {

/// A ring as it came from a file, local metres, closed or not.
using RawRing = std::vector<glm::dvec2>;

/// What became of a polygon.
struct RepairedFootprint {
    std::vector<Footprint> pieces;  ///< none when nothing usable was left; disjoint; each simple and oriented
    WarningKind kind = WarningKind::mended;
    std::string what;  ///< empty when the polygon was valid as it stood; else what was wrong, for a Warning
};

/// Makes a polygon with holes usable: GEOS validity, MakeValid where it is not valid (the outline's inside
/// less the holes' insides), slivers under 0.01 m2 left out, repeated points merged, orientation put right.
/// Every point is a float32, and what is given back is valid as such: where rounding makes points fall
/// together or edges cross, all are snapped to float32's step (1 mm at 10 km). A hole that lies wholly
/// outside is most often a second outline: it becomes a piece of its own, and `what` says so. Without an
/// outline that has an inside there are no pieces. `rings[0]` is the outer ring, the others are holes.
/// Rings that cross more than mostCrossings times (tangled_rings.h) are refused: no pieces. Coordinates over
/// 1e8 m or not finite are refused. About 5 us for a valid polygon of few points.
RepairedFootprint repairFootprint(const std::vector<RawRing>& rings);

}  // namespace noonmark
