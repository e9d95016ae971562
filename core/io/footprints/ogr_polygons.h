#pragma once

#include <glm/vec2.hpp>
#include <vector>

class OGRGeometry;

namespace noonmark {

/// A polygon in the file's own coordinates: the outer ring, then holes.
using CrsPolygon = std::vector<std::vector<glm::dvec2>>;

/// Every polygon in a geometry seen from above: of collections and curved ones too (as straight pieces);
/// points and lines are passed over, as are empty polygons. Backend: ogr_polygons_gdal.cpp.
std::vector<CrsPolygon> readPolygons(const OGRGeometry& geometry);

}  // namespace noonmark
