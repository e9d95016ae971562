#include "core/io/terrain/buildings_on_terrain.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "core/city/terrain/tin_terrain.h"
#include "core/geo/frame.h"

namespace noonmark {

namespace {

std::vector<glm::vec2> placesOf(const std::vector<glm::vec3>& points) {
    return {points.begin(), points.end()};
}

// Each pair once, however many triangles share it.
std::vector<std::pair<std::uint32_t, std::uint32_t>> sidesOf(const std::vector<glm::uvec3>& triangles) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
    for (const glm::uvec3 t : triangles)
        for (int i = 0; i < 3; ++i) sides.emplace_back(std::minmax(t[i], t[(i + 1) % 3]));
    std::ranges::sort(sides);
    sides.erase(std::unique(sides.begin(), sides.end()), sides.end());
    return sides;
}

void addCorners(const BasedBuilding& based, std::vector<glm::vec3>& points) {
    for (const Part& part : based.building->parts) {
        if (part.isOverhanging) continue;
        for (const glm::vec2 corner : part.footprint.outer)
            points.emplace_back(corner, based.groundM - float(earthDropM(glm::dvec2(corner))));
    }
}

}  // namespace

BaseRelief measureRelief(std::span<const BasedBuilding> buildings) {
    std::vector<glm::vec3> bases;
    for (const BasedBuilding& based : buildings) {
        const Box2 box = bounds(*based.building);
        bases.emplace_back((box.low + box.high) * 0.5F, based.groundM);
    }
    BaseRelief relief;
    for (const auto& [a, b] : sidesOf(triangulateDelaunay(placesOf(bases)))) {
        if (double(glm::distance(glm::vec2(bases[a]), glm::vec2(bases[b]))) > BaseRelief::neighboursM)
            continue;
        const double off = std::abs(double(bases[a].z) - double(bases[b].z));
        ++relief.pairs;
        relief.uneven += off > BaseRelief::unevenM ? 1 : 0;
        relief.maxM = std::max(relief.maxM, off);
    }
    return relief;
}

std::string formatText(const BaseRelief& relief) {
    return fmt::format(
        "{} of {} pairs of neighbours within {:.0f} m differ by more than {:.0f} m in ground elevation, by "
        "{:.1f} m at most",
        relief.uneven, relief.pairs, BaseRelief::neighboursM, BaseRelief::unevenM, relief.maxM);
}

std::optional<Terrain> interpolateBases(std::span<const BasedBuilding> buildings) {
    TriangleMesh tin;
    for (const BasedBuilding& based : buildings) addCorners(based, tin.vertices);
    // Of coincident corners the first, which is the lowest, is used.
    std::ranges::stable_sort(tin.vertices, {}, &glm::vec3::z);
    tin.triangles = triangulateDelaunay(placesOf(tin.vertices));
    std::optional<TinTerrain> made = rasterizeTin(tin);
    if (!made) return std::nullopt;
    made->terrain.source.method = TerrainMethod::fromBases;
    return std::move(made->terrain);
}

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
