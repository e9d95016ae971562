#include "core/engines/points/sky_obstacles.h"

#include <algorithm>
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

}  // namespace noonmark
