#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/projected/counting/shadow_events_hwy.cpp"
#include <hwy/foreach_target.h>

#include <algorithm>
#include <bit>

#include "core/engines/projected/counting/shadow_events.h"
#include "core/simd/kernel.h"

// After kernel.h.
#include "core/engines/projected/filling/step_registers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {

// Adds eight steps of all words, from `firstStep` on; cells: 64 per word.
void passWords(const StepWords* all, const RunStarts& startsRun, std::span<const std::uint64_t> noReceivers,
               std::uint32_t firstStep, std::uint64_t* shaded, CellRuns* cells) {
    const bool anyStart = std::ranges::count(startsRun, true) > 0;
    for (std::size_t word = 0; word < noReceivers.size(); ++word) {
        const auto before = hn::Set(stepBits, shaded[word]);
        auto different = hn::Zero(stepBits);
        for (const auto& part : EightWords(all[word]).part)
            different = hn::Or(different, hn::Xor(part, before));
        if (anySet(different) || (anyStart && shaded[word] != noReceivers[word]))
            passEight(&cells[word * 64], shaded[word], all[word].words, startsRun, noReceivers[word],
                      firstStep);
    }
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

std::vector<RunStarts> findRunStarts(const SunSteps& sun) {
    std::vector<RunStarts> starts((sun.steps.size() + stepsTogether - 1) / stepsTogether, RunStarts{});
    const auto begin = [&](std::size_t step) { starts[step / stepsTogether][step % stepsTogether] = true; };
    for (const SunDay& day : sun.days)
        if (day.count > 0) begin(day.first);
    for (std::size_t step = 1; step < sun.steps.size(); ++step)
        if (sun.steps[step].slot != sun.steps[step - 1].slot + 1) begin(step);
    return starts;
}

ShadowEvents::ShadowEvents(const BitLayout& layout, const RowBand& band,
                           std::span<const std::uint64_t> noReceivers)
    : layout_(layout),
      band_(band),
      noReceivers_(noReceivers.begin(), noReceivers.end()),
      shaded_(noReceivers_),
      cells_(layout.words() * 64) {}

NOONMARK_KERNEL(passWords);
void ShadowEvents::add(std::span<const std::uint64_t> rasters, const RunStarts& startsRun) {
    NOONMARK_CALL(passWords)
    (reinterpret_cast<const StepWords*>(rasters.data()), startsRun, noReceivers_, step_, shaded_.data(),
     cells_.data());
    step_ += stepsTogether;
}

void ShadowEvents::finish(std::size_t steps, ShadowField& field) {
    for (std::size_t word = 0; word < shaded_.size(); ++word)
        changeRuns(&cells_[word * 64], shaded_[word], noReceivers_[word], std::uint32_t(steps));
    for (int row = 0; row < layout_.rows; ++row)
        for (int column = layout_.firstColumn(); column < layout_.columns; column += 64)
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
#endif
