#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/accumulate/projected/bit_raster.h"
#include "core/accumulate/projected/shadow_casters.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Counts how many receivers a rectangle of cells holds, in constant time (a summed-area table).
class ReceiverCount {
public:
    explicit ReceiverCount(const Receivers& receivers);
    /// Whether a receiver's centre may lie in [low, high] (cells; any size, clipped to the grid).
    [[nodiscard]] bool any(glm::dvec2 low, glm::dvec2 high) const;

private:
    int columns_, rows_;
    std::vector<std::uint32_t> sums_;  // (columns + 1) x (rows + 1)
};

/// What filling did, and did not need to do.
struct FillCount {
    std::uint64_t polygons = 0;
    std::uint64_t rows = 0;
    std::uint64_t outOfReach = 0;  ///< casters x steps whose shadow meets no receiver
};

/// Fills the rasters of consecutive steps of the sun. Immutable; safe to share between threads.
class StepFiller {
public:
    StepFiller(const ShadowCasters& casters, const Receivers& receivers, const SunSteps& sun);

    /// Rasters of steps [first, end); `rasters` holds (end - first) x layout words, what was in them goes.
    /// Cells that are no receivers are set from the start: what falls on them only need not be filled.
    FillCount fill(std::size_t first, std::size_t end, std::span<std::uint64_t> rasters) const;

private:
    [[nodiscard]] glm::dvec2 throwCells(std::size_t step) const;
    [[nodiscard]] std::vector<std::uint32_t> castersInReach(std::size_t first, std::size_t end) const;

    const ShadowCasters& casters_;
    const SunSteps& sun_;
    BitLayout layout_;
    double cellM_;
    ReceiverCount receivers_;
    std::vector<std::uint64_t> noReceivers_;  // raster
};

}  // namespace noonmark
