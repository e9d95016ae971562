#include "core/engines/points/sky_obstacles.h"

#include <algorithm>
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

}  // namespace noonmark
