#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/engines/projected/filling/bit_raster.h"
#include "core/engines/projected/filling/step_lanes.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Which of eight steps begin a new run: the first of a day, or a step after a gap.
using RunStarts = std::array<bool, stepsTogether>;

/// For the steps [8 k, 8 k + 8), for every k; steps after the end of the period begin none.
std::vector<RunStarts> findRunStarts(const SunSteps& sun);

/// Shadow of one cell so far, in steps.
struct CellRuns {
    std::uint32_t gross = 0;    ///< without the open run
    std::uint32_t longest = 0;  ///< without the open run
    std::uint32_t start = 0;    ///< step at which the open run began
};

/// Minutes per day, and of the longest run, as stored in a field.
inline float grossMinutes(const CellRuns& cell, const ShadowField& field) {
    return float(cell.gross * field.stepMinutes / field.days);
}
inline float longestMinutes(const CellRuns& cell, const ShadowField& field) {
    return float(cell.longest * field.stepMinutes);
}

/// Changes the 64 cells of a word from the shaded cells `before` to the shaded cells `now` at `step`. Only
/// cells that go into or out of shadow cost anything.
inline void changeRuns(CellRuns* cells, std::uint64_t before, std::uint64_t now, std::uint32_t step) {
    for (std::uint64_t ended = before & ~now; ended != 0; ended &= ended - 1) {
        CellRuns& cell = cells[std::countr_zero(ended)];
        const std::uint32_t length = step - cell.start;
        cell.gross += length;
        cell.longest = std::max(cell.longest, length);
    }
    for (std::uint64_t begun = now & ~before; begun != 0; begun &= begun - 1)
        cells[std::countr_zero(begun)].start = step;
}

/// Processes eight steps of a word from `first` on; `shaded` is its state before, and afterwards that of the
/// last step. At a step that starts a new run, the runs of all cells outside `never` end.
inline void passEight(CellRuns* cells, std::uint64_t& shaded, const std::uint64_t* steps,
                      const RunStarts& startsRun, std::uint64_t never, std::uint32_t first) {
    const auto changeTo = [&](std::uint64_t now, std::uint32_t step) {
        if (now != shaded) changeRuns(cells, shaded, now, step);
        shaded = now;
    };
    for (std::uint32_t k = 0; k < stepsTogether; ++k) {
        if (startsRun[k]) changeTo(never, first + k);
        changeTo(steps[k], first + k);
    }
}

// From bit rasters to minutes. ShadowEvents (this file) counts the runs of a band from its rasters in time
// order (shadow_events.h). For the cache, cached_band.h stores how many buildings shade each cell, applies
// edits to a band of rows and recounts the cells that changed, 64 cells of a word at a time. receiver_count.h
// tells which rectangles contain receivers.

/// Counts gross and continuous shadow over some rows of a grid from rasters in time order. A cell costs
/// something only when it goes into or out of shadow, a few times per day; a word that does not change over
/// eight steps costs one comparison.
class ShadowEvents {
public:
    /// `noReceivers`: a raster of cells that are not counted.
    ShadowEvents(const BitLayout& layout, const RowBand& band, std::span<const std::uint64_t> noReceivers);

    /// Adds the next eight steps (convex_fill-inl.h); cells that are not receivers must be set. After the
    /// last step of a period the rasters must not change.
    void add(std::span<const std::uint64_t> rasters, const RunStarts& startsRun);

    /// Ends open runs after `steps` steps and writes minutes to the receivers' cells of a blank field.
    void finish(std::size_t steps, ShadowField& field);

private:
    void write(std::size_t word, std::uint32_t firstCell, ShadowField& field) const;

    BitLayout layout_;
    RowBand band_;
    std::vector<std::uint64_t> noReceivers_, shaded_;  // rasters; shaded_: of the last step
    std::vector<CellRuns> cells_;                      // 64 per word
    std::uint32_t step_ = 0;
};

}  // namespace noonmark
