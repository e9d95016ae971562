#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "core/city/city.h"
#include "core/receivers/grid.h"
#include "core/result.h"

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
    float topM = 0;
    std::uint32_t building = 0;  ///< as its adder numbers them
    glm::dvec2 low{}, high{};    ///< bounds, cells
};

struct WallList {
    std::vector<StandingPrism> prisms;
    std::vector<StandingWall> walls;

    [[nodiscard]] std::span<const StandingWall> wallsOf(const StandingPrism& prism) const {
        return std::span(walls).subspan(prism.firstWall, prism.wallCount);
    }
};

/// What walls cannot describe: parts that hang or are general meshes. Not owned.
using OpenParts = std::vector<const Part*>;

/// Adds the prisms of a building, each taken from the ground up. A part that starts on another of its
/// building is taken so too: what is below it is solid. Parts that hang or are general meshes go to `open`;
/// where that is null they are an error: a horizon cannot say what they hide.
Result<void> addStandingWalls(const Building& building, std::uint32_t number, const Grid& grid,
                              WallList& list, OpenParts* open = nullptr);

/// The prisms of some buildings, numbered by their index in the city.
Result<WallList> standingWalls(const City& city, std::span<const std::uint32_t> buildings, const Grid& grid,
                               OpenParts* open = nullptr);

}  // namespace noonmark
