#include "core/accumulate/projected/shadow_events.h"

#include <algorithm>
#include <bit>

namespace noonmark {

namespace {

bool differ(const std::uint64_t* steps, std::uint64_t word) {
    std::uint64_t difference = 0;
    for (std::size_t k = 0; k < stepsTogether; ++k) difference |= steps[k] ^ word;
    return difference != 0;
}

}  // namespace

ShadowEvents::ShadowEvents(const BitLayout& layout, const RowBand& band,
                           std::span<const std::uint64_t> noReceivers)
    : layout_(layout),
      band_(band),
      noReceivers_(noReceivers.begin(), noReceivers.end()),
      shaded_(noReceivers_),
      cells_(layout.words() * 64) {}

void ShadowEvents::add(std::span<const std::uint64_t> rasters, const StartsRun& startsRun) {
    const bool anyStart = std::ranges::count(startsRun, true) > 0;
    for (std::size_t word = 0; word < shaded_.size(); ++word) {
        const std::uint64_t* steps = &rasters[word * stepsTogether];
        if (differ(steps, shaded_[word]) || (anyStart && shaded_[word] != noReceivers_[word]))
            addWord(word, steps, startsRun);
    }
    step_ += stepsTogether;
}

void ShadowEvents::addWord(std::size_t word, const std::uint64_t* steps, const StartsRun& startsRun) {
    for (std::uint32_t k = 0; k < stepsTogether; ++k) {
        if (startsRun[k]) change(word, noReceivers_[word], step_ + k);
        if (steps[k] != shaded_[word]) change(word, steps[k], step_ + k);
    }
}

void ShadowEvents::change(std::size_t word, std::uint64_t now, std::uint32_t step) {
    const std::uint64_t before = shaded_[word];
    endRuns(word, before & ~now, step);
    for (std::uint64_t begun = now & ~before; begun != 0; begun &= begun - 1)
        cells_[word * 64 + std::size_t(std::countr_zero(begun))].start = step;
    shaded_[word] = now;
}

void ShadowEvents::endRuns(std::size_t word, std::uint64_t ended, std::uint32_t step) {
    for (; ended != 0; ended &= ended - 1) {
        CellState& cell = cells_[word * 64 + std::size_t(std::countr_zero(ended))];
        const std::uint32_t length = step - cell.start;
        cell.gross += length;
        cell.longest = std::max(cell.longest, length);
    }
}

void ShadowEvents::finish(std::size_t steps, ShadowField& field) {
    for (std::size_t word = 0; word < shaded_.size(); ++word)
        change(word, noReceivers_[word], std::uint32_t(steps));
    for (int row = 0; row < layout_.rows; ++row)
        for (int column = 0; column < layout_.columns; column += 64)
            write(layout_.word(column, row), std::uint32_t(field.grid.index(column, band_.first + row)),
                  field);
}

void ShadowEvents::write(std::size_t word, std::uint32_t firstCell, ShadowField& field) const {
    for (std::uint64_t left = ~noReceivers_[word]; left != 0; left &= left - 1) {
        const auto bit = std::size_t(std::countr_zero(left));
        const CellState& state = cells_[word * 64 + bit];
        field.grossMin[firstCell + bit] = float(state.gross * field.stepMinutes / field.days);
        field.continuousMin[firstCell + bit] = float(state.longest * field.stepMinutes);
    }
}

}  // namespace noonmark
