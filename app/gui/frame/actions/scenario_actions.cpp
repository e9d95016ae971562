#include "app/gui/frame/actions/scenario_actions.h"

#include "app/gui/base/widgets/make_action.h"
#include "app/gui/docks/project/project_dock.h"
#include "app/gui/docks/scenarios/latest_answers.h"
#include "app/gui/docks/scenarios/scenarios_dock.h"
#include "app/gui/session/workbench.h"

namespace noonmark {

ScenarioActions::ScenarioActions(Workbench& workbench, LatestAnswers& answers, ProjectDock& tree,
                                 ScenariosDock& scenarios)
    : newScenario_(
          makeAction(this, tr("&New scenario"), {}, tr("Starts from the existing city"), "scenario")),
      newFromThis_(makeAction(this, tr("New scenario &from this one"), {},
                              tr("Starts from the displayed scenario and inherits its later changes"))),
      compare_(makeAction(this, tr("&Compare with the existing city"), QKeySequence(tr("Ctrl+K")),
                          tr("Shows how many minutes of shadow the scenario adds or removes"), "compare")),
      measureAll_(makeAction(this, tr("&Measure all scenarios"), {},
                             tr("Runs the same study for each scenario, for comparison side by side"),
                             "analyse")),
      scoreAll_(makeAction(this, tr("&Score all scenarios"), {},
                           tr("Computes the scores that the dock Scenarios lacks, with the table that the "
                              "dock Weights shows"))),
      reviewAll_(makeAction(this, tr("&Review all scenarios"), {},
                            tr("Reviews the scenarios whose verdicts the dock Scenarios lacks, by the rule "
                               "chosen in the dock Review"))) {
    compare_->setObjectName(QStringLiteral("compareExisting"));
    compare_->setCheckable(true);
    ProjectSession& session = workbench.session();
    connect(newScenario_, &QAction::triggered, this, [&tree] { tree.addScenario({}); });
    connect(newFromThis_, &QAction::triggered, this,
            [&tree, &session] { tree.addScenario(session.scenario()); });
    connect(compare_, &QAction::triggered, this,
            [&session](bool on) { session.compareWith(on ? existingCity : std::string()); });
    connect(&session, &ProjectSession::changed, this,
            [this, &session] { compare_->setChecked(session.baseline() == existingCity); });
    connect(measureAll_, &QAction::triggered, &workbench, &Workbench::measureAll);
    connect(&scenarios, &ScenariosDock::measureAllRequested, &workbench, &Workbench::measureAll);
    connect(scoreAll_, &QAction::triggered, &answers, &LatestAnswers::scoreAll);
    connect(&scenarios, &ScenariosDock::scoreAllRequested, &answers, &LatestAnswers::scoreAll);
    connect(reviewAll_, &QAction::triggered, &answers, &LatestAnswers::reviewAll);
    connect(&scenarios, &ScenariosDock::reviewAllRequested, &answers, &LatestAnswers::reviewAll);
}

QList<QAction*> ScenarioActions::actions() const {
    return {newScenario_, newFromThis_, compare_, measureAll_, scoreAll_, reviewAll_};
}

}  // namespace noonmark
