#pragma once

#include <string>

#include "core/describe/field.h"

namespace noonmark {

/// "3.2", "yes", "terrain"; lists with commas: "5,10"; named numbers as "levels=4,check=1"; empty: not set.
/// Numbers have all the digits that tell them apart.
std::string formatText(const Value& value);

/// The same of a number that people read times Field::shownTimes.
std::string formatShown(const Field& field, const Value& value);

/// Parses what a user wrote for this field. Error: not of the field's kind, or none of its choices.
Result<Value> parseValue(const Field& field, const std::string& text);

}  // namespace noonmark
