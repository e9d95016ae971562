#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <unordered_map>

#include "core/city/meshes/mesh_topology.h"

namespace noonmark {

namespace {

using Index = std::uint32_t;
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

}  // namespace noonmark
