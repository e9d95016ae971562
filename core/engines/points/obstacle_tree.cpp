#include "core/engines/points/obstacle_tree.h"

#include <algorithm>
#include <numeric>

namespace noonmark {

ObstacleTree::ObstacleTree(std::span<const ObstacleBox> boxes) : order_(boxes.size()) {
    if (boxes.empty()) return;
    std::iota(order_.begin(), order_.end(), 0U);
    nodes_.reserve(boxes.size() / 2 + 2);
    nodes_.emplace_back();
    split(0, 0, std::uint32_t(boxes.size()), boxes);
}

void ObstacleTree::split(std::uint32_t node, std::uint32_t first, std::uint32_t count,
                         std::span<const ObstacleBox> boxes) {
    ObstacleBox box, middles;
    for (std::uint32_t i = first; i < first + count; ++i) {
        box.add(boxes[order_[i]]);
        middles.add(boxes[order_[i]].middle());
    }
    nodes_[node].box = box;
    if (count <= leafSize) {
        nodes_[node].first = first;
        nodes_[node].count = count;
        return;
    }
    const glm::vec3 size = middles.high - middles.low;
    const int axis = size.x >= size.y ? 0 : 1;
    const std::uint32_t half = count / 2;
    std::nth_element(
        order_.begin() + first, order_.begin() + first + half, order_.begin() + first + count,
        [&](std::uint32_t a, std::uint32_t b) { return boxes[a].middle()[axis] < boxes[b].middle()[axis]; });
    const auto children = std::uint32_t(nodes_.size());
    nodes_.emplace_back();
    nodes_.emplace_back();
    nodes_[node].first = children;
    nodes_[node].count = 0;
    split(children, first, half, boxes);
    split(children + 1, first + half, count - half, boxes);
}

}  // namespace noonmark
