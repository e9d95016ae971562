#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/points/sky_obstacles.h"

namespace noonmark {

/// Boxes within boxes over a list of obstacles, laid out for kernels: a node holds up to eight boxes, each
/// coordinate of the eight side by side, and a leaf up to eight obstacles.
class BoxTree {
public:
    static constexpr std::size_t width = 8;
    /// Boxes that can await their visit: 2^32 obstacles have 11 levels, each of which leaves `width` - 1.
    static constexpr std::size_t maxUnvisited = 11 * (width - 1) + 1;
    static constexpr std::uint32_t leafBit = 0x80000000U;

    /// Local metres. Lanes without a box have their top below everything.
    struct Node {
        std::array<float, width> lowX, lowY, highX, highY, topZ;
        std::array<std::uint32_t, width> child;  ///< index in nodes(), with leafBit in leaves()
    };
    /// Indices of obstacles.
    using Leaf = std::vector<std::uint32_t>;

    /// `boxes`: of each obstacle. O(n log n).
    explicit BoxTree(std::span<const ObstacleBox> boxes);

    /// The first is the root. Empty: there are no obstacles.
    [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
    [[nodiscard]] const std::vector<Leaf>& leaves() const { return leaves_; }

private:
    struct Builder;

    std::vector<Node> nodes_;
    std::vector<Leaf> leaves_;
};

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
