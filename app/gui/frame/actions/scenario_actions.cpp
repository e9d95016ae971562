#include "app/gui/frame/actions/scenario_actions.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>

#include "app/gui/base/files/file_dialogs.h"
#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/export/table_text.h"
#include "app/gui/docks/project/project_dock.h"
#include "app/gui/docks/scenarios/latest_answers.h"
#include "app/gui/docks/scenarios/scenario_table.h"
#include "app/gui/docks/scenarios/scenarios_dock.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/workbench.h"
#include "app/report/bodies/body_files.h"
#include "core/io/files/check_output.h"
#include "core/io/files/write_text.h"
#include "core/study/by_place/sun_by_place.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/massing/tower_design.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

namespace {

QString listFormats() {
    QStringList formats;
    for (const BodyFormat& format : bodyFormats())
        formats << QStringLiteral("%1 (*%2)").arg(QLatin1String(format.name), QLatin1String(format.ending));
    return formats.join(QStringLiteral(";;"));
}

}  // namespace

ScenarioActions::ScenarioActions(Workbench& workbench, LatestAnswers& answers, ProjectDock& tree,
                                 ScenariosDock& scenarios)
    : QObject(&scenarios),
      workbench_(workbench),
      dock_(scenarios),
      newScenario_(
          makeAction(this, tr("&New scenario"), {}, tr("Starts from the existing city"), "scenario")),
      newFromThis_(makeAction(this, tr("New scenario &from this one"), {},
                              tr("Starts from the displayed scenario and inherits its later changes"))),
      compare_(makeAction(this, tr("&Compare with the existing city"), QKeySequence(tr("Ctrl+K")),
                          tr("Shows how many minutes of shadow the scenario adds or removes"), "compare")),
      measureAll_(makeAction(this, tr("&Measure all scenarios"), {},
                             tr("Runs the same study for each scenario, for comparison side by side"),
                             "analyse")),
      scoreAll_(makeAction(this, tr("&Score all scenarios"), {},
                           tr("Computes the scores that the panel Scenarios lacks, with the table that the "
                              "panel Weights shows"))),
      reviewAll_(makeAction(this, tr("&Review all scenarios"), {},
                            tr("Reviews the scenarios whose verdicts the panel Scenarios lacks, by the rule "
                               "chosen in the panel Review"))),
      exportBuildings_(
          makeAction(this, tr("&Export buildings..."), {},
                     tr("Writes the buildings that the displayed scenario proposes as glTF, OBJ, "
                        "DXF or GeoPackage; of the existing city all buildings"))) {
    compare_->setObjectName(QStringLiteral("compareExisting"));
    compare_->setCheckable(true);
    ProjectSession& session = workbench.session();
    // A second click while the first one's scenario is being prepared makes no other.
    for (QAction* action : {newScenario_, newFromThis_}) {
        connect(&workbench.following(), &JobSlot::started, action, [action] { action->setEnabled(false); });
        connect(&workbench.following(), &JobSlot::ended, action, [action] { action->setEnabled(true); });
    }
    connect(newScenario_, &QAction::triggered, this, [&tree] { tree.addScenario({}); });
    connect(newFromThis_, &QAction::triggered, this,
            [&tree, &session] { tree.addScenario(session.scenario()); });
    connect(compare_, &QAction::triggered, this, &ScenarioActions::compare);
    connect(&session, &ProjectSession::changed, this,
            [this, &session] { compare_->setChecked(session.baseline() == existingCity); });
    connectMeasuring();
    for (const QAction* action : {measureAll_, scoreAll_, reviewAll_})
        connect(action, &QAction::triggered, this, &ScenarioActions::tableRequested);
    connect(scoreAll_, &QAction::triggered, &answers, &LatestAnswers::scoreAll);
    connect(&scenarios, &ScenariosDock::scoreAllRequested, &answers, &LatestAnswers::scoreAll);
    connect(reviewAll_, &QAction::triggered, &answers, &LatestAnswers::reviewAll);
    connect(&scenarios, &ScenariosDock::reviewAllRequested, &answers, &LatestAnswers::reviewAll);
    connect(&scenarios, &ScenariosDock::copyRequested, this, [this] {
        QGuiApplication::clipboard()->setText(makeTableText(dock_.shownTable()));
        Q_EMIT workbench_.noted(tr("The table of scenarios is on the clipboard"));
    });
    connect(exportBuildings_, &QAction::triggered, this, [this] {
        const QString name = QString::fromStdString(workbench_.session().scenario());
        saveBuildings(
            askForBuildings(&dock_, name + QLatin1String(bodyFormats().front().ending), listFormats()));
    });
    connect(&scenarios, &ScenariosDock::exportRequested, this,
            [this] { saveTable(askForTable(&dock_, QStringLiteral("scenarios.csv"))); });
    connect(&scenarios, &ScenariosDock::monthsExportRequested, this,
            [this] { saveMonths(askForTable(&dock_, QStringLiteral("scenario_months.csv"))); });
}

void ScenarioActions::connectMeasuring() {
    connect(measureAll_, &QAction::triggered, this, [this] { measure(&Workbench::measureAll); });
    connect(&dock_, &ScenariosDock::measureAllRequested, this, [this] { measure(&Workbench::measureAll); });
    connect(&dock_, &ScenariosDock::measureMonthsRequested, this,
            [this] { measure(&Workbench::measureAllByMonth); });
    // Its time may be estimated first, in a run of its own.
    connect(&workbench_.running(), &JobSlot::started, this,
            [this] { dock_.table().setWorking(ScenarioWork::measuring, measuring_); });
    connect(&workbench_, &Workbench::answered, this, [this] { measuring_ = false; });
    connect(&workbench_, &Workbench::studyStopped, this, [this](bool cancelled) {
        if (cancelled) measuring_ = false;
    });
}

void ScenarioActions::measure(void (Workbench::*all)()) {
    if (all == &Workbench::measureAll && measurePlaces_ && measurePlaces_()) return;
    measuring_ = true;
    (workbench_.*all)();
    if (!workbench_.running().busy()) measuring_ = false;
}

// The difference at once where it is known. Else both scenarios side by side, with the shadows of the present
// moment, while it is computed.
void ScenarioActions::compare(bool on) {
    ProjectSession& session = workbench_.session();
    if (!on && awaited_) endWaiting();
    session.compareWith(on ? existingCity : std::string());
    if (!on) return;
    if (!workbench_.comparing())
        return Q_EMIT workbench_.noted(
            session.project().scenarios.empty()
                ? tr("There is no scenario yet to compare. A change to a building begins one: click a "
                     "building, and drag its arrow or type its height")
                : tr("The existing city is displayed. Choose a scenario at the top, and compare it"));
    if (workbench_.answerAs<ImpactAnswer>()) return Q_EMIT comparisonShown();
    if (workbench_.answerAs<ScoreAnswer>()) return compareScores();
    if (beside_ && !beside_->isChecked()) beside_->trigger();
    awaitComparison();
    if (!workbench_.running().busy()) workbench_.run();  // a quick one has begun by itself
}

// The table has the scores of all scenarios and their differences.
void ScenarioActions::compareScores() {
    scoreAll_->trigger();
    Q_EMIT workbench_.noted(tr("The table of scenarios compares the scores"));
}

void ScenarioActions::awaitComparison() {
    awaited_ = std::make_unique<QObject>();
    connect(&workbench_, &Workbench::answered, awaited_.get(), [this] {
        const auto places = sunOf(workbench_.answer());
        if (!workbench_.answerAs<ImpactAnswer>() && (!places || places->compared.empty())) return;
        endWaiting();
        Q_EMIT comparisonShown();
    });
    connect(&workbench_, &Workbench::projectOpened, awaited_.get(), [this] { stopWaiting(); });
    connect(&workbench_, &Workbench::studyStopped, awaited_.get(), [this] { stopWaiting(); });
}

// Leaves what is shown.
void ScenarioActions::stopWaiting() {
    if (awaited_) awaited_.release()->deleteLater();
}

void ScenarioActions::endWaiting() {
    stopWaiting();
    if (beside_ && beside_->isChecked()) beside_->trigger();
}

void ScenarioActions::saveTable(const QString& file) { save(file, dock_.table().csv()); }

void ScenarioActions::saveBuildings(const QString& file) {
    if (file.isEmpty()) return;
    const std::filesystem::path path = file.toStdString();
    if (const auto may = checkOutput(path, detectOutputKind(path), workbench_.exportRules()); !may)
        return Q_EMIT workbench_.failed(may.error());
    const ProjectSession& session = workbench_.session();
    const auto proposed = listProposed(session.project().scenarios, session.scenario());
    if (!proposed) return Q_EMIT workbench_.failed(proposed.error());
    const bool existing = session.scenario() == existingCity;
    const auto city = session.city();
    workbench_.writing().start<WrittenBodies>(
        tr("Export buildings"),
        [=, ids = *proposed](Progress&, const std::stop_token&) {
            return writeBodies(path, *city, ids,
                               {.which = existing ? WrittenBuildings::all : WrittenBuildings::proposed});
        },
        [this, file](const Result<WrittenBodies>& written) {
            if (!written) return Q_EMIT workbench_.failed(written.error());
            Q_EMIT workbench_.noted(tr("%1 building(s) saved as %2", "", pluralNumber(written->buildings))
                                        .arg(formatCount(written->buildings), file));
        });
}

void ScenarioActions::saveMonths(const QString& file) {
    save(file, monthsCsv(makeMonthCharts(dock_.table().months())));
}

void ScenarioActions::save(const QString& file, const std::string& csv) {
    if (file.isEmpty()) return;
    const std::filesystem::path path = file.toStdString();
    auto saved = checkOutput(path, OutputKind::table, workbench_.exportRules());
    if (saved) saved = writeText(path, csv);
    if (!saved) return Q_EMIT workbench_.failed(saved.error());
    Q_EMIT workbench_.noted(tr("Saved as %1").arg(file));
}

QList<QAction*> ScenarioActions::actions() const {
    return {newScenario_, newFromThis_, compare_, measureAll_, scoreAll_, reviewAll_, exportBuildings_};
}

}  // namespace noonmark
