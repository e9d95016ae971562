#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "core/receivers/grid.h"

namespace noonmark {

/// The cells of a grid strung on parallel lanes, each cell on exactly one: what moves along `direction` stays
/// on its lane to half a cell. Lanes can be worked on at the same time, for none writes to another's cells.
///
/// Along the major axis (x where the direction is more east-west than north-south) a lane has one cell a
/// column; across it, cell = lane + bend(major), the bend being the direction's slope rounded to whole cells.
class Lanes {
public:
    /// `direction`: metres, any length; zero counts as east.
    Lanes(const Grid& grid, glm::dvec2 direction);

    struct Stretch {
        int first = 0;  ///< major positions [first, end) at which the lane is on the grid
        int end = 0;
    };

    [[nodiscard]] int count() const { return laneCount_; }
    [[nodiscard]] bool alongX() const { return alongX_; }
    [[nodiscard]] Stretch stretch(int lane) const;

    /// The lanes [first, end) that are on the grid at a major position.
    [[nodiscard]] Stretch lanesAt(int major) const {
        const int low = -firstLane_ - bend_[std::size_t(major)];
        return {low, low + (alongX_ ? grid_.rows : grid_.columns)};
    }

    /// For devices that work out cell() by themselves: minor = lane + firstLane + bend[major].
    [[nodiscard]] int firstLane() const { return firstLane_; }
    [[nodiscard]] const std::vector<int>& bend() const { return bend_; }

    /// Grid index of a lane's cell; only within its stretch.
    [[nodiscard]] std::size_t cell(int lane, int major) const {
        const int minor = lane + firstLane_ + bend_[std::size_t(major)];
        return alongX_ ? grid_.index(major, minor) : grid_.index(minor, major);
    }

private:
    Grid grid_;
    bool alongX_ = true;
    int firstLane_ = 0;  // may be negative: lanes that enter the grid late
    int laneCount_ = 0;
    std::vector<int> bend_;  // by major position; monotone
};

}  // namespace noonmark
