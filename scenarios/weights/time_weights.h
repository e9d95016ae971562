#pragma once

// The folder scenarios/weights/ weighs wanted shade against unwanted shadow. This file defines tables of
// weights by date and hour, reads and writes them; edit_weights.h edits their intervals and has tables to
// begin with. score.h computes a shadow score (score_sum.cpp splits the steps by month and interval and adds
// the pieces up), score_text.h writes JSON and CSV, and tile_subjects.h computes scores tile by tile.

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
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

/// A heading "name,first,last,from,to,weight" and one line per interval: days as MM-DD (last day inclusive),
/// hours as HH:MM; RFC 4180.
std::string weightsCsv(const TimeWeights& weights);

/// An array of objects with the same keys.
std::string weightsJson(const TimeWeights& weights);

/// Converts an interval to its texts by column of weightsCsv(), and back. A month ("June", "Jun") in `first`
/// means its first day, in `last` its last day. Error, with `where` and the column: as below.
std::map<std::string, std::string> textsOf(const WeightedInterval& interval);
Result<WeightedInterval> intervalFrom(const std::map<std::string, std::string>& texts,
                                      const std::string& where);

/// Parses the output of weightsCsv() and weightsJson() into a table named `name`. Columns may come in any
/// order; `name`, `from` and `to` may be missing (all day). Error, with the line or entry: an invalid column,
/// day, hour or weight, and errors of checked().
Result<TimeWeights> parseWeightsCsv(std::string_view text, const std::string& name);
Result<TimeWeights> parseWeightsJson(std::string_view text, const std::string& name);

/// Reads a file, as JSON where it starts like JSON, otherwise as CSV. Error: it cannot be read or is larger
/// than 1 MB.
Result<TimeWeights> readWeights(const std::filesystem::path& file, const std::string& name);

}  // namespace noonmark
