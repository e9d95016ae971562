#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <numeric>
#include <vector>

#include "core/city/footprints/triangulate.h"

namespace noonmark {

namespace {

struct PointIndex {
    int value = -1;  // into Triangulation::points; -1 for a crossing that CGAL made
};
struct FaceDepth {
    int depth = -1;  // number of constraints between the face and the outside
};
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<PointIndex, Kernel>;
using FaceInfoBase = CGAL::Triangulation_face_base_with_info_2<FaceDepth, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Kernel, FaceInfoBase>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::Exact_predicates_tag>;
using FaceStack = std::vector<std::pair<Delaunay::Face_handle, int>>;

using Points = std::vector<Kernel::Point_2>;

void addPoints(const Ring& ring, Points& points) {
    for (const glm::vec2 point : ring) points.emplace_back(point.x, point.y);
}

// Orders points along a space-filling curve, so that each point is near the one before.
std::vector<std::size_t> nearbyOrder(const Points& points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    using Places = CGAL::Pointer_property_map<Kernel::Point_2>::const_type;
    CGAL::spatial_sort(order.begin(), order.end(),
                       CGAL::Spatial_sort_traits_adapter_2<Kernel, Places>(CGAL::make_property_map(points)));
    return order;
}

/// Inserts rings; of coincident points the last gives the vertex its index.
class RingInserter {
public:
    explicit RingInserter(Delaunay& delaunay) : delaunay_(delaunay) {}

    // Both functions return false if the sides cross too often.
    bool insertOneByOne(const Footprint& footprint) {
        bool good = insertInOrder(footprint.outer);
        for (const Ring& hole : footprint.holes) good = good && insertInOrder(hole);
        return good;
    }
    // For many points: inserted in the order of a ring, the number of triangles to flip for each point grows
    // with the number of points.
    bool insertAllPointsFirst(const Footprint& footprint) {
        Points points;
        addPoints(footprint.outer, points);
        for (const Ring& hole : footprint.holes) addPoints(hole, points);
        vertices_.resize(points.size());
        Delaunay::Face_handle near;
        for (const std::size_t i : nearbyOrder(points)) {
            vertices_[i] = delaunay_.insert(points[i], near);
            near = vertices_[i]->face();
        }
        for (std::size_t i = 0; i < vertices_.size(); ++i) vertices_[i]->info().value = int(i);
        std::size_t first = footprint.outer.size();
        bool good = insertSides(0, first);
        for (const Ring& hole : footprint.holes) {
            good = good && insertSides(first, hole.size());
            first += hole.size();
        }
        return good;
    }

private:
    bool insertInOrder(const Ring& ring) {
        const std::size_t first = vertices_.size();
        for (const glm::vec2 point : ring) {
            vertices_.push_back(delaunay_.insert({point.x, point.y}));
            vertices_.back()->info().value = int(vertices_.size() - 1);
        }
        return insertSides(first, ring.size());
    }
    bool insertSides(std::size_t first, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            const auto from = vertices_[first + i];
            const auto to = vertices_[first + (i + 1) % count];
            if (from != to) delaunay_.insert_constraint(from, to);
            if (delaunay_.number_of_vertices() > vertices_.size() + maxMeshCrossings) return false;
        }
        return true;
    }

    Delaunay& delaunay_;
    std::vector<Delaunay::Vertex_handle> vertices_;  // one for each point, in the footprint's order
};

std::vector<glm::vec2> ownPoints(const Footprint& footprint) {
    std::vector<glm::vec2> points = footprint.outer;
    for (const Ring& hole : footprint.holes) points.insert(points.end(), hole.begin(), hole.end());
    return points;
}

// Computes depths by flood fill from the outside: odd is inside, whatever the orientation of the rings.
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

Triangulation triangulate(const Footprint& footprint) {
    constexpr std::size_t few = 200;
    Delaunay delaunay;
    Triangulation result{ownPoints(footprint), {}, false};
    RingInserter inserter(delaunay);
    result.tangled = result.points.size() <= few ? !inserter.insertOneByOne(footprint)
                                                 : !inserter.insertAllPointsFirst(footprint);
    if (result.tangled) return result;
    if (delaunay.dimension() < 2) return result;
    markDepths(delaunay);
    collectInside(delaunay, result);
    return result;
}

}  // namespace noonmark
