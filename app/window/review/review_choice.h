#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/receivers/point_receivers.h"
#include "core/review/read_rule.h"
#include "scenarios/scenario.h"

namespace noonmark {

/// The windows that a rule about windows is evaluated on.
struct WindowChoice {
    bool ofFile = false;                  ///< else one window in each bay and storey of facades
    std::string file;                     ///< points or polygons with heights
    std::string buildings;                ///< names or ids with commas between them; empty: all
    double bayM = FacadeSettings{}.bayM;  ///< as in FacadeSettings
    double storeyM = FacadeSettings{}.storeyM;
    bool operator==(const WindowChoice&) const = default;
};

/// What the user has chosen to review. Saved with the view of the project.
struct ReviewChoice {
    std::string rule = "four-days";
    RuleChoices options;              ///< of rules with choices; missing ones: the first option
    std::string from = existingCity;  ///< the baseline
    std::string to;                   ///< the scenario; empty: whichever is displayed
    bool allPlaces = true;
    std::vector<std::string> places;  ///< names, unless all
    WindowChoice windows;             ///< of rules about windows
    bool operator==(const ReviewChoice&) const = default;
};

/// The choice as JSON text.
std::string formatText(const ReviewChoice& choice);
/// Reads what is valid; the rest is as in ReviewChoice{}. Accepts any text.
ReviewChoice parseReviewChoice(const std::string& text);

}  // namespace noonmark
