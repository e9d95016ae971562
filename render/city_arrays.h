#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "core/city/city.h"
#include "render/camera_pose.h"

namespace noonmark {

/// Arrays of the city ready for the graphics card: made on any thread, without OpenGL.
struct CityArrays {
    std::vector<glm::vec3> points;         ///< of buildings, local metres
    std::vector<float> buildingOfPoint;    ///< index in City::buildings, one a point
    std::vector<std::uint32_t> triangles;  ///< three a triangle, counter-clockwise from outside
    std::vector<std::uint32_t> edges;      ///< two a line: where walls and roofs meet at an angle
    std::vector<glm::vec3> groundPoints;
    std::vector<std::uint32_t> groundTriangles;
    ViewBounds bounds;
};

/// Buildings merged into one array; the ground is the terrain, or a level square that reaches far beyond the
/// city. Edges are left out above `mostEdgeTriangles`: drawing them would cost more than they show. About 0.5
/// s for 1 M triangles.
CityArrays arraysOf(const City& city, std::size_t mostEdgeTriangles = 3'000'000);

/// The box of all buildings, or of the terrain where there are none; 1 km around the origin where there is
/// neither.
ViewBounds viewBoundsOf(const City& city);

}  // namespace noonmark
