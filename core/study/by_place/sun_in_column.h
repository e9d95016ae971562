#pragma once

#include <optional>

#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

/// The columns of an answer: without trees, and those that were measured with them, evergreens first.
std::vector<TreeColumns> listSunColumns(const SunOfCities& sun);

/// The answer with the sun of one column, its changes and its errors in place of those without trees, and no
/// columns besides: for whatever states one sun of each place. None: it has no such column, or it is that
/// without trees, which the answer states itself. Copies the answer.
std::optional<SunOfCities> inColumn(const SunOfCities& sun, TreeColumns column);

}  // namespace noonmark
