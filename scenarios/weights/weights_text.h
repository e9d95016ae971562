#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "scenarios/weights/time_weights.h"

namespace noonmark {

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
