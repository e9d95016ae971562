#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/engines/projected/counting/shadow_events.h"
#include "core/engines/projected/filling/step_filler.h"
#include "core/engines/projected/filling/step_lanes.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// Bit rasters of 64 x 64 cells at eight steps, 4 kB each.
class CountPlanes {
public:
    static constexpr int rows = 64;
    [[nodiscard]] std::size_t count() const { return planes_.size(); }
    /// Adds one whose bits are all 0.
    void add();
    [[nodiscard]] StepWords& at(std::size_t plane, int row) { return (*planes_[plane])[std::size_t(row)]; }
    [[nodiscard]] const StepWords& at(std::size_t plane, int row) const {
        return (*planes_[plane])[std::size_t(row)];
    }
    [[nodiscard]] std::uint64_t bytes() const { return planes_.size() * sizeof(Plane); }

private:
    using Plane = std::array<StepWords, rows>;
    std::vector<std::unique_ptr<Plane>> planes_;
};

/// How many buildings shade each of 64 x 64 cells at eight steps, as bit rasters (planes): one of the cells
/// that any building shades, and one for each bit of the number of additional buildings. There are as many
/// planes as the cell with the highest count needs, 4 kB each; none if no shadow ever fell.
class CountTile {
public:
    static constexpr int rows = CountPlanes::rows;

    /// Removes the shadow of one building, which was added before, and adds that of another; both may be
    /// empty. Cells in both shadows cost nothing. `removed`, `added`, `changed`: one entry per row of the
    /// tile, of which rows [first, end) are processed. Adds to `changed` the cells that went into or out of
    /// shadow.
    void change(int first, int end, const StepWords* removed, const StepWords* added, std::uint64_t* changed);

    /// The cells of a row that are in shadow at each of the steps.
    [[nodiscard]] const StepWords& shaded(int row) const {
        return planes_.count() == 0 ? lit : planes_.at(0, row);
    }

    [[nodiscard]] std::uint64_t bytes() const { return planes_.bytes(); }

private:
    static constexpr StepWords lit{};
    CountPlanes planes_;  // cells shaded by any building; then the bits of the number of additional ones,
                          // lowest first
};

/// Shadow of the 64 cells of a word over a period, in steps.
struct alignas(64) WordRuns {
    std::uint32_t gross[64];
    std::uint32_t longest[64];
};

/// The words of the same 64 cells, one for each group of eight steps.
using WordSteps = std::span<const StepWords* const>;

/// Counts all cells of a word, by lanes or by changes, whichever is faster on this processor. `words`: one
/// per group of eight steps; steps after the first `steps` are ignored. Both ways give the same runs.
void countRuns(WordSteps words, std::span<const RunStarts> starts, std::size_t steps, WordRuns& runs);

/// Step by step, with one 16-bit lane per cell, for periods of up to `maxStepsInLanes` steps: 1 ns per step
/// with registers of 64 bytes, 4 ns with registers of 32 bytes.
void countByLanes(WordSteps words, std::span<const RunStarts> starts, std::size_t steps, WordRuns& runs);
inline constexpr std::size_t maxStepsInLanes = 65'535;

/// 1 ns per step, and some ns for each cell that goes into or out of shadow.
void countByChanges(WordSteps words, std::span<const RunStarts> starts, std::size_t steps, WordRuns& runs);

/// A period in groups of eight steps.
struct CachedPeriod {
    std::size_t steps = 0;
    std::vector<StepOffsets> throws;  ///< one per group
    StepOffsets whole;                ///< bounds over the period
    std::vector<RunStarts> starts;    ///< one per group
};

/// Memory shared by several bands, bytes.
struct CacheMemory {
    std::uint64_t maximum = 0;
    std::atomic<std::uint64_t> used{0};
    [[nodiscard]] bool exceeded() const { return used > maximum; }
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
    void change(const BuildingCasters& removed, const BuildingCasters& added, const CachedPeriod& period,
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
    void changeBuilding(std::size_t number, BuildingFill& removed, BuildingFill& added, std::size_t eight,
                        const StepOffsets& throws);
    static void countCells(std::span<const StepWords* const> steps, std::uint64_t cells, std::size_t first,
                           const CachedPeriod& period, ShadowField& field);

    RowBand band_;
    BitLayout layout_;
    std::vector<CountTile> tiles_;        // by group of eight steps, then west to east
    std::vector<std::uint64_t> changed_;  // raster
};

}  // namespace noonmark
