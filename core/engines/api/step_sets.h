#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/geo/grid.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

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
};

/// The minutes of a set in grid order, NaN where there is no receiver.
std::vector<float> spreadOverGrid(const ShadowBreakdown& breakdown, std::size_t set);

/// The values of these cells of a grid.
std::vector<float> valuesAt(const std::vector<std::uint32_t>& cells, const std::vector<float>& ofGrid);

/// Place of a receiver's cell in ShadowBreakdown::cells. O(log cells)
std::size_t findReceiver(const ShadowBreakdown& breakdown, std::uint32_t cell);

}  // namespace noonmark
