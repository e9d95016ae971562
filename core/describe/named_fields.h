#pragma once

#include "core/describe/field.h"

namespace noonmark {

/// 1 for yes, 0 for no; none for texts and lists.
std::optional<double> asNumber(const Value& value);

/// The same fields held by key in NamedNumbers, as project files and study.json hold the options of engines:
/// yes is 1, no is 0. What the numbers lack has its default; a default that is set goes from them. Forms,
/// checks and JSON take these rows without knowing the struct.
std::vector<Field> asNamedNumbers(std::span<const Field> fields);

/// Sets the fields that have a number; numbers of other keys stay unread. Error: a fraction for a whole
/// number, or neither 1 nor 0 for yes or no. Ranges are not checked.
Result<void> readNamedNumbers(const Editable& settings, const NamedNumbers& numbers);

}  // namespace noonmark
