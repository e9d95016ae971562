#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/engines/projected/casters/building_casters.h"
#include "core/engines/projected/filling/caster_fill.h"

namespace noonmark {

/// Words of a raster: columns of words [west, east), rows [south, north) of the raster.
struct WordBox {
    int west = 0, east = 0, south = 0, north = 0;
    [[nodiscard]] bool empty() const { return west >= east || south >= north; }
    [[nodiscard]] WordBox with(const WordBox& other) const;
};

/// Fills the shadow of one building after the other over some rows of a grid, each into a raster of its own,
/// whatever receivers there are. One for each thread.
class BuildingFill {
public:
    /// `period`: the throws of all steps that will come.
    BuildingFill(const BuildingCasters& buildings, const BitLayout& layout, const RowBand& band,
                 const StepOffsets& period);

    /// The shadow at eight steps; outside of the words it returns there is none. The raster must be clear. Of
    /// a number beyond the buildings: nothing.
    WordBox fill(std::size_t building, const StepOffsets& throws);
    void clear(const WordBox& box);

    /// Whether the building's shadow reaches these rows in the period.
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
