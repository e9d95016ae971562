#include "app/gui/frame/tour/tour_goal.h"

#include "app/gui/docks/review/review_session.h"
#include "app/gui/session/workbench.h"

namespace noonmark {

namespace {

bool isNew(const void* before, const void* now) { return now != nullptr && now != before; }

}  // namespace

TourBefore lookBefore(Workbench& workbench, ReviewSession& review) {
    const Project& project = workbench.session().project();
    std::size_t edits = 0;
    for (const Scenario& scenario : project.scenarios) edits += scenario.edits.size();
    return {workbench.study().get(),
            workbench.answerAs<ImpactAnswer>().get(),
            workbench.answerAs<ScoreAnswer>().get(),
            review.shown().get(),
            project.places.size(),
            edits};
}

bool isReached(TourGoal goal, const TourBefore& before, const TourBefore& now) {
    switch (goal) {
        case TourGoal::deed:
            return false;
        case TourGoal::tower:
            return now.edits > before.edits;
        case TourGoal::study:
            return isNew(before.study, now.study);
        case TourGoal::comparison:
            return isNew(before.comparison, now.comparison);
        case TourGoal::score:
            return isNew(before.score, now.score);
        case TourGoal::place:
            return now.places > before.places;
        case TourGoal::review:
            return isNew(before.review, now.review);
    }
    return false;
}

}  // namespace noonmark
