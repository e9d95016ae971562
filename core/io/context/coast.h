#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <vector>

#include "core/city/footprints/footprint.h"

namespace noonmark {

/// A coastline in its direction, local metres: land lies on its left, the sea on its right, as OpenStreetMap
/// has it (https://wiki.openstreetmap.org/wiki/Tag:natural=coastline). A ring ends with its first point.
using CoastLine = std::vector<glm::dvec2>;

/// The sea within a box.
struct Sea {
    std::vector<Footprint> polygons;
    /// Ends of the coast that are continued straight to the nearest side of the box, metres each.
    std::vector<double> continuedM;
    /// Ends of the coast in the middle of the box. The sea around them is not known and left out.
    std::vector<glm::dvec2> openEnds;
    /// Areas with land and sea on the same side of their coast, which are left out, too.
    std::size_t contradictions = 0;
};

/// Chains coastlines by their common ends, closes them along the sides of the box, and takes the areas on
/// their right. An extract lacks the next point of a coast that leaves it: an end nearer to a side than a
/// tenth of the box's shorter side (100 m at least) goes on straight to it. Nothing else is guessed.
/// Coastlines may reach beyond the box. O(n log n).
Sea findSea(const std::vector<CoastLine>& coast, const Box2& box);

}  // namespace noonmark
