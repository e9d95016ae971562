#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <vector>

#include "core/city/triangulate.h"

namespace noonmark {

namespace {

struct PointIndex {
    int value = -1;  // into Triangulation::points; -1 for a crossing that CGAL made
};
struct FaceDepth {
    int depth = -1;  // how many constraints lie between the face and the outside
};
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<PointIndex, Kernel>;
using FaceInfoBase = CGAL::Triangulation_face_base_with_info_2<FaceDepth, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfoBase>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;
using FaceStack = std::vector<std::pair<Delaunay::Face_handle, int>>;

void insertRing(Delaunay& delaunay, const Ring& ring, std::vector<glm::vec2>& points) {
    std::vector<Delaunay::Vertex_handle> vertices;
    for (const glm::vec2 point : ring) {
        const auto vertex = delaunay.insert({point.x, point.y});
        vertex->info().value = int(points.size());
        points.push_back(point);
        vertices.push_back(vertex);
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const auto next = vertices[(i + 1) % vertices.size()];
        if (vertices[i] != next) delaunay.insert_constraint(vertices[i], next);
    }
}

// Depth by flood fill from the outside: odd is inside, whatever way the rings run.
void markDepths(const Delaunay& delaunay) {
    FaceStack stack{{delaunay.infinite_face(), 0}};
    while (!stack.empty()) {
        const auto [face, depth] = stack.back();
        stack.pop_back();
        if (face->info().depth >= 0) continue;
        FaceStack level{{face, depth}};
        while (!level.empty()) {
            const auto here = level.back().first;
            level.pop_back();
            if (here->info().depth >= 0) continue;
            here->info().depth = depth;
            for (int side = 0; side < 3; ++side) {
                const auto neighbour = here->neighbor(side);
                if (neighbour->info().depth >= 0) continue;
                const bool wall = delaunay.is_constrained({here, side});
                (wall ? stack : level).emplace_back(neighbour, depth + (wall ? 1 : 0));
            }
        }
    }
}

unsigned pointIndex(Delaunay::Vertex_handle vertex, std::vector<glm::vec2>& points) {
    if (vertex->info().value < 0) {
        vertex->info().value = int(points.size());
        points.emplace_back(float(vertex->point().x()), float(vertex->point().y()));
    }
    return unsigned(vertex->info().value);
}

void collectInside(const Delaunay& delaunay, Triangulation& result) {
    for (const auto face : delaunay.finite_face_handles()) {
        if (face->info().depth % 2 == 0) continue;
        result.triangles.emplace_back(pointIndex(face->vertex(0), result.points),
                                      pointIndex(face->vertex(1), result.points),
                                      pointIndex(face->vertex(2), result.points));
    }
}

}  // namespace

Triangulation triangulated(const Footprint& footprint) {
    Delaunay delaunay;
    Triangulation result;
    insertRing(delaunay, footprint.outer, result.points);
    for (const Ring& hole : footprint.holes) insertRing(delaunay, hole, result.points);
    if (delaunay.dimension() < 2) return result;
    markDepths(delaunay);
    collectInside(delaunay, result);
    return result;
}

}  // namespace noonmark
