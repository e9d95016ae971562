#pragma once

#include <cstddef>

#include "app/gui/frame/tour/tour_step.h"

namespace noonmark {

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
