#pragma once

#include <glm/mat3x3.hpp>
#include <string>
#include <vector>

#include "core/mesh_reader/dxf_groups.h"

namespace noonmark {

using DxfPolygon = std::vector<glm::dvec3>;  ///< at least three corners, in the drawing's unit

/// The surfaces of one entity.
struct DxfShape {
    std::vector<DxfPolygon> polygons;
    std::string leftOut;      ///< why there are none: "outlines without a thickness"; empty where there are
    DxfPolygon outline = {};  ///< of a closed outline without a thickness
};

/// The directions of the axes that an entity's points are given in, as columns: z is its extrusion direction
/// (groups 210 to 230), x and y follow by the format's rule.
glm::dmat3 ownAxes(const DxfEntity& entity);

/// A 3DFACE.
DxfShape makeFace(const DxfEntity& face);

/// SOLID and TRACE: extruded by their thickness.
DxfShape makeSolid(const DxfEntity& solid);

/// A closed LWPOLYLINE, extruded by its thickness (group 39); arcs (group 42) as chords of at most 10
/// degrees.
DxfShape makeLightOutline(const DxfEntity& outline);

/// A MESH, without its smoothing.
DxfShape makeSubdivisionMesh(const DxfEntity& mesh);

/// A POLYLINE and its VERTEX entities: a polyface mesh, a polygon mesh, or a closed outline, extruded by its
/// thickness.
DxfShape makePolyline(const DxfEntity& polyline, const std::vector<DxfEntity>& vertices);

}  // namespace noonmark
