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
struct SavedPeriod {
    std::size_t steps = 0;
    std::vector<StepOffsets> throws;  ///< of each eight
    StepOffsets whole;                ///< bounds of all
    std::vector<RunStarts> starts;    ///< of each eight
};

/// Memory that several bands share, bytes.
struct CacheMemory {
    std::uint64_t most = 0;
    std::atomic<std::uint64_t> used{0};
    [[nodiscard]] bool exceeded() const { return used > most; }
};

/// How many buildings shade each cell of 64 rows of a grid at every step of a period, so that a building
/// comes or goes at the cost of its own shadow. Cells are counted whether they are receivers or not.
class CachedBand {
public:
    static constexpr int rows = CountTile::rows;

    CachedBand(const Grid& grid, int firstRow, std::size_t eights);

    /// Buildings that go, and others that come; those of the same number are best the same one moved.
    /// Adds what it takes to `memory`. Returns early when stopped or above it, with some of it done.
    void change(const BuildingCasters& gone, const BuildingCasters& come, const SavedPeriod& period,
                CacheMemory& memory, const std::stop_token& stop);

    /// The cell, or all, are counted by recount() although their shadow did not change.
    void mark(int column, int row) { layout_.set(changed_, column, row - band_.first); }
    void markAll() { changed_.assign(changed_.size(), ~std::uint64_t{0}); }

    /// Counts the minutes of the receivers whose shadow changed since the last time.
    void recount(const SavedPeriod& period, std::span<const CellKind> kinds, ShadowField& field);

    [[nodiscard]] const RowBand& band() const { return band_; }

private:
    [[nodiscard]] std::uint64_t bytesOf(std::size_t eight) const;
    [[nodiscard]] CountTile& tile(std::size_t eight, int words) {
        return tiles_[eight * std::size_t(layout_.wordColumns) + std::size_t(words)];
    }
    void changeBuilding(std::size_t number, BuildingFill& gone, BuildingFill& come, std::size_t eight,
                        const StepOffsets& throws);
    static void countCells(std::span<const StepWords* const> steps, std::uint64_t cells, std::size_t first,
                           const SavedPeriod& period, ShadowField& field);

    RowBand band_;
    BitLayout layout_;
    std::vector<CountTile> tiles_;        // eight by eight, west to east
    std::vector<std::uint64_t> changed_;  // raster
};

}  // namespace noonmark
