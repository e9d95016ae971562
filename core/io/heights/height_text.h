#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/io/read_city.h"

namespace noonmark {

/// Metres from what people write in a height field: "86m", "3000 ft", "11'4\"", "120 cm", full-width digits,
/// blanks. A bare number is in `bareUnit`. Nothing for what is not one height ("237;16", "concrete", "7-7",
/// "1,2 m", "nan", "inf"): the caller warns.
std::optional<double> parseMetres(std::string_view text, LengthUnit bareUnit = LengthUnit::metres);

/// A number of storeys: "12", "3.5", full-width digits. Nothing for words, ranges, lists and negative
/// numbers.
std::optional<double> parseLevels(std::string_view text);

/// "12,5 m" as "12.5 m": for files whose numbers are text with a decimal comma. Other texts come back as they
/// are, "1,250" too: that could be a thousand.
std::string withDecimalPoint(std::string_view text);

double metresPer(LengthUnit unit);

}  // namespace noonmark
