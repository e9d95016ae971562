#include "core/io/terrain/stand_on_terrain.h"

#include <algorithm>
#include <cmath>

#include "core/geo/earth_drop.h"

namespace noonmark {

namespace {

constexpr int maxSamplesAcross = 32;

float lowestAtCorners(const Footprint& footprint, const Terrain& terrain) {
    float lowest = 1e30F;
    for (const glm::vec2 corner : footprint.outer)
        lowest = std::min(lowest, elevationAt(terrain, glm::dvec2(corner)));
    return lowest;
}

float lowestInside(const Footprint& footprint, const Terrain& terrain) {
    const Box2 box = bounds(footprint);
    const glm::dvec2 size = glm::dvec2(box.high) - glm::dvec2(box.low);
    const double step = std::max({terrain.grid.cellM, size.x / maxSamplesAcross, size.y / maxSamplesAcross});
    float lowest = 1e30F;
    for (double y = double(box.low.y) + step / 2; y < double(box.high.y); y += step)
        for (double x = double(box.low.x) + step / 2; x < double(box.high.x); x += step)
            if (contains(footprint, {x, y})) lowest = std::min(lowest, elevationAt(terrain, {x, y}));
    return lowest;
}

std::shared_ptr<const TriangleMesh> liftMesh(const TriangleMesh& mesh, float byM) {
    auto moved = std::make_shared<TriangleMesh>(mesh);
    for (glm::vec3& vertex : moved->vertices) vertex.z += byM;
    return moved;
}

}  // namespace

void lift(Building& building, float byM) {
    if (byM == 0) return;
    for (Part& part : building.parts) {
        part.bottomM += byM;
        part.topM += byM;
        if (part.mesh) part.mesh = liftMesh(*part.mesh, byM);
    }
}

float findLowestGround(const Building& building, const Terrain& terrain) {
    float lowest = 1e30F;
    for (const Part& part : building.parts)
        lowest = std::min(
            {lowest, lowestAtCorners(part.footprint, terrain), lowestInside(part.footprint, terrain)});
    return lowest;
}

Building standOnTerrain(Building building, std::optional<float> groundM, const Terrain* terrain) {
    if (building.parts.empty()) return building;
    if (terrain == nullptr) {
        lift(building, -groundM.value_or(0));
        return building;
    }
    const float lowest = findLowestGround(building, *terrain);
    if (groundM) {
        const Box2 box = bounds(building);
        const auto drop = float(earthDropM(glm::dvec2(box.low + box.high) / 2.0));
        lift(building, -drop);
        groundM = *groundM - drop;
    } else {
        lift(building, lowest);
    }
    for (Part& part : building.parts)
        if (groundM && !part.isOverhanging && !part.mesh && part.bottomM <= *groundM)
            part.bottomM = std::min(part.bottomM, lowest);
    return building;
}

}  // namespace noonmark
