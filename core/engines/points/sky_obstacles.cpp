#include "core/engines/points/sky_obstacles.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace noonmark {

namespace {

void addPrism(const Part& part, std::uint32_t building, SkyObstacles& obstacles) {
    const auto addRing = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i)
            obstacles.edges.push_back({glm::vec3(ring[i], part.topM),
                                       glm::vec3(ring[(i + 1) % ring.size()], part.topM), building, true});
    };
    addRing(part.footprint.outer);
    for (const Ring& hole : part.footprint.holes) addRing(hole);
}

// Each edge once, although two triangles share it.
void addMeshEdges(const TriangleMesh& mesh, std::uint32_t building, SkyObstacles& obstacles) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    pairs.reserve(mesh.triangles.size() * 3);
    for (const glm::uvec3 triangle : mesh.triangles)
        for (int i = 0; i < 3; ++i) pairs.emplace_back(std::minmax(triangle[i], triangle[(i + 1) % 3]));
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    for (const auto& [a, b] : pairs)
        obstacles.edges.push_back({mesh.vertices[a], mesh.vertices[b], building, false});
}

void addOverhang(const Part& part, std::uint32_t building, SkyObstacles& obstacles) {
    const TriangleMesh mesh = meshOf(part);
    for (const glm::uvec3 t : mesh.triangles)
        obstacles.faces.push_back({{mesh.vertices[t.x], mesh.vertices[t.y], mesh.vertices[t.z]}, building});
}

}  // namespace

SkyObstacles collectSkyObstacles(const City& city) {
    SkyObstacles obstacles;
    for (std::uint32_t index = 0; index < city.buildings.size(); ++index)
        for (const Part& part : city.buildings[index]->parts) {
            if (part.isOverhanging)
                addOverhang(part, index, obstacles);
            else if (part.mesh)
                addMeshEdges(*part.mesh, index, obstacles);
            else
                addPrism(part, index, obstacles);
        }
    if (city.terrain) addMeshEdges(meshOf(*city.terrain), SkyObstacles::terrain, obstacles);
    return obstacles;
}

std::vector<ObstacleBox> findBoxes(std::span<const TopEdge> edges) {
    std::vector<ObstacleBox> boxes(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) boxes[i].add(edges[i].a), boxes[i].add(edges[i].b);
    return boxes;
}

std::vector<ObstacleBox> findBoxes(std::span<const OverhangFace> faces) {
    std::vector<ObstacleBox> boxes(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (const glm::vec3 corner : faces[i].corners) boxes[i].add(corner);
    return boxes;
}

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

namespace {

/// A face cut by the vertical plane of an azimuth: the ends of the cut, with their distance along the azimuth
/// and their height above the point.
struct FaceCut {
    std::array<glm::dvec2, 2> ends;
    int count = 0;
};

FaceCut cutFace(const OverhangFace& face, glm::dvec3 point, double sine, double cosine) {
    FaceCut cut;
    for (std::size_t i = 0; i < 3 && cut.count < 2; ++i) {
        const glm::dvec3 a = glm::dvec3(face.corners[i]) - point;
        const glm::dvec3 b = glm::dvec3(face.corners[(i + 1) % 3]) - point;
        // Distances to the right of the azimuth's line; half-open, so that a corner is crossed once.
        const double aRight = a.x * cosine - a.y * sine, bRight = b.x * cosine - b.y * sine;
        if ((aRight < 0) == (bRight < 0)) continue;
        const glm::dvec3 place = a + aRight / (aRight - bRight) * (b - a);
        cut.ends[std::size_t(cut.count++)] = {place.x * sine + place.y * cosine, place.z};
    }
    return cut;
}

}  // namespace

std::optional<HiddenAltitudes> hiddenBy(const OverhangFace& face, glm::dvec3 point, double azimuth) {
    return hiddenBy(face, point, {std::sin(azimuth), std::cos(azimuth)});
}

std::optional<HiddenAltitudes> hiddenBy(const OverhangFace& face, glm::dvec3 point, glm::dvec2 direction) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const FaceCut cut = cutFace(face, point, direction.x, direction.y);
    if (cut.count < 2) return std::nullopt;
    const auto [near, far] = std::minmax(cut.ends[0], cut.ends[1], [](auto a, auto b) { return a.x < b.x; });
    if (far.x <= 0) return std::nullopt;  // behind the point
    const double farTan = far.y / far.x;
    HiddenAltitudes hidden{farTan, infinite};
    if (near.x > 0) {
        const double nearTan = near.y / near.x;
        hidden = {std::min(nearTan, farTan), std::max(nearTan, farTan)};
    } else if (near.y + (far.y - near.y) * (-near.x) / (far.x - near.x) <= 0) {
        hidden = {0, farTan};  // the face passes below the point, otherwise it covers the zenith
    }
    if (hidden.highTan <= 0) return std::nullopt;
    hidden.lowTan = std::max(0.0, hidden.lowTan);
    return hidden;
}

void joinOverlaps(std::vector<HiddenAltitudes>& hidden) {
    std::ranges::sort(hidden, {}, &HiddenAltitudes::lowTan);
    std::size_t last = 0;
    for (std::size_t i = 1; i < hidden.size(); ++i) {
        if (hidden[i].lowTan <= hidden[last].highTan)
            hidden[last].highTan = std::max(hidden[last].highTan, hidden[i].highTan);
        else
            hidden[++last] = hidden[i];
    }
    if (!hidden.empty()) hidden.resize(last + 1);
}

}  // namespace noonmark
