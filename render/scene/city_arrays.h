#pragma once

// The folder render/scene/ turns a city and its pictures into Qt3D nodes. This file computes arrays without
// OpenGL; city_bodies.h draws them and what the user edits; ground_picture.h and
// surface_layer.h put results onto ground, roofs and facades; the other headers draw marks, names and tiles,
// or wrap geometries, textures and shaders of Qt3D.

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "core/city/city_position.h"
#include "core/city/meshes/mesh.h"
#include "render/view/camera_pose.h"

namespace noonmark {

/// The edges of a line drawing: those where two faces meet at more than `angleDeg`, and borders. Two vertex
/// indices per edge, each edge once. Faces share an edge if they share its vertices by index. O(triangles log
/// triangles).
std::vector<std::uint32_t> findFeatureEdges(const TriangleMesh& mesh, double angleDeg = 20);

/// The arrays of a city for the graphics card. They can be computed on any thread, without OpenGL.
struct CityArrays {
    std::vector<glm::vec3> points;         ///< of buildings, local metres
    std::vector<float> buildingOfPoint;    ///< index into City::buildings, one per point
    std::vector<std::uint32_t> triangles;  ///< three indices per triangle, counter-clockwise from outside
    std::vector<std::uint32_t> edges;      ///< two indices per line: where walls and roofs meet at an angle
    std::vector<std::shared_ptr<const Building>> buildings;  ///< the buildings drawn, in the city's order
    /// Building i has the entries from triangleStart[i] up to triangleStart[i + 1] of `triangles`; likewise
    /// for `edges`.
    std::vector<std::size_t> triangleStart;
    std::vector<std::size_t> edgeStart;
    std::vector<glm::vec3> groundPoints;
    std::vector<std::uint32_t> groundTriangles;
    std::shared_ptr<const Terrain> terrain;  ///< of which the ground is; null: level
    ViewBounds bounds;
    MainPart mainPart;  ///< is shown first, and what scale and haze are fitted to
};

/// Merges the buildings into one array. The ground is the terrain, or a level square that extends far beyond
/// the city. Above `maxEdgeTriangles` there are no edges: they would cost more than they show. About 0.5 s
/// for 1 M triangles.
CityArrays makeArrays(const City& city, std::size_t maxEdgeTriangles = 3'000'000);

/// Only the buildings, without ground and bounds.
CityArrays makeBuildingArrays(const City& city, std::size_t maxEdgeTriangles = 3'000'000);

/// How a city differs from another city whose arrays are drawn. Buildings compare by pointer.
struct ArrayDifference {
    std::vector<std::uint32_t> removed;  ///< indices in CityArrays::buildings, ascending
    City added;                          ///< its buildings only
};

/// O(buildings x log buildings): about 10 ms for 43,000.
ArrayDifference computeDifference(const CityArrays& drawn, const City& city);

/// The bounding box of all buildings, or of the terrain where there are none; 1 km around the origin where
/// there is neither.
ViewBounds computeViewBounds(const City& city);

}  // namespace noonmark
