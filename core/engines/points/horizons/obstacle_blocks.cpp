#include "core/engines/points/horizons/obstacle_blocks.h"

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
        std::stable_partition(parts.begin(), parts.end(), [](Obstacles some) { return !some.empty(); });
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

namespace {

EdgeBlock blockOf(const BoxTree::Leaf& leaf, std::span<const TopEdge> edges) {
    EdgeBlock block{};
    block.az.fill(belowAll), block.bz.fill(belowAll);
    for (std::size_t i = 0; i < leaf.size(); ++i) {
        const TopEdge& edge = edges[leaf[i]];
        block.ax[i] = edge.a.x, block.ay[i] = edge.a.y, block.az[i] = edge.a.z;
        block.bx[i] = edge.b.x, block.by[i] = edge.b.y, block.bz[i] = edge.b.z;
        if (edge.oneSided) block.oneSided |= 1U << i;
    }
    return block;
}

FaceBlock blockOf(const BoxTree::Leaf& leaf, std::span<const OverhangFace> faces) {
    FaceBlock block{};
    for (auto& corner : block.z) corner.fill(belowAll);
    for (std::size_t i = 0; i < leaf.size(); ++i)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const glm::vec3 place = faces[leaf[i]].corners[corner];
            block.x[corner][i] = place.x, block.y[corner][i] = place.y, block.z[corner][i] = place.z;
        }
    return block;
}

template <class Tree, class Obstacle>
Tree makeTree(std::span<const Obstacle> obstacles) {
    Tree tree{BoxTree(findBoxes(obstacles)), {}};
    for (const BoxTree::Leaf& leaf : tree.boxes.leaves()) tree.blocks.push_back(blockOf(leaf, obstacles));
    return tree;
}

}  // namespace

EdgeTree makeEdgeTree(std::span<const TopEdge> edges) { return makeTree<EdgeTree>(edges); }
FaceTree makeFaceTree(std::span<const OverhangFace> faces) { return makeTree<FaceTree>(faces); }

}  // namespace noonmark
