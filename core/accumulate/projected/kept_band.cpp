#include "core/accumulate/projected/kept_band.h"

#include <algorithm>
#include <array>
#include <bit>

#include "core/accumulate/projected/cell_runs.h"

namespace noonmark {

namespace {

// Those of up to 64 cells that are receivers.
std::uint64_t receiversAmong(std::span<const CellKind> kinds) {
    std::uint64_t cells = 0;
    for (std::size_t i = 0; i < kinds.size(); ++i) cells |= std::uint64_t(kinds[i] == CellKind::ground) << i;
    return cells;
}

}  // namespace

KeptBand::KeptBand(const Grid& grid, int firstRow, std::size_t eights)
    : band_{firstRow, std::min(firstRow + rows, grid.rows)},
      layout_(grid.columns, band_.rows()),
      tiles_(eights * std::size_t(layout_.wordColumns)),
      changed_(layout_.words()) {}

void KeptBand::change(const BuildingCasters& gone, const BuildingCasters& come, const KeptPeriod& period,
                      KeptMemory& memory, const std::stop_token& stop) {
    BuildingFill before(gone, layout_, band_, period.whole), after(come, layout_, band_, period.whole);
    std::vector<std::size_t> reaching;
    for (std::size_t i = 0; i < std::max(gone.buildings(), come.buildings()); ++i)
        if (before.reaches(i) || after.reaches(i)) reaching.push_back(i);
    for (std::size_t eight = 0; eight < period.throws.size(); ++eight) {
        if (stop.stop_requested() || memory.exceeded()) return;
        const std::uint64_t bytes = bytesOf(eight);
        for (const std::size_t i : reaching) changeBuilding(i, before, after, eight, period.throws[eight]);
        memory.used += bytesOf(eight) - bytes;
    }
}

void KeptBand::changeBuilding(std::size_t number, BuildingFill& gone, BuildingFill& come, std::size_t eight,
                              const StepThrows& throws) {
    const WordBox goneBox = gone.fill(number, throws), comeBox = come.fill(number, throws);
    const WordBox box = goneBox.with(comeBox);
    for (int words = box.west; words < box.east; ++words)
        tile(eight, words)
            .change(box.south, box.north, gone.column(words), come.column(words),
                    &changed_[layout_.word(words * 64, 0)]);
    gone.clear(goneBox);
    come.clear(comeBox);
}

void KeptBand::recount(const KeptPeriod& period, std::span<const CellKind> kinds, ShadowField& field) {
    for (int words = 0; words < layout_.wordColumns; ++words)
        for (int row = 0; row < layout_.rows; ++row) {
            std::uint64_t& changed = changed_[layout_.word(words * 64, row)];
            if (changed == 0) continue;
            const std::size_t first = field.grid.index(words * 64, band_.first + row);
            const auto width = std::size_t(std::min(64, layout_.columns - words * 64));
            const std::uint64_t cells = changed & receiversAmong(kinds.subspan(first, width));
            if (cells != 0) recountWord(words, row, cells, period, field);
            changed = 0;
        }
}

void KeptBand::recountWord(int words, int row, std::uint64_t cells, const KeptPeriod& period,
                           ShadowField& field) {
    std::array<CellRuns, 64> runs{};
    std::uint64_t shaded = 0;
    for (std::size_t eight = 0; eight < period.throws.size(); ++eight) {
        StepWords steps = tile(eight, words).shaded(row);
        for (std::uint64_t& word : steps.words) word &= cells;
        passEight(runs.data(), shaded, steps.words, period.starts[eight], 0,
                  std::uint32_t(eight * stepsTogether));
    }
    changeRuns(runs.data(), shaded, 0, std::uint32_t(period.steps));
    const std::size_t first = field.grid.index(words * 64, band_.first + row);
    for (; cells != 0; cells &= cells - 1) {
        const auto bit = std::size_t(std::countr_zero(cells));
        field.grossMin[first + bit] = grossMinutes(runs[bit], field);
        field.continuousMin[first + bit] = longestMinutes(runs[bit], field);
    }
}

std::uint64_t KeptBand::bytesOf(std::size_t eight) const {
    const auto columns = std::size_t(layout_.wordColumns);
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < columns; ++i) sum += tiles_[eight * columns + i].bytes();
    return sum;
}

}  // namespace noonmark
