#pragma once

// From bit rasters to minutes. ShadowEvents (this file) counts the runs of a band from its rasters in time
// order (cell_runs.h). For the cache, cached_band.h stores how many buildings shade each cell, applies edits
// to a band of rows and recounts the cells that changed, 64 cells of a word at a time. receiver_count.h tells
// which rectangles contain receivers.

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/engines/projected/counting/cell_runs.h"
#include "core/engines/projected/filling/bit_raster.h"
#include "core/receivers/receivers.h"

namespace noonmark {

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
