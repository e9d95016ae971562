#include "core/engines/projected/casters/convex_pieces.h"

#include <algorithm>

namespace noonmark {

namespace {

// Positive if the path from a through b to c turns left.
double turn(glm::vec2 a, glm::vec2 b, glm::vec2 c) {
    const glm::dvec2 u = glm::dvec2(b) - glm::dvec2(a), v = glm::dvec2(c) - glm::dvec2(b);
    return u.x * v.y - u.y * v.x;
}

/// Cuts one ring into pieces, from point to point.
class RingCutter {
public:
    RingCutter(const Ring& ring, const Ring& obstacles, std::size_t maxPoints)
        : ring_(ring), obstacles_(obstacles), maxPoints_(maxPoints) {}

    void cut(std::vector<Ring>& pieces) {
        const std::size_t start = firstPoint();
        for (std::size_t at = 0; at < ring_.size();) {
            const std::size_t edges = std::min(edgesFrom(start + at), ring_.size() - at);
            Ring& piece = pieces.emplace_back();
            for (std::size_t i = 0; i <= edges; ++i) piece.push_back(point(start + at + i));
            at += edges;
        }
    }

private:
    [[nodiscard]] glm::vec2 point(std::size_t i) const { return ring_[i % ring_.size()]; }

    // A piece ends where the ring turns right. Starting at such a point avoids splitting a piece at the
    // start.
    [[nodiscard]] std::size_t firstPoint() const {
        for (std::size_t i = 0; i < ring_.size(); ++i)
            if (turn(point(i + ring_.size() - 1), point(i), point(i + 1)) < 0) return i;
        return 0;
    }

    // Number of edges that a piece can have from this point on.
    [[nodiscard]] std::size_t edgesFrom(std::size_t first) const {
        std::size_t edges = 1;
        while (edges + 2 <= std::min(maxPoints_, ring_.size()) && canGrow(first, first + edges)) ++edges;
        return edges;
    }

    // Whether the next point can be added to the piece from `first` to `last`.
    [[nodiscard]] bool canGrow(std::size_t first, std::size_t last) const {
        const glm::vec2 a = point(first), b = point(last), c = point(last + 1);
        return turn(point(last - 1), b, c) >= 0 && turn(b, c, a) >= 0 && turn(c, a, point(first + 1)) >= 0 &&
               isFree(a, b, c);
    }

    // Only points that turn right, or points of holes, can lie inside.
    [[nodiscard]] bool isFree(glm::vec2 a, glm::vec2 b, glm::vec2 c) const {
        return std::ranges::none_of(obstacles_, [&](glm::vec2 p) {
            return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
                   turn(c, a, p) >= 0;
        });
    }

    const Ring& ring_;
    const Ring& obstacles_;
    std::size_t maxPoints_;
};

Ring obstaclesIn(const Footprint& footprint) {
    Ring points;
    const Ring& ring = footprint.outer;
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (turn(ring[(i + ring.size() - 1) % ring.size()], ring[i], ring[(i + 1) % ring.size()]) < 0)
            points.push_back(ring[i]);
    for (const Ring& hole : footprint.holes) points.insert(points.end(), hole.begin(), hole.end());
    return points;
}

}  // namespace

bool isConvex(const Footprint& footprint) {
    const Ring& ring = footprint.outer;
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (turn(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]) < 0) return false;
    return footprint.holes.empty();
}

std::vector<Ring> splitIntoConvexPieces(const Footprint& footprint, std::size_t maxPoints) {
    const Ring obstacles = obstaclesIn(footprint);
    std::vector<Ring> pieces;
    RingCutter(footprint.outer, obstacles, maxPoints).cut(pieces);
    for (const Ring& hole : footprint.holes) RingCutter(hole, obstacles, maxPoints).cut(pieces);
    return pieces;
}

}  // namespace noonmark
