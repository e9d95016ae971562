#pragma once

#include <string>

#include "core/describe/field.h"

namespace noonmark {

/// Error, with the range, for the first number that its field does not allow; not-a-number is none. Fields
/// that do not apply now are checked, too: they may later.
Result<void> checkRanges(const Described& settings);

/// The fields that apply and decide the question, as text, each with its key: equal texts, equal questions.
/// With `extras` also those that decide what else is computed. For hashes and comparisons.
std::string questionText(const Described& settings, bool extras = false);

}  // namespace noonmark
