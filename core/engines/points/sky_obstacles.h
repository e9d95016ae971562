#pragma once

// The folder core/engines/points measures sunlight and sky at single points on any surface. This file lists
// what can hide the sky, and edges as a point sees them; skyline.h is the exact skyline of one point, made of
// these edges; sky_factors.h integrates the visible sky over it, and point_sunlight.h finds when the sun
// reaches the point. For many points, point_horizons.h counts minutes from horizons by bins of azimuth
// (folder horizons), and point_sunlight.h finds at which steps they are in shadow.

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "core/city/city.h"

namespace noonmark {

/// An edge with solid below it, down to the ground: of a roof, of a mesh that stands on the ground, of the
/// terrain.
struct TopEdge {
    glm::vec3 a, b;
    std::uint32_t building = 0;  ///< index in City::buildings, or SkyObstacles::terrain
    /// The top of a prism's wall, with the interior to the left of a -> b: hides nothing from behind.
    bool oneSided = false;
};

/// A triangle of an overhang: the sky is seen below it.
struct OverhangFace {
    std::array<glm::vec3, 3> corners;
    std::uint32_t building = 0;
};

/// Everything that can hide the sky, in local metres. The same solids as the horizon sweep: a part that is
/// not an overhang is solid down to the ground.
struct SkyObstacles {
    static constexpr std::uint32_t terrain = 0xFFFFFFFF;
    static constexpr std::uint32_t ownWall =
        0xFFFFFFFE;  ///< the surface of the point faces away from the sun
    std::vector<TopEdge> edges;
    std::vector<OverhangFace> faces;
};

/// O(points of the parts + posts of the terrain); 5 ms for Midtown's 8,000 buildings.
SkyObstacles collectSkyObstacles(const City& city);

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

std::vector<ObstacleBox> findBoxes(std::span<const TopEdge> edges);
std::vector<ObstacleBox> findBoxes(std::span<const OverhangFace> faces);

/// Obstacles with trees over them, for the skylines of many points: the nearest obstacles hide most others,
/// which are then left out by the box. O(n log n) to make.
struct SkyTrees {
    SkyObstacles obstacles;
    ObstacleTree edges, faces;

    explicit SkyTrees(SkyObstacles all)
        : obstacles(std::move(all)), edges(findBoxes(obstacles.edges)), faces(findBoxes(obstacles.faces)) {}
};

/// Altitudes that something hides at one azimuth, as tangents: those between low and high.
struct HiddenAltitudes {
    double lowTan = 0;
    double highTan = 0;  ///< infinite: up to the zenith
    bool operator==(const HiddenAltitudes&) const = default;
};

/// What a face hides at an azimuth above the point's level; none where it is not seen.
std::optional<HiddenAltitudes> hiddenBy(const OverhangFace& face, glm::dvec3 point, double azimuth);
/// The same with (sine, cosine) of the azimuth, for many faces at one.
std::optional<HiddenAltitudes> hiddenBy(const OverhangFace& face, glm::dvec3 point, glm::dvec2 direction);

/// Sorts the intervals and joins those that overlap.
void joinOverlaps(std::vector<HiddenAltitudes>& hidden);

/// A straight edge as seen from a point. An edge lies in a plane through the point, so the tangent of its
/// altitude is east sin(azimuth) + north cos(azimuth): exact, without bins.
struct SeenEdge {
    double from = 0,
           to = 0;  ///< azimuths, radians from north, clockwise; 0 <= from < 2 pi, from < to < from + pi
    double east = 0, north = 0;
    std::uint32_t building = 0;

    [[nodiscard]] double tanAt(double azimuth) const {
        return east * std::sin(azimuth) + north * std::cos(azimuth);
    }
};

inline constexpr double fullTurn = 2 * std::numbers::pi;

/// 0 <= azimuth < 2 pi
inline double azimuthOf(glm::dvec3 direction) {
    const double azimuth = std::atan2(direction.x, direction.y);
    return azimuth < 0 ? azimuth + fullTurn : azimuth;
}

/// The edge between two places given relative to the point. None if it is seen end-on.
inline std::optional<SeenEdge> seeEdge(glm::dvec3 a, glm::dvec3 b, std::uint32_t building) {
    const double turn = a.y * b.x - a.x * b.y;  // positive: b is clockwise of a
    constexpr double endOn = 1e-12;             // square metres
    if (std::abs(turn) < endOn) return std::nullopt;
    SeenEdge edge{.east = (b.z * a.y - a.z * b.y) / turn,
                  .north = (a.z * b.x - b.z * a.x) / turn,
                  .building = building};
    edge.from = azimuthOf(turn > 0 ? a : b);
    edge.to = azimuthOf(turn > 0 ? b : a);
    if (edge.to < edge.from) edge.to += fullTurn;
    if (!(edge.to > edge.from)) return std::nullopt;
    return edge;
}

/// The edge as seen from a point; none if it hides nothing above the point's level.
inline std::optional<SeenEdge> seeEdge(const TopEdge& edge, glm::dvec3 point) {
    const glm::dvec3 a = glm::dvec3(edge.a) - point, b = glm::dvec3(edge.b) - point;
    if (a.z <= 0 && b.z <= 0) return std::nullopt;
    if (edge.oneSided && a.x * b.y - a.y * b.x > 0)
        return std::nullopt;  // the point is on the interior's side
    return seeEdge(a, b, edge.building);
}

}  // namespace noonmark
