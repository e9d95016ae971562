#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "core/geo/grid.h"

namespace noonmark {

/// The cells of a grid grouped into parallel lanes, each cell on exactly one: a shadow that moves in
/// `direction` stays on its lane to within half a cell. Lanes can be processed in parallel, because none
/// writes to another's cells.
///
/// Along the major axis (x if the direction is more east-west than north-south) a lane has one position per
/// column; across it, minor = lane + bend(major), where the bend is the direction's slope rounded to whole
/// cells. Every lane has all major positions; where it leaves the grid its positions are not cells.
class Lanes {
public:
    /// Number of adjacent lanes that are processed together.
    static constexpr int perBlock = 16;

    /// `direction`: metres, any length; zero counts as east.
    Lanes(const Grid& grid, glm::dvec2 direction);

    [[nodiscard]] int count() const { return laneCount_; }
    [[nodiscard]] int blocks() const { return (laneCount_ + perBlock - 1) / perBlock; }
    [[nodiscard]] bool alongX() const { return alongX_; }
    [[nodiscard]] int majors() const { return alongX_ ? grid_.columns : grid_.rows; }
    [[nodiscard]] int minors() const { return alongX_ ? grid_.rows : grid_.columns; }
    [[nodiscard]] const Grid& grid() const { return grid_; }

    /// Minor displacement of a lane from one major position to the next, before rounding: at most 1.
    [[nodiscard]] double slope() const { return slope_; }
    /// Minor position of lane 0 without its bend; negative if there are lanes that enter the grid late.
    [[nodiscard]] int firstLane() const { return firstLane_; }

    /// Minor position of a lane; a cell if it is 0 to minors() - 1.
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
