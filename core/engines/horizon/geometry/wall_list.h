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

/// A wall of a prism that stands on the ground. In cells of a grid: the centre of cell (column, row) is at
/// (column, row).
struct StandingWall {
    glm::dvec2 a, b;  ///< the interior is to the left of a -> b
};

/// The walls of one prism, all of the same height.
struct StandingPrism {
    std::uint32_t firstWall = 0;  ///< index in WallList::walls
    std::uint32_t wallCount = 0;
    float topM = 0;              ///< above the list's datum
    std::uint32_t building = 0;  ///< number given by the caller that adds the building
    glm::dvec2 low{}, high{};    ///< bounds in cells
};

/// Occluders that stand on the ground.
struct WallList {
    double datumM = 0;  ///< local z from which heights are measured
    std::vector<StandingPrism> prisms;
    std::vector<StandingWall> walls;
    std::vector<StandingSolid> solids;            ///< general meshes that stand on the ground
    std::shared_ptr<const TerrainEdges> terrain;  ///< null: flat
    std::uint32_t terrainNumber = 0;              ///< takes the place of a building's number

    [[nodiscard]] std::span<const StandingWall> wallsOf(const StandingPrism& prism) const {
        return std::span(walls).subspan(prism.firstWall, prism.wallCount);
    }
};

/// Some or all of the occluders that a list contains or has contained.
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

/// An overhang, which walls cannot describe.
struct OverhangPart {
    const Part* part;        ///< not owned
    std::uint32_t building;  ///< number given by the caller that adds the building
};
using OverhangParts = std::vector<OverhangPart>;

/// Adds the parts of a building, each extended down to the ground. A part that stands on another part of its
/// building is treated the same way, since the space below it is solid. Overhangs go to `overhangs`, general
/// meshes that stand on the ground to the list's solids; parts that end below the datum are left out.
void addStandingWalls(const Building& building, std::uint32_t number, const Grid& grid, WallList& list,
                      OverhangParts& overhangs);

/// Collects the occluders of the receivers: the parts of these buildings that stand on the ground, numbered
/// by index in the city, and the terrain, whose number is one after the last building's. The datum is the
/// height of the lowest receiver. Overhangs go to `overhangs`.
WallList collectStandingObstacles(const City& city, std::span<const std::uint32_t> buildings,
                                  const Receivers& receivers, OverhangParts& overhangs);

}  // namespace noonmark
