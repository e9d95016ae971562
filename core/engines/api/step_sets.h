#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/geo/grid.h"
#include "core/sun/sun_steps.h"

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

/// The steps of a period, each assigned to one of several sets: months, hours of the day, intervals of equal
/// weight. Any sum of steps weighted per set follows from the sums of the sets.
struct StepSets {
    std::vector<std::string> names;
    std::vector<std::uint16_t> ofStep;  ///< index of each step's set, in time order

    /// Sunlit minutes of each set.
    [[nodiscard]] std::vector<double> sunlitMinutes(const SunSteps& sun) const;

    /// The steps of one set as a period of its own, with only those days that contain some of them.
    [[nodiscard]] SunSteps stepsOf(std::size_t set, const SunSteps& sun) const;
};

/// All steps in one set, "all".
StepSets makeOneSet(const SunSteps& sun);

/// "2026-01", "2026-02", ...: the months of the period, by the date of each day.
StepSets monthsOf(const SunSteps& sun);

/// What one building does to the receivers, in each set of steps, minutes x m2 of the whole period.
struct BuildingShadow {
    std::uint32_t building = 0;  ///< index in City::buildings
    /// Attributed shadow: of the shaded cell-minutes, those below the horizon that the building makes and
    /// those above it that its overhangs hide. Where several overhangs hide the same, one building has it.
    /// All buildings and the terrain add up to the total.
    std::vector<double> attributedMinM2;
    /// Cell-minutes that would be lit if only this building were gone, over the same receivers.
    std::vector<double> soleMinM2;
};

/// A period's shadow by sets of steps and by building.
struct ShadowBreakdown {
    Grid grid;
    StepSets sets;
    std::vector<double> sunlitMinutes;        ///< of each set
    std::vector<std::uint32_t> cells;         ///< of the receivers: indices of the grid, ascending
    std::vector<std::vector<float>> minutes;  ///< of each set and receiver: in shadow, in all
    std::vector<BuildingShadow> buildings;    ///< those that shade a receiver, ascending; empty unless wanted
    std::optional<BuildingShadow> terrain;    ///< where there is terrain and it shades a receiver
    std::string engine;                       ///< name and settings in words
    std::vector<double> shares{};  ///< Receivers::shares, by which buildings and terrain are summed
};

/// Area of the receivers, each by its share. O(cells)
double computeAreaM2(const ShadowBreakdown& breakdown);

/// The minutes of a set in grid order, NaN where there is no receiver.
std::vector<float> spreadOverGrid(const ShadowBreakdown& breakdown, std::size_t set);

/// The values of these cells of a grid.
std::vector<float> valuesAt(const std::vector<std::uint32_t>& cells, const std::vector<float>& ofGrid);

/// Place of a receiver's cell in ShadowBreakdown::cells. O(log cells)
std::size_t findReceiver(const ShadowBreakdown& breakdown, std::uint32_t cell);

}  // namespace noonmark
