#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "core/geo/grid.h"

namespace noonmark {

/// The cells of a grid strung on parallel lanes, each cell on exactly one: what moves along `direction` stays
/// on its lane to half a cell. Lanes can be worked on at the same time, for none writes to another's cells.
///
/// Along the major axis (x where the direction is more east-west than north-south) a lane has one place a
/// column; across it, minor = lane + bend(major), the bend being the direction's slope rounded to whole
/// cells. Every lane has all major positions: where it bends beyond the grid's sides its places are no cells.
class Lanes {
public:
    /// Lanes side by side that are worked on together.
    static constexpr int perBlock = 16;

    /// `direction`: metres, any length; zero counts as east.
    Lanes(const Grid& grid, glm::dvec2 direction);

    [[nodiscard]] int count() const { return laneCount_; }
    [[nodiscard]] int blocks() const { return (laneCount_ + perBlock - 1) / perBlock; }
    [[nodiscard]] bool alongX() const { return alongX_; }
    [[nodiscard]] int majors() const { return alongX_ ? grid_.columns : grid_.rows; }
    [[nodiscard]] int minors() const { return alongX_ ? grid_.rows : grid_.columns; }
    [[nodiscard]] const Grid& grid() const { return grid_; }

    /// Cells across that a lane moves from one major position to the next, before rounding: at most 1.
    [[nodiscard]] double slope() const { return slope_; }
    /// Of lane 0, before its bend; may be negative: lanes that enter the grid late.
    [[nodiscard]] int firstLane() const { return firstLane_; }

    /// Minor position of a lane; a cell where it is 0 to minors() - 1.
    [[nodiscard]] int minor(int lane, int major) const {
        return lane + firstLane_ + bend_[std::size_t(major)];
    }
    /// minor(lane, major) - lane - firstLane() by major position.
    [[nodiscard]] const std::vector<int>& bend() const { return bend_; }
    [[nodiscard]] bool onGrid(int minor) const { return unsigned(minor) < unsigned(minors()); }

    /// Grid index of a cell.
    [[nodiscard]] std::size_t cellAt(int major, int minor) const {
        return alongX_ ? grid_.index(major, minor) : grid_.index(minor, major);
    }

private:
    Grid grid_;
    bool alongX_ = true;
    double slope_ = 0;
    int firstLane_ = 0;
    int laneCount_ = 0;
    std::vector<int> bend_;  // by major position; monotone
};

}  // namespace noonmark
