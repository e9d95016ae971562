#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/engines/projected/filling/step_lanes.h"
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

}  // namespace noonmark
