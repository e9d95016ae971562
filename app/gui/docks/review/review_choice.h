#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/review/library/read_rule.h"
#include "core/study/elements/place_elements.h"
#include "scenarios/scenario.h"

namespace noonmark {

/// Which places are reviewed.
enum class ReviewedPlaces {
    automatic,  ///< all, or those in reach where there are many: see screensPlaces()
    inReach,    ///< those that the shadow of the proposal reaches
    all,
    chosen  ///< those of ReviewChoice::places
};

/// Whether only those in reach of so many places are reviewed.
inline bool screensPlaces(ReviewedPlaces reviewed, std::size_t places) {
    constexpr std::size_t few = 50;  // so many are reviewed within seconds, and a table of them is read
    return reviewed == ReviewedPlaces::inReach || (reviewed == ReviewedPlaces::automatic && places > few);
}

/// What the user has chosen to review. Saved with the view of the project.
struct ReviewChoice {
    std::string rule;                 ///< empty: that of the site, see suggestRule()
    RuleChoices options;              ///< of rules with choices; missing ones: the first option
    std::string from = existingCity;  ///< the baseline
    std::string to;                   ///< the scenario; empty: whichever is displayed
    ReviewedPlaces reviewed = ReviewedPlaces::automatic;
    std::vector<std::string> places;  ///< names of the chosen ones
    ElementSettings windows;          ///< of rules about windows: facades, or windows of a file
    bool operator==(const ReviewChoice&) const = default;
};

/// The choice as JSON text.
std::string formatText(const ReviewChoice& choice);
/// Reads what is valid; the rest is as in ReviewChoice{}. Accepts any text.
ReviewChoice parseReviewChoice(const std::string& text);

}  // namespace noonmark
