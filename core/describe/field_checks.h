#pragma once

#include <string>

#include "core/describe/field.h"

namespace noonmark {

/// What a number, or a yes or no, may be, with its unit: "2 to 100 m", "yes or no".
/// Empty without a range.
std::string rangeText(const Field& field);

/// Error, with the range, for the first number that its field does not allow; not-a-number is none, and a
/// fraction is no whole number. Fields that do not apply now are checked, too: they may later.
Result<void> checkRanges(const Described& settings);

/// The fields that apply and decide the question, as text, each with its key: equal texts, equal questions.
/// With `extras` also those that decide what else is computed. For hashes and comparisons.
std::string questionText(const Described& settings, bool extras = false);

}  // namespace noonmark
