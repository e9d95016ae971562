#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/engines/projected/casters/building_casters.h"
#include "core/engines/projected/filling/caster_fill.h"

namespace noonmark {

/// A rectangle of raster words: word columns [west, east), rows [south, north).
struct WordBox {
    int west = 0, east = 0, south = 0, north = 0;
    [[nodiscard]] bool empty() const { return west >= east || south >= north; }
    [[nodiscard]] WordBox with(const WordBox& other) const;
};

/// Fills the shadows of buildings one at a time over some rows of a grid, each into an empty raster, without
/// regard to receivers. One per thread.
class BuildingFill {
public:
    /// `period`: the offsets of all steps to come.
    BuildingFill(const BuildingCasters& buildings, const BitLayout& layout, const RowBand& band,
                 const StepOffsets& period);

    /// Fills the shadow at eight steps and returns the words that may contain it. The raster must be clear.
    /// For an index beyond the last building: nothing.
    WordBox fill(std::size_t building, const StepOffsets& throws);
    void clear(const WordBox& box);

    /// Whether the building's shadow reaches these rows during the period.
    [[nodiscard]] bool reaches(std::size_t building) const {
        return building < reaches_.size() && reaches_[building];
    }

    /// The words of a column of 64 cells, row by row.
    [[nodiscard]] const StepWords* column(int words) const {
        return &raster_[std::size_t(words) * std::size_t(layout_.rows)];
    }

private:
    [[nodiscard]] WordBox computeBox(std::size_t building, const StepOffsets& throws) const;

    const BuildingCasters& buildings_;
    BitLayout layout_;
    RowBand band_;
    CasterFill caster_;
    std::vector<bool> reaches_;
    std::vector<StepWords> raster_;
};

}  // namespace noonmark
