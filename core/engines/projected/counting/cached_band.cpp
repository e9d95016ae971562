#include "core/engines/projected/counting/cached_band.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "core/engines/projected/counting/shadow_events.h"

namespace noonmark {

namespace {

// Bits of the receivers among eight cells. Bytes that become 0 leave their high bit set, and these bits are
// packed together.
std::uint64_t receiversOfEight(const CellKind* kinds) {
    constexpr std::uint64_t ones = 0x0101010101010101, highs = ones << 7U;
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, kinds, sizeof bytes);
    bytes ^= ones * std::uint64_t(CellKind::ground);
    const std::uint64_t zeros = ~(((bytes & ~highs) + ~highs) | bytes) & highs;
    return (zeros * 0x0002040810204081) >> 56U;
}

// Bits of the receivers among up to 64 cells.
std::uint64_t receiversAmong(std::span<const CellKind> kinds) {
    std::uint64_t cells = 0;
    std::size_t i = 0;
    for (; i + 8 <= kinds.size(); i += 8) cells |= receiversOfEight(&kinds[i]) << i;
    for (; i < kinds.size(); ++i) cells |= std::uint64_t(kinds[i] == CellKind::ground) << i;
    return cells;
}

}  // namespace

CachedBand::CachedBand(const Grid& grid, int firstRow, std::size_t eights)
    : band_{firstRow, std::min(firstRow + rows, grid.rows)},
      layout_(grid.columns, band_.rows()),
      tiles_(eights * std::size_t(layout_.wordColumns)),
      changed_(layout_.words()) {}

void CachedBand::change(const BuildingCasters& removed, const BuildingCasters& added,
                        const CachedPeriod& period, CacheMemory& memory, const std::stop_token& stop) {
    BuildingFill before(removed, layout_, band_, period.whole), after(added, layout_, band_, period.whole);
    std::vector<std::size_t> reaching;
    for (std::size_t i = 0; i < std::max(removed.buildings(), added.buildings()); ++i)
        if (before.reaches(i) || after.reaches(i)) reaching.push_back(i);
    for (std::size_t eight = 0; eight < period.throws.size(); ++eight) {
        if (stop.stop_requested() || memory.exceeded()) return;
        const std::uint64_t bytes = bytesOf(eight);
        for (const std::size_t i : reaching) changeBuilding(i, before, after, eight, period.throws[eight]);
        memory.used += bytesOf(eight) - bytes;
    }
}

void CachedBand::changeBuilding(std::size_t number, BuildingFill& removed, BuildingFill& added,
                                std::size_t eight, const StepOffsets& throws) {
    const WordBox removedBox = removed.fill(number, throws), addedBox = added.fill(number, throws);
    const WordBox box = removedBox.with(addedBox);
    for (int words = box.west; words < box.east; ++words)
        tile(eight, words)
            .change(box.south, box.north, removed.column(words), added.column(words),
                    &changed_[layout_.word(words * 64, 0)]);
    removed.clear(removedBox);
    added.clear(addedBox);
}

void CachedBand::recount(const CachedPeriod& period, std::span<const CellKind> kinds, ShadowField& field) {
    tbb::parallel_for(0, layout_.wordColumns, [&](int words) {
        std::vector<const StepWords*> steps(period.throws.size());
        for (int row = 0; row < layout_.rows; ++row) {
            const std::uint64_t changed = std::exchange(changed_[layout_.word(words * 64, row)], 0);
            if (changed == 0) continue;
            const std::size_t first = field.grid.index(words * 64, band_.first + row);
            const auto width = std::size_t(std::min(64, layout_.columns - words * 64));
            const std::uint64_t cells = changed & receiversAmong(kinds.subspan(first, width));
            if (cells == 0) continue;
            for (std::size_t eight = 0; eight < steps.size(); ++eight)
                steps[eight] = &tile(eight, words).shaded(row);
            countCells(steps, cells, first, period, field);
        }
    });
}

void CachedBand::countCells(std::span<const StepWords* const> steps, std::uint64_t cells, std::size_t first,
                            const CachedPeriod& period, ShadowField& field) {
    WordRuns runs;
    countRuns(steps, period.starts, period.steps, runs);
    for (; cells != 0; cells &= cells - 1) {
        const auto bit = std::size_t(std::countr_zero(cells));
        const CellRuns cell{.gross = runs.gross[bit], .longest = runs.longest[bit]};
        field.grossMin[first + bit] = grossMinutes(cell, field);
        field.continuousMin[first + bit] = longestMinutes(cell, field);
    }
}

std::uint64_t CachedBand::bytesOf(std::size_t eight) const {
    const auto columns = std::size_t(layout_.wordColumns);
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < columns; ++i) sum += tiles_[eight * columns + i].bytes();
    return sum;
}

}  // namespace noonmark
