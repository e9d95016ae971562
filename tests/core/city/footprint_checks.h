#pragma once

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "core/city/city.h"
#include "core/receivers/rasterize.h"

namespace noonmark::tests {

struct Edge {
    glm::dvec2 a, b;
    std::size_t ring;
    std::size_t number;
    std::size_t ringSize;
};

inline std::vector<Edge> edgesOf(const Footprint& footprint) {
    std::vector<Ring> rings{footprint.outer};
    rings.insert(rings.end(), footprint.holes.begin(), footprint.holes.end());
    std::vector<Edge> edges;
    for (std::size_t r = 0; r < rings.size(); ++r)
        for (std::size_t i = 0; i < rings[r].size(); ++i)
            edges.push_back({glm::dvec2(rings[r][i]), glm::dvec2(rings[r][(i + 1) % rings[r].size()]), r, i,
                             rings[r].size()});
    return edges;
}

// Orientation of a, b, c. Exact for floats of similar size: their differences and products fit a long double.
inline int turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    using Exact = long double;
    const Exact cross = (Exact(b.x) - a.x) * (Exact(c.y) - a.y) - (Exact(b.y) - a.y) * (Exact(c.x) - a.x);
    return (cross > 0) - (cross < 0);
}

inline bool onEdge(glm::dvec2 p, const Edge& e) {
    return turn(e.a, e.b, p) == 0 && p.x >= std::min(e.a.x, e.b.x) && p.x <= std::max(e.a.x, e.b.x) &&
           p.y >= std::min(e.a.y, e.b.y) && p.y <= std::max(e.a.y, e.b.y);
}

inline bool apart(const Edge& e, const Edge& f) {
    return std::max(e.a.x, e.b.x) < std::min(f.a.x, f.b.x) ||
           std::max(f.a.x, f.b.x) < std::min(e.a.x, e.b.x) ||
           std::max(e.a.y, e.b.y) < std::min(f.a.y, f.b.y) || std::max(f.a.y, f.b.y) < std::min(e.a.y, e.b.y);
}

// Neighbouring edges of a ring share a point; edges of two rings may touch in one point; all others must not
// meet.
inline bool mayMeet(const Edge& e, const Edge& f) {
    if (e.ring != f.ring) return true;
    return (e.number + 1) % e.ringSize == f.number || (f.number + 1) % f.ringSize == e.number;
}

inline std::string faultOf(const Edge& e, const Edge& f) {
    if (apart(e, f)) return "";
    const int crossing = turn(e.a, e.b, f.a) * turn(e.a, e.b, f.b);
    if (crossing < 0 && turn(f.a, f.b, e.a) * turn(f.a, f.b, e.b) < 0) return "edges cross";
    std::vector<glm::dvec2> common;
    for (const glm::dvec2 p : {e.a, e.b})
        if (onEdge(p, f)) common.push_back(p);
    for (const glm::dvec2 p : {f.a, f.b})
        if (onEdge(p, e) && std::find(common.begin(), common.end(), p) == common.end()) common.push_back(p);
    if (common.size() > 1) return "edges overlap";
    if (!common.empty() && !mayMeet(e, f))
        return fmt::format("a ring touches itself at {} {}", common[0].x, common[0].y);
    return "";
}

/// Why a footprint is not simple and oriented; empty if it is. O(points squared).
inline std::string faultOf(const Footprint& footprint) {
    if (footprint.outer.size() < 3 || signedArea(footprint.outer) <= 0)
        return "outline is not counter-clockwise";
    for (const Ring& hole : footprint.holes)
        if (hole.size() < 3 || signedArea(hole) >= 0) return "a hole is not clockwise";
    const auto edges = edgesOf(footprint);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (edges[i].a == edges[i].b) return "a point is repeated";
        for (std::size_t j = 0; j < i; ++j)
            if (const std::string fault = faultOf(edges[i], edges[j]); !fault.empty()) return fault;
    }
    return "";
}

using Position = std::tuple<float, float, float>;

inline Position positionOf(glm::vec3 p) { return {p.x, p.y, p.z}; }

/// Number of directed edges of the mesh without their opposite, by position. 0: closed.
inline int openEdgesOf(const TriangleMesh& mesh) {
    std::map<std::pair<Position, Position>, int> balance;
    for (const glm::uvec3 t : mesh.triangles)
        for (int side = 0; side < 3; ++side) {
            const Position a = positionOf(mesh.vertices[t[side]]);
            const Position b = positionOf(mesh.vertices[t[(side + 1) % 3]]);
            if (a < b)
                ++balance[{a, b}];
            else
                --balance[{b, a}];
        }
    return int(
        std::count_if(balance.begin(), balance.end(), [](const auto& edge) { return edge.second != 0; }));
}

/// Volume, m3, positive if faces point outward. Relative to the first vertex, so that digits do not cancel
/// far from the origin.
inline double computeVolume(const TriangleMesh& mesh) {
    double volume = 0;
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 origin(mesh.vertices[0]);
        const glm::dvec3 a = glm::dvec3(mesh.vertices[t.x]) - origin;
        const glm::dvec3 b = glm::dvec3(mesh.vertices[t.y]) - origin;
        const glm::dvec3 c = glm::dvec3(mesh.vertices[t.z]) - origin;
        volume += glm::dot(a, glm::cross(b, c)) / 6;
    }
    return volume;
}

/// Why a footprint's prism is not a solid: open edges, or a volume other than area x height; empty if it is
/// one.
inline std::string faultOfSolid(const Footprint& footprint) {
    constexpr double heightM = 7.5;
    const Part part{.footprint = footprint, .bottomM = 1.25F, .topM = float(1.25 + heightM)};
    const TriangleMesh mesh = meshOf(part);
    if (const int open = openEdgesOf(mesh)) return fmt::format("{} open edges", open);
    const double expected = area(footprint) * heightM;
    const double volume = computeVolume(mesh);
    const bool equal = std::abs(volume - expected) <= 1e-9 * expected + 1e-6;
    return equal ? "" : fmt::format("volume {} instead of {}", volume, expected);
}

/// Number of cells of a fine raster over all footprints that lie in more than one of them.
inline int cellsSharedBy(const std::vector<Footprint>& footprints) {
    Box2 box;
    for (const Footprint& footprint : footprints) box.add(bounds(footprint));
    if (box.empty()) return 0;
    const double cell = std::max(double(box.high.x) - box.low.x, double(box.high.y) - box.low.y) / 500;
    const Grid grid{box.low.x - cell, box.low.y - cell, cell, 504, 504};
    std::vector<int> covers(grid.size());
    for (const Footprint& footprint : footprints)
        forEachRun(footprint, grid, [&](int row, int first, int end) {
            for (int column = first; column < end; ++column) ++covers[grid.index(column, row)];
        });
    return int(std::count_if(covers.begin(), covers.end(), [](int count) { return count > 1; }));
}

}  // namespace noonmark::tests
