#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace noonmark {

/// The Delaunay triangulation of points: counter-clockwise triangles of their indices. Of coincident points
/// the first is used. Empty if all points lie on one line. O(points log points). Backend: delaunay_cgal.cpp.
std::vector<glm::uvec3> triangulateDelaunay(std::span<const glm::vec2> points);

}  // namespace noonmark
