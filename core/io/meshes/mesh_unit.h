#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "core/city/meshes/mesh_outline.h"
#include "core/city/meshes/mesh_topology.h"

namespace noonmark {

/// The geometry of one building of a mesh file.
struct MeshUnit {
    TriangleMesh mesh;
    std::size_t object = 0;  ///< index of the object that gives its name
};

/// Points nearer to each other than this are one, metres.
inline constexpr float touchM = 0.01F;

/// What a mesh covers in plan.
inline std::vector<Footprint> computeCover(const TriangleMesh& mesh) {
    return computeOutline(mesh, findOpenEdges(mesh) == 0).pieces;
}

/// Sets of indices that are joined pair by pair. The lowest index of a set stands for it.
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t(0));
    }
    std::size_t of(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) {
        a = of(a), b = of(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::size_t> parent_;
};

/// An edge as the indices of its welded ends, in either direction.
inline std::uint64_t edgeOf(std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t(std::min(a, b)) << 32U) | std::max(a, b);
}

}  // namespace noonmark
