#pragma once

// The folder scenarios/weights/ weighs wanted shade against unwanted shadow. time_weights.h defines tables of
// weights by date and hour, weights_text.h reads and writes them, edit_weights.h edits their
// intervals, and weight_templates.h has tables to begin with. score.h computes a shadow score: time_pieces.h
// splits the steps by month and interval, score_sum.h adds the pieces up, score_text.h writes JSON and CSV.

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/sun/civil_time.h"

namespace noonmark {

/// A range of dates in every year and a range of hours that share one weight.
struct WeightedInterval {
    std::string name;  ///< "January", "school afternoons"
    std::chrono::month_day first{std::chrono::January / 1};
    std::chrono::month_day last{std::chrono::December /
                                31};  ///< inclusive; before `first`: the range spans New Year
    std::chrono::minutes from{0};     ///< wall clock, 0 to 24 h
    /// Exclusive. Before `from`: the hours span midnight, and those after it belong to their own date.
    std::chrono::minutes to{24 * 60};
    double weight = 0;  ///< -1 (shadow is unwanted) to 1 (shade is wanted)

    [[nodiscard]] bool holds(CivilDate date, std::chrono::minutes timeOfDay) const;
    bool operator==(const WeightedInterval&) const = default;
};

/// A named table of weights. Time outside every interval has no weight.
struct TimeWeights {
    std::string name;
    std::vector<WeightedInterval> intervals;
    bool operator==(const TimeWeights&) const = default;
};

/// The paper's table 3, month by month: -1 -1 -0.5 0 0.5 1 1 1 0.5 0 -0.5 -1. Its name is "default".
TimeWeights makeMonthlyWeights();

/// Error: no name or no interval; a weight, date or hour out of range; or two intervals that overlap.
Result<void> validate(const TimeWeights& weights);

/// Shade is wanted in the hot season. A warning where the table wants more of it in the winter of a place
/// outside the tropics than in its summer: the table was made for the other half of the earth. None for a
/// table that wants no shade at all, such as that of plants.
std::optional<Warning> findSeasonMismatch(const TimeWeights& weights, double latitudeDeg);

}  // namespace noonmark
