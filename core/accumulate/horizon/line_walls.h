#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/accumulate/horizon/sheared_tile.h"
#include "core/accumulate/horizon/wall_list.h"

namespace noonmark {

/// A wall that faces away from the sun, in a sheared tile.
struct LineWall {
    double lowQ, highQ;  ///< it shades lowQ <= q < highQ
    double along0;       ///< `along` of the wall at lowQ
    double highAlong;    ///< highest `along` of the wall
    double slope;        ///< of `along` against q
    float rise;          ///< height, such that rise / (distance in `along`) is the tangent of the horizon
    float nearest;  ///< it shades cells at a greater distance; below 0 where a cell on the wall is behind it
    float reach;    ///< in `along`: beyond, the horizon is below the bin's lowest sun
};

/// The walls that matter to a tile in one bin, and for each line of the tile those that cross it.
class LineWalls {
public:
    /// Replaces what is there. `cellM`: metres a cell.
    void find(const WallList& list, const ShearedTile& tile, double cellM, float lowestTan);

    [[nodiscard]] const LineWall& wall(std::uint32_t index) const { return walls_[index]; }
    [[nodiscard]] std::span<const std::uint32_t> at(int line) const {
        return std::span(ids_).subspan(starts_[std::size_t(line)],
                                       starts_[std::size_t(line) + 1] - starts_[std::size_t(line)]);
    }
    [[nodiscard]] std::uint64_t prismsOutOfReach() const { return outOfReach_; }

private:
    void addPrism(const WallList& list, const StandingPrism& prism, const ShearedTile& tile);
    void addWall(const ShearedTile::Point& a, const ShearedTile::Point& b, float nearest);
    void sortIntoLines();

    float rise_ = 0, reach_ = 0;  // of the prism at hand
    double alongPerMetre_ = 0;
    float lowestTan_ = 0;
    int lines_ = 0, length_ = 0;
    std::uint64_t outOfReach_ = 0;
    std::vector<LineWall> walls_;
    std::vector<std::uint32_t> starts_, ids_;
};

}  // namespace noonmark
