#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/points/obstacle_tree.h"

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

}  // namespace noonmark
