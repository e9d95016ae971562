#pragma once

#include <string>
#include <vector>

#include "core/city/city.h"
#include "core/review/rule/rule.h"

namespace noonmark {

/// What a review of places or windows leaves unchecked: what the rule states, and what it asks of the city
/// that the city does not have.
std::vector<std::string> listUnchecked(const Rule& rule, const City& city);

}  // namespace noonmark
