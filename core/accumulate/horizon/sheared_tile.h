#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "core/accumulate/horizon/lanes16.h"

namespace noonmark {

/// A rectangle of cells of a grid.
struct TileBox {
    int firstColumn = 0;
    int firstRow = 0;
    int columns = 0;
    int rows = 0;
};

/// A tile of cells, sheared so that shadows of one azimuth run along its lines.
///
/// Of the two axes of the grid `along` is the one that is nearer to the direction of the shadows, turned so
/// that they run towards higher `along`; `across` is the other. q = across - k along + offset is the same for
/// all points of one shadow. Line c holds the cells with c <= q < c + 1: just one for each `along`.
class ShearedTile {
public:
    /// `away`: unit vector that shadows run along.
    ShearedTile(const TileBox& box, glm::dvec2 away);

    /// A point in the sheared tile.
    struct Point {
        double q;
        double along;
    };
    [[nodiscard]] Point from(glm::dvec2 cells) const;

    [[nodiscard]] int lines() const { return lines_; }
    [[nodiscard]] int length() const { return alongs_; }  ///< cells of a line, inside the tile or not
    [[nodiscard]] int width() const { return acrosses_; }
    [[nodiscard]] bool swapped() const { return swapped_; }    ///< along is x
    [[nodiscard]] bool mirrored() const { return mirrored_; }  ///< whether the shear turned the plane over
    /// Of a distance along the azimuth, the part along `along`: 0.7 to 1.
    [[nodiscard]] double alongPerDistance() const { return alongPerDistance_; }

    /// q - c of a line's cell at each `along`, 0 to 1; on a cache line, padded to whole ones.
    [[nodiscard]] const float* fractions() const { return fractions_.front().values; }
    /// `across` of the cell of line `line` at `along`; outside [0, width) there is no cell of the tile.
    [[nodiscard]] int across(int line, int along) const { return line - shifts_[std::size_t(along)]; }
    /// The cells of a line that are in the tile: [first, end) in `along`.
    [[nodiscard]] int first(int line) const { return firsts_[std::size_t(line)]; }
    [[nodiscard]] int end(int line) const { return ends_[std::size_t(line)]; }
    /// Row of the tile's cells (its column, where swapped) at `along`.
    [[nodiscard]] int rowAt(int along) const { return flipped_ ? alongs_ - 1 - along : along; }

private:
    void shear();
    void findEnds();
    // The first `along` that the lines up to `line` (or after it, where the shear runs the other way) reach.
    [[nodiscard]] std::vector<int> firstReaching() const;

    glm::dvec2 corner_;
    int alongs_, acrosses_, lines_ = 0;
    bool swapped_, flipped_, mirrored_;
    double alongPerDistance_, k_, offset_ = 0;
    std::vector<Line<float>> fractions_;
    std::vector<int> shifts_, firsts_, ends_;
};

// Here, since it is called for every wall of every bin.
inline ShearedTile::Point ShearedTile::from(glm::dvec2 cells) const {
    const glm::dvec2 inside = cells - corner_;
    const double across = swapped_ ? inside.y : inside.x;
    double along = swapped_ ? inside.x : inside.y;
    if (flipped_) along = alongs_ - 1 - along;
    // Rounded as in shear(), so that a cell's centre and a corner at the same place agree.
    return {across + (offset_ - k_ * along), along};
}

}  // namespace noonmark
