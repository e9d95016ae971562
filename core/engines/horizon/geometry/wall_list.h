#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/city/city.h"
#include "core/engines/horizon/geometry/solid_edges.h"
#include "core/engines/horizon/geometry/terrain_edges.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// A wall of a prism that stands on the ground. Cells of a grid: the centre of cell (column, row) is at
/// (column, row).
struct StandingWall {
    glm::dvec2 a, b;  ///< left of a -> b is inside
};

/// Walls of one prism, all of one height.
struct StandingPrism {
    std::uint32_t firstWall = 0;  ///< into WallList::walls
    std::uint32_t wallCount = 0;
    float topM = 0;              ///< above the list's datum
    std::uint32_t building = 0;  ///< as its adder numbers them
    glm::dvec2 low{}, high{};    ///< bounds, cells
};

/// What stands on the ground and may hide the sun.
struct WallList {
    double datumM = 0;  ///< local z that heights count from
    std::vector<StandingPrism> prisms;
    std::vector<StandingWall> walls;
    std::vector<StandingSolid> solids;            ///< general meshes that stand
    std::shared_ptr<const TerrainEdges> terrain;  ///< null: flat
    std::uint32_t terrainNumber = 0;              ///< in the place of a building's

    [[nodiscard]] std::span<const StandingWall> wallsOf(const StandingPrism& prism) const {
        return std::span(walls).subspan(prism.firstWall, prism.wallCount);
    }
};

/// Some or all that a list holds, or held.
struct Obstacles {
    std::span<const StandingPrism> prisms;  ///< their walls are in the list
    std::span<const StandingSolid> solids;
    const TerrainEdges* terrain = nullptr;

    /// Whether all are prisms on level ground.
    [[nodiscard]] bool even() const { return solids.empty() && terrain == nullptr; }
};
inline Obstacles listAllObstacles(const WallList& list) {
    return {list.prisms, list.solids, list.terrain.get()};
}

/// What walls cannot describe: a part that hangs.
struct OverhangPart {
    const Part* part;        ///< not owned
    std::uint32_t building;  ///< as its adder numbers them
};
using OverhangParts = std::vector<OverhangPart>;

/// Adds the parts of a building, each taken from the ground up. A part that starts on another of its
/// building is taken so too: what is below it is solid. Parts that hang go to `open`, general meshes that
/// stand to the list's solids; what ends below the datum is left out.
void addStandingWalls(const Building& building, std::uint32_t number, const Grid& grid, WallList& list,
                      OverhangParts& overhangs);

/// What may hide the sun from receivers: what stands of some buildings, numbered by their index in the city,
/// and its terrain, which has the number after the last building's. The datum is the lowest receiver's. Parts
/// that hang go to `open`.
WallList collectStandingObstacles(const City& city, std::span<const std::uint32_t> buildings,
                                  const Receivers& receivers, OverhangParts& overhangs);

}  // namespace noonmark
