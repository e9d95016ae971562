#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace noonmark {

/// Which receivers are in shadow at each step of one day, one bit each. Bit c belongs to
/// Receivers::cells[c]; step s is the s-th step of the day (SunDay::first + s). Bits beyond the receivers
/// are 0, so that a population count needs no mask.
struct StepMasks {
    std::size_t receivers = 0;
    std::size_t steps = 0;
    std::vector<std::uint64_t> words;  ///< steps x wordsPerStep()

    StepMasks() = default;
    /// All receivers lit.
    StepMasks(std::size_t receiverCount, std::size_t stepCount)
        : receivers(receiverCount), steps(stepCount), words(stepCount * wordsPerStep()) {}

    [[nodiscard]] std::size_t wordsPerStep() const { return (receivers + 63) / 64; }
    [[nodiscard]] std::span<const std::uint64_t> at(std::size_t step) const {
        return std::span(words).subspan(step * wordsPerStep(), wordsPerStep());
    }
    [[nodiscard]] std::span<std::uint64_t> at(std::size_t step) {
        return std::span(words).subspan(step * wordsPerStep(), wordsPerStep());
    }
    [[nodiscard]] bool shaded(std::size_t step, std::size_t receiver) const {
        return (at(step)[receiver / 64] >> (receiver % 64) & 1) != 0;
    }
    void shade(std::size_t step, std::size_t receiver) {
        at(step)[receiver / 64] |= std::uint64_t{1} << (receiver % 64);
    }
    bool operator==(const StepMasks&) const = default;
};

}  // namespace noonmark
