#pragma once

#include <atomic>
#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/engines/projected/counting/building_counts.h"
#include "core/engines/projected/counting/run_starts.h"
#include "core/engines/projected/filling/building_fill.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// A period in groups of eight steps.
struct CachedPeriod {
    std::size_t steps = 0;
    std::vector<StepOffsets> throws;  ///< one per group
    StepOffsets whole;                ///< bounds over the period
    std::vector<RunStarts> starts;    ///< one per group
};

/// Memory shared by several bands, bytes.
struct CacheMemory {
    std::uint64_t most = 0;
    std::atomic<std::uint64_t> used{0};
    [[nodiscard]] bool exceeded() const { return used > most; }
};

/// How many buildings shade each cell of 64 rows of a grid at every step of a period, so that adding or
/// removing a building costs only its own shadow. All cells are counted, receivers or not.
class CachedBand {
public:
    static constexpr int rows = CountTile::rows;

    CachedBand(const Grid& grid, int firstRow, std::size_t eights);

    /// Removes buildings and adds others; for speed, entries with the same number should be the same building
    /// moved. Adds the memory used to `memory`. Returns early, with part of the work done, when stopped or
    /// over the limit.
    void change(const BuildingCasters& gone, const BuildingCasters& come, const CachedPeriod& period,
                CacheMemory& memory, const std::stop_token& stop);

    /// Makes recount() count the cell, or all cells, even if their shadow did not change.
    void mark(int column, int row) { layout_.set(changed_, column, row - band_.first); }
    void markAll() { changed_.assign(changed_.size(), ~std::uint64_t{0}); }

    /// Counts the minutes of the receivers whose shadow changed since the last call.
    void recount(const CachedPeriod& period, std::span<const CellKind> kinds, ShadowField& field);

    [[nodiscard]] const RowBand& band() const { return band_; }

private:
    [[nodiscard]] std::uint64_t bytesOf(std::size_t eight) const;
    [[nodiscard]] CountTile& tile(std::size_t eight, int words) {
        return tiles_[eight * std::size_t(layout_.wordColumns) + std::size_t(words)];
    }
    void changeBuilding(std::size_t number, BuildingFill& gone, BuildingFill& come, std::size_t eight,
                        const StepOffsets& throws);
    static void countCells(std::span<const StepWords* const> steps, std::uint64_t cells, std::size_t first,
                           const CachedPeriod& period, ShadowField& field);

    RowBand band_;
    BitLayout layout_;
    std::vector<CountTile> tiles_;        // by group of eight steps, then west to east
    std::vector<std::uint64_t> changed_;  // raster
};

}  // namespace noonmark
