#pragma once

#include <cstddef>
#include <cstdint>

#include "core/engines/common/shadow_mask.h"
#include "core/engines/inverse/lane_sources.h"
#include "core/engines/inverse/run_sweep.h"
#include "core/engines/inverse/source_runs.h"

namespace noonmark {

/// Cells of a run, counted from its first.
struct CellRange {
    int first = 0;
    int end = 0;
};

/// Sets in `row` the steps at which a part of a run shades its cells, for those in `cells`. `before`: that of
/// the StepTable. Cost: some 2 ns per cell.
void shadeCells(const ShadowMask* before, const SweepPart& part, const CellRange& cells, ShadowMask* row);

/// A block's sources in the order in which shadows move.
struct SourceLines {
    const CacheLine<float>* heightM;
    const CacheLine<std::uint32_t>* building;
    std::ptrdiff_t step;  ///< Lines from one position to the next; negative if shadows move against the lanes
    int levels;
};

/// changed[at], for `at` from 1 to places - 1: a bit for each lane on which the sources of a position do not
/// simply continue those of the previous one. Extra bits do no harm; changes slightly below the folding limit
/// are marked too.
void markChanges(const SourceLines& lines, int places, const RunRule& rule, std::uint16_t* changed);

}  // namespace noonmark
