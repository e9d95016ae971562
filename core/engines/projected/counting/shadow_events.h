#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/engines/projected/counting/cell_runs.h"
#include "core/engines/projected/filling/bit_raster.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// Gross and continuous shadow over some rows of a grid from rasters, in time order. A cell costs something
/// only when it goes into or out of shadow, which happens a few times a day; a word that does not change over
/// eight steps costs one comparison.
class ShadowEvents {
public:
    /// `noReceivers`: a raster of cells that are not counted.
    ShadowEvents(const BitLayout& layout, const RowBand& band, std::span<const std::uint64_t> noReceivers);

    /// The next eight steps (convex_fill.h); cells that are no receivers are set. Beyond the last step of a
    /// period all is as before.
    void add(std::span<const std::uint64_t> rasters, const RunStarts& startsRun);

    /// Ends open runs after so many steps and writes minutes into the receivers' cells of a blank field.
    void finish(std::size_t steps, ShadowField& field);

private:
    void write(std::size_t word, std::uint32_t firstCell, ShadowField& field) const;

    BitLayout layout_;
    RowBand band_;
    std::vector<std::uint64_t> noReceivers_, shaded_;  // rasters; of the last step
    std::vector<CellRuns> cells_;                      // 64 a word
    std::uint32_t step_ = 0;
};

}  // namespace noonmark
