#pragma once

#include <glm/vec2.hpp>
#include <vector>

class OGRGeometry;

namespace noonmark {

/// A polygon in the file's own coordinates: the outer ring, then holes.
using CrsPolygon = std::vector<std::vector<glm::dvec2>>;

/// Every polygon in a geometry, seen from above, including those in collections and curved ones (as straight
/// pieces). Points, lines and empty polygons are skipped. Backend: ogr_polygons_gdal.cpp.
std::vector<CrsPolygon> readPolygons(const OGRGeometry& geometry);

}  // namespace noonmark
