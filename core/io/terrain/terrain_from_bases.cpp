#include "core/io/terrain/terrain_from_bases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "core/city/terrain/delaunay.h"
#include "core/city/terrain/tin_terrain.h"
#include "core/geo/earth_drop.h"

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

}  // namespace noonmark
