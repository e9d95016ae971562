#pragma once

#include <string>
#include <vector>

#include "core/receivers/place.h"
#include "core/review/rule.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// What a review may be about: the places of a project or, by a rule with lines, its lots as they are drawn.
std::vector<Place> placesUnder(const Rule& rule, const Project& project);

/// The places of these names or, by a rule with lines, the lots, with their line moved out along their roads
/// where the rule says so. Of a name that no lot has, the place. Error: an unknown name; errors of
/// moveLineOut().
Result<std::vector<Place>> findPlacesUnder(const Rule& rule, const Project& project,
                                           const std::vector<std::string>& names);

}  // namespace noonmark
