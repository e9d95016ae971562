#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "scenarios/weights/time_weights.h"

namespace noonmark {

/// "name,first,last,from,to,weight" and one line an interval: days as MM-DD (the last one too belongs to it),
/// hours as HH:MM; RFC 4180.
std::string weightsCsv(const TimeWeights& weights);

/// An array of objects with the same keys.
std::string weightsJson(const TimeWeights& weights);

/// An interval by the columns of weightsCsv(), as text; and back. A month ("June", "Jun") stands for its
/// first day in `first` and for its last in `last`. Error, with `where` and the column: as below.
std::map<std::string, std::string> textsOf(const WeightedInterval& interval);
Result<WeightedInterval> intervalFrom(const std::map<std::string, std::string>& texts,
                                      const std::string& where);

/// What the two write, named `name`. Columns in any order; `name`, `from` and `to` may be left out (all day).
/// Error, with the line or the entry: a column, day, hour or weight that is none, and as of checked().
Result<TimeWeights> parseWeightsCsv(std::string_view text, const std::string& name);
Result<TimeWeights> parseWeightsJson(std::string_view text, const std::string& name);

/// From a file, JSON where it begins like JSON. Error: it cannot be read, or is larger than 1 MB.
Result<TimeWeights> readWeights(const std::filesystem::path& file, const std::string& name);

}  // namespace noonmark
