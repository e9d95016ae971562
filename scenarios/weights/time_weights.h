#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/sun/civil_time.h"

namespace noonmark {

/// Part of every year, and of the day, that has one weight.
struct WeightedInterval {
    std::string name;  ///< "January", "school afternoons"
    std::chrono::month_day first{std::chrono::January / 1};
    std::chrono::month_day last{std::chrono::December / 31};  ///< itself too; before `first`: over New Year
    std::chrono::minutes from{0};                             ///< wall clock, 0 to 24 h
    std::chrono::minutes to{24 * 60};                         ///< not itself; after `from`
    double weight = 0;  ///< -1 (shadow is unwanted) to 1 (shade is wanted)

    [[nodiscard]] bool holds(CivilDate date, std::chrono::minutes timeOfDay) const;
    bool operator==(const WeightedInterval&) const = default;
};

/// A named table. Time that no interval holds has no weight.
struct TimeWeights {
    std::string name;
    std::vector<WeightedInterval> intervals;
    bool operator==(const TimeWeights&) const = default;
};

/// The paper's table 3, month by month: -1 -1 -0.5 0 0.5 1 1 1 0.5 0 -0.5 -1. Its name is "default".
TimeWeights makeMonthlyWeights();

/// Error: no name or interval, a weight, date or hour out of range, or two intervals that hold the same time.
Result<void> checked(const TimeWeights& weights);

}  // namespace noonmark
