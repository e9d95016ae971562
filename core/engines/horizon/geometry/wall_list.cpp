#include "core/engines/horizon/geometry/wall_list.h"

#include <glm/common.hpp>

#include "core/engines/ray/ray_scene.h"

namespace noonmark {

namespace {

class WallBuilder {
public:
    WallBuilder(const Grid& grid, WallList& list) : grid_(grid), list_(list) {}

    void add(const Part& part, std::uint32_t building) {
        StandingPrism prism{.firstWall = std::uint32_t(list_.walls.size()),
                            .topM = float(double(part.topM) - list_.datumM),
                            .building = building,
                            .low = glm::dvec2(1e30),
                            .high = glm::dvec2(-1e30)};
        addRing(part.footprint.outer, prism);
        for (const Ring& hole : part.footprint.holes) addRing(hole, prism);
        prism.wallCount = std::uint32_t(list_.walls.size()) - prism.firstWall;
        list_.prisms.push_back(prism);
    }

private:
    void addRing(const Ring& ring, StandingPrism& prism) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2 a = toCells(ring[i]);
            list_.walls.push_back({a, toCells(ring[(i + 1) % ring.size()])});
            prism.low = glm::min(prism.low, a);
            prism.high = glm::max(prism.high, a);
        }
    }

    // Receivers are offset to the east and north of cell centres by as much as those of the rays, so that
    // none lies on a wall.
    [[nodiscard]] glm::dvec2 toCells(glm::vec2 local) const {
        const glm::dvec2 beside = glm::dvec2(local) - double(RayScene::asideM);
        return {(beside.x - grid_.westM) / grid_.cellM - 0.5, (beside.y - grid_.southM) / grid_.cellM - 0.5};
    }

    const Grid& grid_;
    WallList& list_;
};

}  // namespace

void addStandingWalls(const Building& building, std::uint32_t number, const Grid& grid, WallList& list,
                      OverhangParts& overhangs) {
    WallBuilder builder(grid, list);
    for (const Part& part : building.parts) {
        if (double(part.topM) <= list.datumM) continue;
        if (part.isOverhanging)
            overhangs.push_back({&part, number});
        else if (part.mesh)
            list.solids.push_back(makeStandingSolid(*part.mesh, number, grid, list.datumM));
        else
            builder.add(part, number);
    }
}

WallList collectStandingObstacles(const City& city, std::span<const std::uint32_t> buildings,
                                  const Receivers& receivers, OverhangParts& overhangs) {
    WallList list{.datumM = lowestGroundM(receivers), .terrainNumber = std::uint32_t(city.buildings.size())};
    for (const std::uint32_t index : buildings)
        addStandingWalls(*city.buildings[index], index, receivers.grid, list, overhangs);
    if (city.terrain)
        list.terrain = std::make_shared<const TerrainEdges>(city.terrain, receivers.grid, list.datumM);
    return list;
}

}  // namespace noonmark
