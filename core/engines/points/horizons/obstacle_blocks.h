#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/points/horizons/box_tree.h"
#include "core/engines/points/sky_obstacles.h"

namespace noonmark {

/// Up to eight obstacles of one leaf, each coordinate of the eight side by side; local metres. Lanes without
/// an obstacle lie below everything.
struct EdgeBlock {
    std::array<float, BoxTree::width> ax, ay, az, bx, by, bz;
    std::uint32_t oneSided;  ///< bit k: TopEdge::oneSided of edge k
};
struct FaceBlock {
    std::array<std::array<float, BoxTree::width>, 3> x, y, z;  ///< of the corners
};

/// Obstacles in a tree. blocks[k] are those of leaf k. O(n log n) to make.
template <class Block>
struct BlockTree {
    BoxTree boxes;
    std::vector<Block> blocks;
};
using EdgeTree = BlockTree<EdgeBlock>;
using FaceTree = BlockTree<FaceBlock>;

EdgeTree makeEdgeTree(std::span<const TopEdge> edges);
FaceTree makeFaceTree(std::span<const OverhangFace> faces);

}  // namespace noonmark
