#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/accumulate/projected/bit_raster.h"
#include "core/accumulate/projected/step_lanes.h"
#include "core/accumulate/shadow_field.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// Gross and continuous shadow over some rows of a grid from rasters, in time order. A cell costs something
/// only when it goes into or out of shadow, which happens a few times a day; a word that does not change over
/// eight steps costs one comparison.
class ShadowEvents {
public:
    /// `noReceivers`: a raster of cells that are not counted.
    ShadowEvents(const BitLayout& layout, const RowBand& band, std::span<const std::uint64_t> noReceivers);

    /// The next eight steps (convex_fill.h); cells that are no receivers are set. startsRun[k]: step k begins
    /// a new run (a new day, or steps are missing before it). Beyond the last step of a period all is as
    /// before.
    using StartsRun = std::array<bool, stepsTogether>;
    void add(std::span<const std::uint64_t> rasters, const StartsRun& startsRun);

    /// Ends open runs after so many steps and writes minutes into the receivers' cells of a blank field.
    void finish(std::size_t steps, ShadowField& field);

private:
    struct CellState {
        std::uint32_t gross = 0;    // steps in shadow so far, but for the open run
        std::uint32_t longest = 0;  // steps
        std::uint32_t start = 0;    // step at which the open run began
    };
    void addWord(std::size_t word, const std::uint64_t* steps, const StartsRun& startsRun);
    void change(std::size_t word, std::uint64_t now, std::uint32_t step);
    void endRuns(std::size_t word, std::uint64_t ended, std::uint32_t step);
    void write(std::size_t word, std::uint32_t firstCell, ShadowField& field) const;

    BitLayout layout_;
    RowBand band_;
    std::vector<std::uint64_t> noReceivers_, shaded_;  // rasters; of the last step
    std::vector<CellState> cells_;                     // 64 a word
    std::uint32_t step_ = 0;
};

}  // namespace noonmark
