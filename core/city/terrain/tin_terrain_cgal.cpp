#include "core/city/terrain/tin_terrain.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <utility>

namespace noonmark {

namespace {
using DelaunayKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using NumberedVertex = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, DelaunayKernel>;
using PointTriangles =
    CGAL::Delaunay_triangulation_2<DelaunayKernel, CGAL::Triangulation_data_structure_2<NumberedVertex>>;

// Each position once, with the first of its points.
std::vector<std::pair<PointTriangles::Point, std::uint32_t>> places(std::span<const glm::vec2> points) {
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        return std::tie(points[a].x, points[a].y, a) < std::tie(points[b].x, points[b].y, b);
    });
    std::vector<std::pair<PointTriangles::Point, std::uint32_t>> unique;
    for (std::size_t i = 0; i < order.size(); ++i)
        if (i == 0 || points[order[i]] != points[order[i - 1]])
            unique.emplace_back(PointTriangles::Point(double(points[order[i]].x), double(points[order[i]].y)),
                                order[i]);
    return unique;
}
}  // namespace

std::vector<glm::uvec3> triangulateDelaunay(std::span<const glm::vec2> points) {
    const auto numbered = places(points);
    const PointTriangles triangulation(numbered.begin(), numbered.end());
    std::vector<glm::uvec3> triangles;
    if (triangulation.dimension() < 2) return triangles;
    for (const auto face : triangulation.finite_face_handles())
        triangles.emplace_back(face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info());
    return triangles;
}

}  // namespace noonmark
