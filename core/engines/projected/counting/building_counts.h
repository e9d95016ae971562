#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/engines/projected/filling/step_lanes.h"

namespace noonmark {

/// Bit rasters of 64 x 64 cells at eight steps, 4 kB each.
class CountPlanes {
public:
    static constexpr int rows = 64;
    [[nodiscard]] std::size_t count() const { return planes_.size(); }
    /// Adds one whose bits are all 0.
    void add();
    [[nodiscard]] StepWords& at(std::size_t plane, int row) { return (*planes_[plane])[std::size_t(row)]; }
    [[nodiscard]] const StepWords& at(std::size_t plane, int row) const {
        return (*planes_[plane])[std::size_t(row)];
    }
    [[nodiscard]] std::uint64_t bytes() const { return planes_.size() * sizeof(Plane); }

private:
    using Plane = std::array<StepWords, rows>;
    std::vector<std::unique_ptr<Plane>> planes_;
};

/// How many buildings shade each of 64 x 64 cells at eight steps, as bit rasters (planes): one of the cells
/// that any building shades, and one for each bit of the number of additional buildings. There are as many
/// planes as the cell with the highest count needs, 4 kB each; none if no shadow ever fell.
class CountTile {
public:
    static constexpr int rows = CountPlanes::rows;

    /// Removes the shadow of one building, which was added before, and adds that of another; both may be
    /// empty. Cells in both shadows cost nothing. `gone`, `come`, `changed`: one entry per row of the tile,
    /// of which rows [first, end) are processed. Adds to `changed` the cells that went into or out of shadow.
    void change(int first, int end, const StepWords* gone, const StepWords* come, std::uint64_t* changed);

    /// The cells of a row that are in shadow at each of the steps.
    [[nodiscard]] const StepWords& shaded(int row) const {
        return planes_.count() == 0 ? lit : planes_.at(0, row);
    }

    [[nodiscard]] std::uint64_t bytes() const { return planes_.bytes(); }

private:
    static constexpr StepWords lit{};
    CountPlanes planes_;  // cells shaded by any building; then the bits of the number of additional ones,
                          // lowest first
};

}  // namespace noonmark
