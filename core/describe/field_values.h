#pragma once

#include <string>

#include "core/describe/field.h"

namespace noonmark {

/// The row with this key, which must be there.
const Field& fieldWithKey(std::span<const Field> rows, std::string_view key);

/// The values that the field allows, with their unit: "2 to 100 m", "yes or no". Empty without a range.
std::string rangeText(const Field& field);

/// Error, with the range, for the first number that its field does not allow; not-a-number is none, and a
/// fraction is no whole number. Fields that do not apply now are checked, too: they may later.
Result<void> checkRanges(const Described& settings);

/// The fields that apply and decide the question, as text, each with its key: equal texts, equal questions.
/// With `extras` also those that decide what else is computed. For hashes and comparisons.
std::string questionText(const Described& settings, bool extras = false);

/// 1 for yes, 0 for no; none for texts and lists.
std::optional<double> asNumber(const Value& value);

/// The same fields held by key in NamedNumbers, as project files and study.json hold the options of engines:
/// yes is 1, no is 0. What the numbers lack has its default; a default that is set goes from them. Forms,
/// checks and JSON take these rows without knowing the struct.
std::vector<Field> asNamedNumbers(std::span<const Field> fields);

/// Sets the fields that have a number; numbers of other keys stay unread. Error: a fraction for a whole
/// number, or neither 1 nor 0 for yes or no. Ranges are not checked.
Result<void> readNamedNumbers(const Editable& settings, const NamedNumbers& numbers);

/// "3.2", "yes", "terrain"; lists with commas: "5,10"; named numbers as "levels=4,check=1"; empty: not set.
/// Numbers have all the digits that tell them apart.
std::string formatText(const Value& value);

/// The same of a number that people read times Field::shownTimes.
std::string formatShown(const Field& field, const Value& value);

/// Parses what a user wrote for this field. Error: not of the field's kind, or none of its choices.
Result<Value> parseValue(const Field& field, const std::string& text);

}  // namespace noonmark
