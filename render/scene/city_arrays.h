#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <vector>

#include "core/city/city.h"
#include "render/view/camera_pose.h"

namespace noonmark {

/// Arrays of the city ready for the graphics card: made on any thread, without OpenGL.
struct CityArrays {
    std::vector<glm::vec3> points;         ///< of buildings, local metres
    std::vector<float> buildingOfPoint;    ///< index in City::buildings, one a point
    std::vector<std::uint32_t> triangles;  ///< three a triangle, counter-clockwise from outside
    std::vector<std::uint32_t> edges;      ///< two a line: where walls and roofs meet at an angle
    std::vector<std::shared_ptr<const Building>> buildings;  ///< what is drawn, in the city's order
    /// Building i has triangles[triangleStart[i]] up to triangleStart[i + 1], and edges in the same way.
    std::vector<std::size_t> triangleStart;
    std::vector<std::size_t> edgeStart;
    std::vector<glm::vec3> groundPoints;
    std::vector<std::uint32_t> groundTriangles;
    ViewBounds bounds;
};

/// Buildings merged into one array; the ground is the terrain, or a level square that reaches far beyond the
/// city. Edges are left out above `mostEdgeTriangles`: drawing them would cost more than they show. About 0.5
/// s for 1 M triangles.
CityArrays makeArrays(const City& city, std::size_t mostEdgeTriangles = 3'000'000);

/// Only the buildings, without ground and bounds.
CityArrays makeBuildingArrays(const City& city, std::size_t mostEdgeTriangles = 3'000'000);

/// How a city differs from the arrays that are drawn of another: buildings are the same where they are
/// shared.
struct ArrayDifference {
    std::vector<std::uint32_t> gone;  ///< indices in CityArrays::buildings, ascending
    City added;                       ///< its buildings only
};

/// O(buildings x log buildings): some 10 ms for 43,000.
ArrayDifference differenceOf(const CityArrays& drawn, const City& city);

/// The box of all buildings, or of the terrain where there are none; 1 km around the origin where there is
/// neither.
ViewBounds computeViewBounds(const City& city);

}  // namespace noonmark
