#pragma once

#include <cstdint>
#include <functional>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace noonmark {

/// An axis-aligned box in local metres.
struct ObstacleBox {
    glm::vec3 low{1e30F}, high{-1e30F};
    void add(glm::vec3 place) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    void add(const ObstacleBox& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
    [[nodiscard]] glm::vec3 middle() const { return (low + high) * 0.5F; }
};

/// Boxes within boxes over a list of obstacles, to visit the nearest first and to leave out at once what
/// others hide.
class ObstacleTree {
public:
    static constexpr std::uint32_t leafSize = 8;

    /// `boxes`: of each obstacle. O(n log n).
    explicit ObstacleTree(std::span<const ObstacleBox> boxes);

    /// Visits obstacles from near to far, roughly. `canMatter(box)`: false leaves out all that is in the box;
    /// `visit(index)`: an obstacle.
    template <class CanMatter, class Visit>
    void visitNearestFirst(glm::vec3 eye, const CanMatter& canMatter, const Visit& visit) const {
        if (nodes_.empty()) return;
        std::uint32_t stack[64];  // the tree halves the list: its depth is below 32
        int depth = 0;
        stack[depth++] = 0;
        while (depth > 0) {
            const Node& node = nodes_[stack[--depth]];
            if (!canMatter(node.box)) continue;
            if (node.count > 0) {
                for (std::uint32_t i = 0; i < node.count; ++i) visit(order_[node.first + i]);
                continue;
            }
            const std::uint32_t left = node.first, right = node.first + 1;
            const bool leftNearer = distance2(nodes_[left].box, eye) <= distance2(nodes_[right].box, eye);
            stack[depth++] = leftNearer ? right : left;
            stack[depth++] = leftNearer ? left : right;
        }
    }

    /// Square of the level distance of a box, square metres; 0 above and below it.
    static float distance2(const ObstacleBox& box, glm::vec3 eye) {
        const float x = glm::max(0.0F, glm::max(box.low.x - eye.x, eye.x - box.high.x));
        const float y = glm::max(0.0F, glm::max(box.low.y - eye.y, eye.y - box.high.y));
        return x * x + y * y;
    }

private:
    struct Node {
        ObstacleBox box;
        std::uint32_t first = 0;  // of a leaf: index in order_; otherwise the first of two nodes
        std::uint32_t count = 0;  // of a leaf, otherwise 0
    };
    void split(std::uint32_t node, std::uint32_t first, std::uint32_t count,
               std::span<const ObstacleBox> boxes);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

}  // namespace noonmark
