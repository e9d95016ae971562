#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "core/city/footprints/footprint.h"

namespace noonmark {

/// The middle of a street, local metres, and its width.
struct StreetLine {
    std::vector<glm::dvec2> points;
    double widthM = 0;
};

/// The ground that the lines of one street cover, as disjoint polygons: each line widened to both sides, ends
/// cut off square, bends rounded; ends that meet are joined round. Lines without a length are left out. Empty
/// where GEOS fails. O(points log points). Backend: street_polygons_geos.cpp.
std::vector<Footprint> widenStreet(const std::vector<StreetLine>& lines);

/// Polygons that may overlap as disjoint ones; the polygons themselves where GEOS fails.
std::vector<Footprint> uniteOverlapping(std::vector<Footprint> polygons);

}  // namespace noonmark
