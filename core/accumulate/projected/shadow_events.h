#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/accumulate/projected/bit_raster.h"
#include "core/accumulate/shadow_field.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// Gross and continuous shadow from rasters, one a step, in time order. A cell costs something only when it
/// goes into or out of shadow, which happens a few times a day; whole words that did not change cost one
/// comparison.
class ShadowEvents {
public:
    explicit ShadowEvents(const Receivers& receivers);

    /// The next `count` steps: `rasters` holds `count` x layout words. startsRun[k]: step k begins a new run
    /// (a new day, or steps are missing before it). All cores.
    void add(std::span<const std::uint64_t> rasters, std::span<const bool> startsRun);

    /// Ends open runs and writes minutes into the receivers' cells of a blank field.
    void finish(ShadowField& field);

private:
    struct CellState {
        std::uint32_t gross = 0;    // steps in shadow so far, but for the open run
        std::uint32_t longest = 0;  // steps
        std::uint32_t start = 0;    // step at which the open run began
    };
    void addWords(std::size_t first, std::size_t end, std::span<const std::uint64_t> rasters,
                  std::span<const bool> startsRun);
    void change(std::size_t word, std::uint64_t now, std::uint32_t step);
    void endRuns(std::size_t word, std::uint64_t ended, std::uint32_t step);

    const Receivers& receivers_;
    BitLayout layout_;
    std::vector<std::uint64_t> isReceiver_;  // raster
    std::vector<std::uint64_t> shaded_;      // raster of the last step
    std::vector<CellState> cells_;           // 64 a word
    std::uint32_t steps_ = 0;
};

}  // namespace noonmark
