#include "core/accumulate/change_map.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/accumulate/horizon/lanes16.h"
#include "core/accumulate/source_runs.h"

namespace noonmark {

namespace {

/// Some cells of one level in a row.
struct LevelRow {
    const float* heightM;
    const std::uint32_t* building;
};

NOONMARK_EVERY_ISA void markChanges(LevelRow before, LevelRow now, int count, RunRule rule,
                                    std::uint8_t* __restrict changed) {
    for (int i = 0; i < count; ++i) {
        const int other = before.building[i] != now.building[i];
        const int ends = (before.heightM[i] > 0) != (now.heightM[i] > 0);
        const int apart = !rule.sameSurface(before.heightM[i], now.heightM[i]);
        const int folds = rule.folds(before.heightM[i], now.heightM[i]);
        changed[i] = std::uint8_t(changed[i] | other | ends | apart | folds);
    }
}

}  // namespace

ChangeMap::ChangeMap(const Grid& grid, const Lanes& lanes, const ShadowSources& sources, const RunRule& rule)
    : grid_(grid), lanes_(lanes), sources_(sources), rule_(rule), changed_(grid.size()) {
    tbb::parallel_for(tbb::blocked_range<int>(0, grid.rows, 16), [&](const auto& range) {
        for (int row = range.begin(); row < range.end(); ++row) markRow(row);
    });
}

// Where lanes run along y, the cells before those of a row are the row before, shifted where lanes bend;
// where they run along x, they are the cells to the west, of the next row where lanes bend.
void ChangeMap::markRow(int row) {
    std::uint8_t* changed = &changed_[grid_.index(0, row)];
    const auto& bend = lanes_.bend();
    if (!lanes_.alongX()) {
        if (row > 0) compare(row, row - 1, bend[std::size_t(row)] - bend[std::size_t(row - 1)], changed);
        return;
    }
    const int slant = bend.back() > bend.front() ? 1 : bend.back() < bend.front() ? -1 : 0;
    std::vector<std::uint8_t> bent(slant == 0 ? 0 : std::size_t(grid_.columns));
    compare(row, row, 1, changed);
    if (slant == 0) return;
    compare(row, row - slant, 1, bent.data());
    for (int column = 1; column < grid_.columns; ++column)
        if (bend[std::size_t(column)] != bend[std::size_t(column - 1)])
            changed[column] = bent[std::size_t(column)];
}

// Against the cells `shift` columns to the west in another row; what has none there is where lanes begin.
void ChangeMap::compare(int row, int fromRow, int shift, std::uint8_t* changed) const {
    if (fromRow < 0 || fromRow >= grid_.rows) return;
    const int first = std::max(0, shift), end = grid_.columns + std::min(0, shift);
    for (int level = 0; level < sources_.levels; ++level) {
        const std::size_t now = std::size_t(level) * grid_.size() + grid_.index(first, row);
        const std::size_t before = std::size_t(level) * grid_.size() + grid_.index(first - shift, fromRow);
        markChanges({&sources_.heightM[before], &sources_.building[before]},
                    {&sources_.heightM[now], &sources_.building[now]}, end - first, rule_, changed + first);
    }
}

}  // namespace noonmark
