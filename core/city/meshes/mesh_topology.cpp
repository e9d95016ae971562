#include "core/city/meshes/mesh_topology.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <unordered_map>

#include "core/base/disjoint_sets.h"

namespace noonmark {

namespace {

using Index = std::uint32_t;

glm::dvec3 doubledArea(const TriangleMesh& mesh, glm::uvec3 t) {
    const glm::dvec3 a(mesh.vertices[t.x]);
    return glm::cross(glm::dvec3(mesh.vertices[t.y]) - a, glm::dvec3(mesh.vertices[t.z]) - a);
}

// A directed edge as one key.
std::uint64_t edgeKey(Index from, Index to) { return (std::uint64_t(from) << 32U) | to; }

}  // namespace

std::size_t removeDegenerateTriangles(TriangleMesh& mesh) {
    constexpr double minDoubledArea = 2e-8;
    return std::erase_if(mesh.triangles, [&](glm::uvec3 t) {
        // Negated, so that NaN is removed too
        return !(glm::length(doubledArea(mesh, t)) >= minDoubledArea);
    });
}

std::size_t findOpenEdges(const TriangleMesh& mesh) {
    std::unordered_map<std::uint64_t, int> balance;
    balance.reserve(mesh.triangles.size() * 2);
    for (const glm::uvec3 t : mesh.triangles)
        for (int i = 0; i < 3; ++i) {
            const Index from = t[i];
            const Index to = t[(i + 1) % 3];
            balance[edgeKey(std::min(from, to), std::max(from, to))] += from < to ? 1 : -1;
        }
    std::size_t open = 0;
    for (const auto& [edge, sum] : balance) open += std::size_t(std::abs(sum));
    return open;
}

double signedVolume(const TriangleMesh& mesh) {
    const MeshBox box = computeBox(mesh);
    const glm::dvec3 middle = (glm::dvec3(box.low) + glm::dvec3(box.high)) / 2.0;
    double sum = 0;
    for (const glm::uvec3 t : mesh.triangles)
        sum += glm::dot(glm::dvec3(mesh.vertices[t.x]) - middle, doubledArea(mesh, t));
    return sum / 6;
}

Components findComponents(const TriangleMesh& mesh) {
    DisjointSets points(mesh.vertices.size());
    for (const glm::uvec3 t : mesh.triangles) {
        points.join(t.x, t.y);
        points.join(t.x, t.z);
    }
    Components components;
    std::unordered_map<std::size_t, Index> numberOfSet;
    for (const glm::uvec3 t : mesh.triangles) {
        const auto [place, isNew] = numberOfSet.try_emplace(points.of(t.x), components.count);
        components.count += isNew ? 1 : 0;
        components.ofTriangle.push_back(place->second);
    }
    return components;
}

std::vector<TriangleMesh> separateComponents(const TriangleMesh& mesh, const Components& components) {
    std::vector<TriangleMesh> meshes(components.count);
    constexpr Index unused = ~Index(0);
    std::vector<Index> newIndex(mesh.vertices.size(), unused);  // a point belongs to one component only
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        TriangleMesh& one = meshes[components.ofTriangle[i]];
        glm::uvec3 triangle = mesh.triangles[i];
        for (int corner = 0; corner < 3; ++corner) {
            Index& index = newIndex[triangle[corner]];
            if (index == unused) {
                index = Index(one.vertices.size());
                one.vertices.push_back(mesh.vertices[triangle[corner]]);
            }
            triangle[corner] = index;
        }
        one.triangles.push_back(triangle);
    }
    return meshes;
}

void turnInsideOut(TriangleMesh& mesh) {
    for (glm::uvec3& triangle : mesh.triangles) std::swap(triangle.y, triangle.z);
}

void append(TriangleMesh& mesh, const TriangleMesh& more) {
    const Index first = Index(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
    for (const glm::uvec3 triangle : more.triangles) mesh.triangles.push_back(triangle + first);
}

std::size_t turnOutward(TriangleMesh& mesh) {
    std::vector<TriangleMesh> components = separateComponents(mesh, findComponents(mesh));
    std::vector<MeshBox> boxes;
    for (const TriangleMesh& component : components) boxes.push_back(computeBox(component));
    std::size_t turned = 0, sheets = 0;
    for (std::size_t i = 0; i < components.size(); ++i) {
        if (isSheet(components[i])) {
            if (computeAreaFromAbove(components[i]) < 0) turnInsideOut(components[i]), ++sheets;
            continue;
        }
        if (signedVolume(components[i]) >= 0) continue;
        const auto holds = [&](const MeshBox& other) { return boxes[i].liesInside(other); };
        if (std::any_of(boxes.begin(), boxes.end(), holds)) continue;
        turnInsideOut(components[i]);
        ++turned;
    }
    if (turned + sheets == 0) return 0;
    mesh = {};
    for (const TriangleMesh& component : components) append(mesh, component);
    return turned;
}

bool MeshBox::liesInside(const MeshBox& other) const {
    return glm::all(glm::greaterThan(low, other.low)) && glm::all(glm::lessThan(high, other.high));
}

MeshBox computeBox(const TriangleMesh& mesh) {
    MeshBox box;
    for (const glm::uvec3 t : mesh.triangles)
        for (int i = 0; i < 3; ++i) {
            box.low = glm::min(box.low, mesh.vertices[t[i]]);
            box.high = glm::max(box.high, mesh.vertices[t[i]]);
        }
    return box;
}

namespace {

using Cell = glm::dvec3;  // whole numbers, possibly beyond the range of integers

struct CellHash {
    std::size_t operator()(const Cell& cell) const {
        return bitsOf(cell.x) * 73856093U ^ bitsOf(cell.y) * 19349663U ^ bitsOf(cell.z) * 83492791U;
    }

private:
    // -0 equals 0 but has other bits; the low bits of small whole numbers are all 0.
    static std::size_t bitsOf(double number) {
        const std::uint64_t bits = std::bit_cast<std::uint64_t>(number + 0.0);
        return bits ^ bits >> 32U;
    }
};

// Finds points by position. Cells are twice the tolerance wide, so that every point within the tolerance is
// in one of eight cells.
class PointFinder {
public:
    PointFinder(std::vector<glm::vec3>& points, float tolerance) : points_(points), tolerance_(tolerance) {}

    // The point that represents `point`: an existing one within the tolerance, or `point` itself, which is
    // then added.
    Index find(glm::vec3 point) {
        for (int corner = 0; corner < 8; ++corner) {
            const auto [first, end] = cells_.equal_range(cellAt(point, corner));
            for (auto place = first; place != end; ++place)
                if (glm::distance(points_[place->second], point) <= tolerance_) return place->second;
        }
        return add(point);
    }

private:
    Index add(glm::vec3 point) {
        const Index index = Index(points_.size());
        points_.push_back(point);
        cells_.emplace(cellOf(glm::dvec3(point)), index);
        return index;
    }
    [[nodiscard]] Cell cellOf(glm::dvec3 point) const { return glm::floor(point / (2.0 * tolerance_)); }
    [[nodiscard]] Cell cellAt(glm::vec3 point, int corner) const {
        const glm::dvec3 shift((corner & 1) ? 1 : -1, (corner & 2) ? 1 : -1, (corner & 4) ? 1 : -1);
        return cellOf(glm::dvec3(point) + shift * double(tolerance_));
    }

    std::vector<glm::vec3>& points_;
    float tolerance_;
    std::unordered_multimap<Cell, Index, CellHash> cells_;
};

bool isFinite(glm::vec3 point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

}  // namespace

std::vector<Index> weldIndices(std::span<const glm::vec3> points, float toleranceM) {
    std::vector<glm::vec3> found;
    PointFinder finder(found, toleranceM);
    std::vector<Index> firstOf, indices;  // `firstOf`: for each stored point, its index in the input
    for (Index i = 0; i < points.size(); ++i) {
        if (!isFinite(points[i])) {
            indices.push_back(i);
            continue;
        }
        const Index at = finder.find(points[i]);
        if (at == firstOf.size()) firstOf.push_back(i);
        indices.push_back(firstOf[at]);
    }
    return indices;
}

TriangleMesh weld(const TriangleMesh& mesh, float toleranceM) {
    TriangleMesh result;
    PointFinder finder(result.vertices, toleranceM);
    constexpr Index unknown = ~Index(0);
    std::vector<Index> newIndex(mesh.vertices.size(), unknown);
    for (glm::uvec3 triangle : mesh.triangles) {
        bool usable = true;
        for (int corner = 0; corner < 3; ++corner)
            usable = usable && isFinite(mesh.vertices[triangle[corner]]);
        if (!usable) continue;
        for (int corner = 0; corner < 3; ++corner) {
            Index& index = newIndex[triangle[corner]];
            if (index == unknown) index = finder.find(mesh.vertices[triangle[corner]]);
            triangle[corner] = index;
        }
        const bool collapsed =
            triangle.x == triangle.y || triangle.y == triangle.z || triangle.z == triangle.x;
        if (!collapsed) result.triangles.push_back(triangle);
    }
    return result;
}

namespace {

// Areas of a mesh's faces, square metres.
struct FaceAreas {
    double all = 0;
    double fromAbove = 0;  // in plan, whichever way a face points
    double plumb = 0;      // faces within six degrees of vertical
};

FaceAreas faceAreas(const TriangleMesh& mesh) {
    constexpr double plumbLean = 0.1;
    FaceAreas areas;
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a(mesh.vertices[t.x]);
        const glm::dvec3 doubled =
            glm::cross(glm::dvec3(mesh.vertices[t.y]) - a, glm::dvec3(mesh.vertices[t.z]) - a);
        const double area = glm::length(doubled) / 2, flat = std::abs(doubled.z) / 2;
        areas.all += area;
        areas.fromAbove += flat;
        if (flat < plumbLean * area) areas.plumb += area;
    }
    return areas;
}

}  // namespace

bool isLevel(const TriangleMesh& mesh) {
    const MeshBox box = computeBox(mesh);
    return box.high.z - box.low.z < levelSheetM;
}

bool isUpright(const TriangleMesh& mesh) {
    constexpr double maxLean = 0.0175;
    const FaceAreas areas = faceAreas(mesh);
    return areas.fromAbove <= maxLean * areas.all;
}

bool isSheet(const TriangleMesh& mesh) {
    const FaceAreas areas = faceAreas(mesh);
    return areas.plumb <= 0.01 * areas.all && findOpenEdges(mesh) > 0;
}

double computeAreaFromAbove(const TriangleMesh& mesh) {
    double doubled = 0;
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec2 a(mesh.vertices[t.x]);
        const glm::dvec2 b = glm::dvec2(mesh.vertices[t.y]) - a, c = glm::dvec2(mesh.vertices[t.z]) - a;
        doubled += b.x * c.y - b.y * c.x;
    }
    return doubled / 2;
}

}  // namespace noonmark
