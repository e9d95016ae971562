#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/review/library/read_rule.h"
#include "core/study/elements/place_elements.h"
#include "scenarios/scenario.h"

namespace noonmark {

/// What the user has chosen to review. Saved with the view of the project.
struct ReviewChoice {
    std::string rule = "four-days";
    RuleChoices options;              ///< of rules with choices; missing ones: the first option
    std::string from = existingCity;  ///< the baseline
    std::string to;                   ///< the scenario; empty: whichever is displayed
    bool allPlaces = true;
    std::vector<std::string> places;  ///< names, unless all
    ElementSettings windows;          ///< of rules about windows: facades, or windows of a file
    bool operator==(const ReviewChoice&) const = default;
};

/// The choice as JSON text.
std::string formatText(const ReviewChoice& choice);
/// Reads what is valid; the rest is as in ReviewChoice{}. Accepts any text.
ReviewChoice parseReviewChoice(const std::string& text);

}  // namespace noonmark
