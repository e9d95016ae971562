#include "core/engines/api/step_sets.h"

#include <fmt/format.h>
#include <algorithm>
#include <limits>
#include <numeric>

namespace noonmark {

std::vector<double> StepSets::sunlitMinutes(const SunSteps& sun) const {
    std::vector<double> minutes(names.size(), 0.0);
    for (const std::uint16_t set : ofStep) minutes[set] += sun.stepMinutes;
    return minutes;
}

SunSteps StepSets::stepsOf(std::size_t set, const SunSteps& sun) const {
    SunSteps own{.stepMinutes = sun.stepMinutes};
    for (const SunDay& day : sun.days) {
        SunDay some{.date = day.date, .first = std::uint32_t(own.steps.size())};
        for (std::uint32_t i = day.first; i < day.first + day.count; ++i)
            if (ofStep[i] == set) own.steps.push_back(sun.steps[i]);
        some.count = std::uint32_t(own.steps.size()) - some.first;
        if (some.count > 0) own.days.push_back(some);
    }
    return own;
}

StepSets makeOneSet(const SunSteps& sun) {
    return {{"all"}, std::vector<std::uint16_t>(sun.steps.size(), 0)};
}

StepSets monthsOf(const SunSteps& sun) {
    StepSets sets;
    sets.ofStep.resize(sun.steps.size());
    for (const SunDay& day : sun.days) {
        const std::string name = fmt::format("{:04}-{:02}", int(day.date.year()), unsigned(day.date.month()));
        if (sets.names.empty() || sets.names.back() != name) sets.names.push_back(name);
        for (std::uint32_t i = day.first; i < day.first + day.count; ++i)
            sets.ofStep[i] = std::uint16_t(sets.names.size() - 1);
    }
    return sets;
}

double computeAreaM2(const ShadowBreakdown& breakdown) {
    const double cells = breakdown.shares.empty()
                             ? double(breakdown.cells.size())
                             : std::accumulate(breakdown.shares.begin(), breakdown.shares.end(), 0.0);
    return cells * breakdown.grid.cellAreaM2();
}

std::vector<float> spreadOverGrid(const ShadowBreakdown& breakdown, std::size_t set) {
    std::vector<float> ofGrid(breakdown.grid.size(), std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < breakdown.cells.size(); ++i)
        ofGrid[breakdown.cells[i]] = breakdown.minutes[set][i];
    return ofGrid;
}

std::vector<float> valuesAt(const std::vector<std::uint32_t>& cells, const std::vector<float>& ofGrid) {
    std::vector<float> values;
    values.reserve(cells.size());
    for (const std::uint32_t cell : cells) values.push_back(ofGrid[cell]);
    return values;
}

std::size_t findReceiver(const ShadowBreakdown& breakdown, std::uint32_t cell) {
    return std::size_t(std::ranges::lower_bound(breakdown.cells, cell) - breakdown.cells.begin());
}

}  // namespace noonmark
