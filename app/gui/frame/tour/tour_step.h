#pragma once

// Guided tours. This file has the steps as data and tells when a step is done. Tour walks through the steps
// of one tour, TourControl finds and uses the control of a step in the window, TourBubble shows the text
// beside it.

#include <cstddef>
#include <span>
#include <vector>

namespace noonmark {

/// What the user does in a step, and "Show me" does for them.
enum class TourDeed {
    none,     ///< only reads
    show,     ///< brings a dock to the front
    click,    ///< a button
    choose,   ///< an entry of a list: by its data, else by its index
    set,      ///< a number
    trigger,  ///< an entry of a menu
    draw,     ///< a polygon on the ground
};

/// When the step is done.
enum class TourGoal {
    deed,  ///< as soon as the user did it
    tower,
    study,
    comparison,
    score,
    place,
    review,  ///< when the window has a new one
};

struct TourStep {
    const char* control;  ///< object name of the widget, dock or action
    TourDeed deed;
    const char* value;  ///< of choose and set; otherwise null
    TourGoal goal;
    const char* text;  ///< English, in the translation context "Tour"
};

struct TourPlan {
    const char* key;  ///< "architect"
    const char* title;
    const char* about;
    std::vector<TourStep> steps;
};

/// One for each user: architect, planner, review board. All start from the sample Central Park South.
std::span<const TourPlan> listTours();

class ReviewSession;
class Workbench;

/// What the window had when a step began.
struct TourBefore {
    const void* study = nullptr;
    const void* comparison = nullptr;
    const void* score = nullptr;
    const void* review = nullptr;
    std::size_t places = 0;
    std::size_t edits = 0;  ///< of all scenarios
};

TourBefore lookBefore(Workbench& workbench, ReviewSession& review);

/// Whether the window has something new of that kind. Never for TourGoal::deed.
bool isReached(TourGoal goal, const TourBefore& before, const TourBefore& now);

}  // namespace noonmark
