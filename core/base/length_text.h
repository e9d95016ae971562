#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/display_units.h"

namespace noonmark {

/// A length as people type it, in metres: "3.5 m", "350 cm", "12' 6\"", "12'-6 1/2\"", "12 ft 6 in", "150\"",
/// with a decimal point or comma and the typographic primes too. A number alone is in feet if `units` is
/// imperial, else in metres; inches alone need their mark. Nothing for any other text, and for 1e7 m or more.
std::optional<double> parseLength(std::string_view text, UnitSystem units);

/// "12' 6\"", "-0' 3.25\"": whole feet and inches, rounded to 0.01 inch.
std::string formatFeetAndInches(double metres);

}  // namespace noonmark
