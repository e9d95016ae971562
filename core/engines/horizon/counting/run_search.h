#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/engines/horizon/counting/day_groups.h"

namespace noonmark {

/// Looks for the longest run of one receiver where horizons leave some steps in doubt. Rays decide the fewest
/// that can: of a run that would be the longest were all its doubts hidden, first the doubts in bins where
/// another day was found lit, then those nearest to its middle, since light there leaves two runs too short
/// to matter. Keeps its memory; one for each thread.
class RunSearch {
public:
    /// What rays say of the receiver; steps are numbers in the period.
    struct Rays {
        std::function<bool(std::uint32_t step)> hidden;
        /// A lit step among [first, end), if any; null: what horizons surely hide is not looked at.
        std::function<std::optional<std::uint32_t>(std::uint32_t first, std::uint32_t end)> findLit;
    };
    /// What horizons say of it: a step is surely lit that the highest of its bin does not hide, and surely
    /// hidden where the lowest does. One code a bin.
    struct Horizons {
        std::vector<HorizonCode> highest, lowest;
    };

    /// To be filled before begin().
    [[nodiscard]] Horizons& horizons() { return horizons_; }
    /// A receiver whose longest run is known to have `atLeast` steps. `steps`: of the period.
    void begin(Rays rays, std::span<const TimedStep> steps, int atLeast);
    void walk(const DaySteps& day);
    [[nodiscard]] int longest() const { return longest_; }

private:
    enum class State : std::uint8_t { lit, doubt, hidden };
    [[nodiscard]] const StepPlace& place(std::uint32_t step) const { return steps_[step].place; }
    [[nodiscard]] bool mayBeHidden(std::uint32_t step) const {
        return horizons_.highest[place(step).bin] > place(step).sun;
    }
    [[nodiscard]] State& stateOf(std::uint32_t step) { return states_[step - first_]; }
    [[nodiscard]] State firstState(std::uint32_t step) const;
    [[nodiscard]] bool isKnownLit(std::uint16_t bin) const { return std::ranges::binary_search(lit_, bin); }
    void search(std::uint32_t first, std::uint32_t end);
    [[nodiscard]] std::optional<std::uint32_t> litIn(std::uint32_t first, std::uint32_t end);
    [[nodiscard]] std::optional<std::uint32_t> nextDoubt(std::uint32_t first, std::uint32_t end);
    void noteLit(std::uint32_t step);

    Horizons horizons_;
    Rays rays_;
    std::span<const TimedStep> steps_;
    std::uint32_t first_ = 0;         // of the run that is searched
    std::vector<State> states_;       // of its steps
    std::vector<std::uint16_t> lit_;  // bins in which a step turned out to be lit, ascending
    int longest_ = 0;
};

}  // namespace noonmark
