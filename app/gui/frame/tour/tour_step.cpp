#include "app/gui/frame/tour/tour.h"

#include <QtGlobal>

#include "app/gui/docks/review/review_session.h"
#include "app/gui/session/workbench.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

namespace {

bool isNew(const void* before, const void* now) { return now != nullptr && now != before; }

}  // namespace

TourSnapshot takeTourSnapshot(Workbench& workbench, ReviewSession& review) {
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

bool isReached(TourGoal goal, const TourSnapshot& before, const TourSnapshot& now) {
    switch (goal) {
        case TourGoal::task:
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

namespace {

const TourPlan plans[] = {
    {"architect",
     QT_TRANSLATE_NOOP("Tour", "Architect: design a tower"),
     QT_TRANSLATE_NOOP("Tour", "A tower on a lot, its shadow while you shape it, and what it changes"),
     {{"towerDock", TourTask::show, nullptr, TourGoal::task,
       QT_TRANSLATE_NOOP("Tour",
                         "The green outlines in the view are lots. Towers are designed in the panel Tower.")},
      {"designTower", TourTask::click, nullptr, TourGoal::task,
       QT_TRANSLATE_NOOP(
           "Tour",
           "The list above has the lots of the project. Design tower puts a first tower on the one chosen.")},
      {"storeys", TourTask::set, "70", TourGoal::task,
       QT_TRANSLATE_NOOP(
           "Tour",
           "Type 70 storeys, or drag the arrow on the tower. Its shadow follows, and so do height and "
           "floor area.")},
      {"applyMassing", TourTask::click, nullptr, TourGoal::tower,
       QT_TRANSLATE_NOOP("Tour", "Build puts the tower into a new scenario. One undo takes it back.")},
      {"compareExisting", TourTask::trigger, nullptr, TourGoal::comparison,
       QT_TRANSLATE_NOOP("Tour",
                         "Scenario > Compare with the existing city asks what the tower changes. Where that "
                         "takes longer, the button Compare of the panel Study starts it.")},
      {"resultsDock", TourTask::none, nullptr, TourGoal::task,
       QT_TRANSLATE_NOOP("Tour",
                         "Brown ground gains shadow, blue loses it. The panel Results has the figures.")},
      {"exportResults", TourTask::none, nullptr, TourGoal::task,
       QT_TRANSLATE_NOOP(
           "Tour",
           "File > Export writes the comparison as PDF, picture, tables and data. That is the end of "
           "this tour.")}}},
    {"planner",
     QT_TRANSLATE_NOOP("Tour", "Planner: weigh shade over a year"),
     QT_TRANSLATE_NOOP("Tour",
                       "Shadow of a whole year, one moment of it, and a score of wanted and unwanted shadow"),
     {{"studyKind", TourTask::choose, "0", TourGoal::task,
       QT_TRANSLATE_NOOP(
           "Tour", "A study answers four questions. The first is what to measure: choose Hours of shadow.")},
      {"periodPreset", TourTask::choose, "5", TourGoal::task,
       QT_TRANSLATE_NOOP("Tour", "The second is when: choose the whole year.")},
      {"cell", TourTask::set, "10", TourGoal::task,
       QT_TRANSLATE_NOOP("Tour", "Cells of 10 m are enough for a first look; smaller ones take longer.")},
      {"run", TourTask::click, nullptr, TourGoal::study,
       QT_TRANSLATE_NOOP(
           "Tour", "The line above the button says how long a study will take, before it runs. Start it.")},
      {"lookSpan", TourTask::choose, "2", TourGoal::task,
       QT_TRANSLATE_NOOP(
           "Tour",
           "The map shows the whole year. Choose One moment to see sun and shadow at a date and time.")},
      {"lookSpan", TourTask::choose, "0", TourGoal::task,
       QT_TRANSLATE_NOOP("Tour", "Play and the two sliders move the sun. Whole period returns to the year.")},
      {"weightsDock", TourTask::show, nullptr, TourGoal::task,
       QT_TRANSLATE_NOOP(
           "Tour",
           "Shade is welcome in summer and unwelcome in winter. The panel Weights says how much, month "
           "by month.")},
      {"score", TourTask::click, nullptr, TourGoal::score,
       QT_TRANSLATE_NOOP(
           "Tour",
           "Compute score adds up the year by these weights. Above zero, wanted shade outweighs "
           "unwanted shadow.")},
      {"exportResults", TourTask::none, nullptr, TourGoal::task,
       QT_TRANSLATE_NOOP(
           "Tour",
           "File > Export writes the score by month as tables, charts and maps for GIS. That is the "
           "end of this tour.")}}},
    {"board",
     QT_TRANSLATE_NOOP("Tour", "Review board: judge a proposal"),
     QT_TRANSLATE_NOOP("Tour", "A place whose sunlight matters, a proposal, and the verdicts of a rule"),
     {{"drawPlace", TourTask::draw, nullptr, TourGoal::place,
       QT_TRANSLATE_NOOP(
           "Tour",
           "A review needs places whose sunlight matters. Choose Study > Draw place and click the "
           "corners of a lawn in the park; Enter finishes.")},
      {"towerDock", TourTask::show, nullptr, TourGoal::task,
       QT_TRANSLATE_NOOP(
           "Tour", "It also needs a proposal. Here we design one; usually the project has it already.")},
      {"designTower", TourTask::click, nullptr, TourGoal::task,
       QT_TRANSLATE_NOOP("Tour", "Design tower puts a tower on the lot chosen in the list.")},
      {"storeys", TourTask::set, "90", TourGoal::task,
       QT_TRANSLATE_NOOP("Tour", "Give it 90 storeys, so that its shadow reaches the lawn.")},
      {"applyMassing", TourTask::click, nullptr, TourGoal::tower,
       QT_TRANSLATE_NOOP("Tour", "Build makes it a scenario, which can be compared with the existing city.")},
      {"reviewByRule", TourTask::trigger, nullptr, TourGoal::task,
       QT_TRANSLATE_NOOP("Tour", "Study > Review by a rule opens the panel Review.")},
      {"reviewRule", TourTask::choose, "ceqr", TourGoal::task,
       QT_TRANSLATE_NOOP(
           "Tour",
           "Choose the rule of the board, here CEQR of New York. Its tool tip says what it asks and "
           "how sure its figures are.")},
      {"runReview", TourTask::click, nullptr, TourGoal::review,
       QT_TRANSLATE_NOOP("Tour", "Run review judges every ticked place on the days of the rule.")},
      {"exportReview", TourTask::none, nullptr, TourGoal::task,
       QT_TRANSLATE_NOOP(
           "Tour",
           "The table has the verdicts and the numbers behind them. Export shows the sheets and writes "
           "them with all data. That is the end of this tour.")}}},
};

}  // namespace

std::span<const TourPlan> listTours() { return plans; }

}  // namespace noonmark
