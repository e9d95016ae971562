#pragma once

#include <string>
#include <vector>

#include "core/mesh_reader/dxf_groups.h"

namespace noonmark {

using DxfPolygon = std::vector<glm::dvec3>;  ///< at least three corners, in the drawing's unit

/// The surfaces of one entity.
struct DxfShape {
    std::vector<DxfPolygon> polygons;
    std::string leftOut;  ///< why there are none: "outlines without a thickness"; empty where there are
};

/// A 3DFACE.
DxfShape makeFace(const DxfEntity& face);

/// SOLID and TRACE: extruded by their thickness.
DxfShape makeSolid(const DxfEntity& solid);

/// A closed LWPOLYLINE, extruded by its thickness (group 39); arcs (group 42) as chords of at most 10
/// degrees.
DxfShape makeLightOutline(const DxfEntity& outline);

/// A POLYLINE and its VERTEX entities: a polyface mesh, a polygon mesh, or a closed outline, extruded by its
/// thickness.
DxfShape makePolyline(const DxfEntity& polyline, const std::vector<DxfEntity>& vertices);

}  // namespace noonmark
