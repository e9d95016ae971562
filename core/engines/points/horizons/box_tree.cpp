#include "core/engines/points/horizons/box_tree.h"

#include <algorithm>
#include <numeric>

namespace noonmark {

namespace {

constexpr std::size_t width = BoxTree::width;
constexpr float belowAll = -1e30F;

BoxTree::Node emptyNode() {
    BoxTree::Node node{};
    node.topZ.fill(belowAll);
    return node;
}

}  // namespace

struct BoxTree::Builder {
    using Obstacles = std::span<std::uint32_t>;  // indices

    BoxTree& tree;
    std::span<const ObstacleBox> boxes;

    // The first half fills whole leaves.
    [[nodiscard]] std::array<Obstacles, 2> halve(Obstacles part) const {
        if (part.size() <= width) return {part, {}};
        ObstacleBox middles;
        for (const std::uint32_t i : part) middles.add(boxes[i].middle());
        const glm::vec3 size = middles.high - middles.low;
        const int axis = size.x >= size.y ? 0 : 1;
        const std::size_t half = (part.size() / 2 + width - 1) / width * width;
        std::ranges::nth_element(part, part.begin() + std::ptrdiff_t(half), {},
                                 [&](std::uint32_t i) { return boxes[i].middle()[axis]; });
        return {part.first(half), part.subspan(half)};
    }

    // Empty parts come last.
    [[nodiscard]] std::array<Obstacles, width> divide(Obstacles part) const {
        std::array<Obstacles, width> parts{part};
        for (std::size_t count = 1; count < width; count *= 2)
            for (std::size_t i = count; i-- > 0;) {
                const auto halves = halve(parts[i]);
                parts[2 * i] = halves[0], parts[2 * i + 1] = halves[1];
            }
        std::ranges::stable_partition(parts, [](Obstacles some) { return !some.empty(); });
        return parts;
    }

    std::uint32_t addLeaf(Obstacles part) {
        tree.leaves_.emplace_back(part.begin(), part.end());
        return std::uint32_t(tree.leaves_.size() - 1) | leafBit;
    }

    std::uint32_t addNode(Obstacles part) {
        const auto at = std::uint32_t(tree.nodes_.size());
        tree.nodes_.push_back(emptyNode());
        const auto parts = divide(part);
        for (std::size_t i = 0; i < width && !parts[i].empty(); ++i) {
            ObstacleBox box;
            for (const std::uint32_t obstacle : parts[i]) box.add(boxes[obstacle]);
            const std::uint32_t child = parts[i].size() <= width ? addLeaf(parts[i]) : addNode(parts[i]);
            Node& node = tree.nodes_[at];
            node.lowX[i] = box.low.x, node.lowY[i] = box.low.y;
            node.highX[i] = box.high.x, node.highY[i] = box.high.y, node.topZ[i] = box.high.z;
            node.child[i] = child;
        }
        return at;
    }
};

BoxTree::BoxTree(std::span<const ObstacleBox> boxes) {
    if (boxes.empty()) return;
    std::vector<std::uint32_t> order(boxes.size());
    std::iota(order.begin(), order.end(), 0U);
    Builder{*this, boxes}.addNode(order);
}

}  // namespace noonmark
