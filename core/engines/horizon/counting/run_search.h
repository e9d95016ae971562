#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/engines/horizon/counting/timed_steps.h"

namespace noonmark {

/// Searches the longest run of one receiver if horizons leave some steps in doubt. Traces as few rays as
/// possible, and looks at few of the steps that are certainly lit. In a run that would be the longest if all
/// its doubtful steps were hidden, it first tests the steps in bins where another day was found lit, then
/// those that the bin's own horizon does not hide, then all; of each the ones closest to the middle first,
/// since light there leaves two runs too short to matter. Reuses its memory; one per thread.
class RunSearch {
public:
    /// Ray queries for the receiver; steps are indices in the period.
    struct Rays {
        std::function<bool(std::uint32_t step)> hidden;
        /// A lit step in [first, end), if any; null: steps that are certainly hidden according to the
        /// horizons are not tested.
        std::function<std::optional<std::uint32_t>(std::uint32_t first, std::uint32_t end)> findLit;
    };
    /// The horizons of the receiver, one code per bin: a step is certainly lit if the highest code of its bin
    /// does not hide it, certainly hidden if the lowest does, and in doubt probably what its own code says.
    struct Horizons {
        std::vector<HorizonCode> highest, own, lowest;
    };

    /// To be filled before begin().
    [[nodiscard]] Horizons& horizons() { return horizons_; }
    /// Selects a receiver whose longest run is known to have at least `atLeast` steps. `steps`: of the
    /// period.
    void begin(Rays rays, std::span<const TimedStep> steps, int atLeast);
    void walk(const DaySteps& day);
    [[nodiscard]] int longest() const { return int(longest_); }

private:
    /// A step whose horizons neither hide it nor show it for certain.
    struct Doubt {
        std::uint32_t step;
        std::uint16_t bin;
        bool isProbablyLit;
        bool isHidden = false;  ///< a ray found it hidden
    };
    /// Which doubts to look at.
    enum class Which { inLitBins, probablyLit, all };
    [[nodiscard]] bool isWanted(const Doubt& doubt, Which which) const;
    [[nodiscard]] bool mayBeHidden(std::uint32_t step) const {
        const StepPlace& place = steps_[step].place;
        return horizons_.highest[place.bin] > place.sun;
    }
    void findDoubts(std::uint32_t first, std::uint32_t end);
    void search(std::uint32_t first, std::uint32_t end);
    [[nodiscard]] std::optional<std::uint32_t> litIn(std::uint32_t first, std::uint32_t end);
    [[nodiscard]] std::optional<std::uint32_t> litFromMiddle(std::span<Doubt> doubts, std::uint32_t middle,
                                                             Which which);
    void noteLit(std::uint32_t step);

    Horizons horizons_;
    Rays rays_;
    std::span<const TimedStep> steps_;
    std::vector<Doubt> doubts_;           // of the run that is searched, ascending
    std::vector<std::uint8_t> isLitBin_;  // for each bin, whether a step was found lit
    bool foundLit_ = false;               // whether there is such a bin
    std::uint32_t longest_ = 0;
};

}  // namespace noonmark
