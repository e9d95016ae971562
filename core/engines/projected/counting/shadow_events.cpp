#include "core/engines/projected/counting/shadow_events.h"

#include <algorithm>
#include <bit>

#include "core/engines/projected/filling/step_registers.h"

namespace noonmark {

ShadowEvents::ShadowEvents(const BitLayout& layout, const RowBand& band,
                           std::span<const std::uint64_t> noReceivers)
    : layout_(layout),
      band_(band),
      noReceivers_(noReceivers.begin(), noReceivers.end()),
      shaded_(noReceivers_),
      cells_(layout.words() * 64) {}

void ShadowEvents::add(std::span<const std::uint64_t> rasters, const RunStarts& startsRun) {
    const bool anyStart = std::ranges::count(startsRun, true) > 0;
    const auto* all = reinterpret_cast<const StepWords*>(rasters.data());
    runWithWidestRegisters([ =, this, &startsRun ](auto registers) __attribute__((always_inline)) {
        using Register = decltype(registers);
        for (std::size_t word = 0; word < shaded_.size(); ++word) {
            const StepWords& steps = all[word];
            WordsOf<Register> different{};
            for (const auto& part : EightWords<Register>(steps).part) different |= part ^ shaded_[word];
            if (anySetIn<Register>(different) || (anyStart && shaded_[word] != noReceivers_[word]))
                passEight(&cells_[word * 64], shaded_[word], steps.words, startsRun, noReceivers_[word],
                          step_);
        }
    });
    step_ += stepsTogether;
}

void ShadowEvents::finish(std::size_t steps, ShadowField& field) {
    for (std::size_t word = 0; word < shaded_.size(); ++word)
        changeRuns(&cells_[word * 64], shaded_[word], noReceivers_[word], std::uint32_t(steps));
    for (int row = 0; row < layout_.rows; ++row)
        for (int column = 0; column < layout_.columns; column += 64)
            write(layout_.word(column, row), std::uint32_t(field.grid.index(column, band_.first + row)),
                  field);
}

void ShadowEvents::write(std::size_t word, std::uint32_t firstCell, ShadowField& field) const {
    for (std::uint64_t left = ~noReceivers_[word]; left != 0; left &= left - 1) {
        const auto bit = std::size_t(std::countr_zero(left));
        const CellRuns& state = cells_[word * 64 + bit];
        field.grossMin[firstCell + bit] = grossMinutes(state, field);
        field.continuousMin[firstCell + bit] = longestMinutes(state, field);
    }
}

}  // namespace noonmark
