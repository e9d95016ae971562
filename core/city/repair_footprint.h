#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "core/city/footprint.h"
#include "core/warnings.h"

namespace noonmark {

/// A ring as it came from a file, local metres, closed or not.
using RawRing = std::vector<glm::dvec2>;

/// What became of a polygon.
struct RepairedFootprint {
    std::vector<Footprint> pieces;  ///< none when nothing usable was left; disjoint; each simple and oriented
    WarningKind kind = WarningKind::mended;
    std::string what;  ///< empty when the polygon was valid as it stood; else what was wrong, for a Warning
};

/// Makes a polygon with holes usable: GEOS validity, MakeValid where it is not valid, slivers under 0.01 m2
/// left out, repeated points merged (float32 precision: points that fall together after rounding too),
/// orientation put right. `rings[0]` is the outer ring, the others are holes.
RepairedFootprint repairFootprint(const std::vector<RawRing>& rings);

}  // namespace noonmark
