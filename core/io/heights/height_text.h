#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/settings/read_settings.h"

namespace noonmark {

/// The unit of heights that are so much for each storey, which is 2.2 to 6.5 m high: 7.2 to 21.5 are feet.
/// Nothing for numbers between.
std::optional<LengthUnit> unitPerStorey(double perStorey);

/// The unit of heights that are `ratio` times the same heights in metres.
std::optional<LengthUnit> unitBeside(double ratio);

/// Whether half of a town's buildings can be lower than this, and half higher: 2.5 to 60 m.
bool isTypicalHeight(double medianM);

/// What to say of heights whose median, in the unit that they were read in, is more than that of a town: the
/// units that would make it typical, the likeliest first, with the option that states each. Else nothing.
std::optional<std::string> doubtUnit(double median, LengthUnit readIn);

/// Parses a height as people write it, in metres: "86m", "3000 ft", "11'4\"", "120 cm", full-width digits,
/// blanks. A number without a unit is in `bareUnit`. Nothing for a text that is not one height ("237;16",
/// "concrete", "7-7", "1,2 m", "nan", "inf"): the caller warns.
std::optional<double> parseMetres(std::string_view text, LengthUnit bareUnit = LengthUnit::metres);

/// Parses a number of storeys: "12", "3.5", full-width digits, "5R" with
/// a letter of its structure. Nothing for words, ranges, lists and negative
/// numbers.
std::optional<double> parseLevels(std::string_view text);

/// The values of a list as GDAL writes it, with its count first, of which a table may have cut the end off:
/// "20.9" and "11" of "(3:20.9,11,8.". Empty for other texts.
std::vector<std::string> splitCountedList(std::string_view text);

/// Turns "12,5 m" into "12.5 m", for files whose numbers are text with a decimal comma. Other texts are
/// returned unchanged, also "1,250": that could be a thousand.
std::string withDecimalPoint(std::string_view text);

}  // namespace noonmark
