#pragma once

#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/receivers/place.h"
#include "core/review/rule/rule.h"
#include "scenarios/project/project.h"

namespace noonmark {

/// What a review may be about: the places of a project or, by a rule with lines, its lots, as they are drawn.
std::vector<Place> placesUnder(const Rule& rule, const Project& project);
/// The places of these names; for a rule with lines the lots, and places where no lot has the name. Error: an
/// unknown name.
Result<std::vector<Place>> findPlacesUnder(const Rule& rule, const Project& project,
                                           const std::vector<std::string>& names);

/// Places as a rule measures them.
struct PlacesToReview {
    std::vector<Place> places;
    Warnings moved;  ///< one for each lot with roads: its line was moved out, or why not
};
/// Moves the line of lots out along their roads, where the rule says so. Error: that of moveLineOut(), naming
/// the lot.
Result<PlacesToReview> moveLines(const Rule& rule, const Project& project, std::vector<Place> places);

}  // namespace noonmark
