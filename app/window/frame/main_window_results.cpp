#include <QAction>

#include "app/window/frame/main_window.h"
#include "app/window/project/comparison_rows.h"
#include "app/window/project/scenario_table.h"
#include "app/window/project/scenarios_dock.h"
#include "app/window/project/score_rows.h"
#include "app/window/study/results_dock.h"
#include "app/window/study/warnings_dock.h"
#include "app/window/view/view_panel.h"

// The part of MainWindow that shows results: studies, comparisons, scores, saved results.
namespace noonmark {

namespace {

QString text(const std::string& name) { return QString::fromStdString(name); }

std::vector<ResultRow> scoreRows(const ScoreAnswer& score) {
    return makeScoreRows(score.score, score.scenario, score.weights.name, formatText(score.settings.period));
}

}  // namespace

void MainWindow::connectResults() {
    connect(&workbench_, &Workbench::comparisonDone, this, &MainWindow::showComparison);
    connect(&workbench_, &Workbench::scoreDone, this, &MainWindow::showScore);
    connect(&workbench_, &Workbench::savedShown, this, [this] {
        mode_.showStudies();
        showSaved();
    });
    connect(&workbench_, &Workbench::longRun, this, &MainWindow::announceLongRun);
    connect(&workbench_, &Workbench::savedReweighed, this,
            [this] { panel_->results().setInFront(makeGroundAnswer(*workbench_.saved())); });
    connect(docks_.results, &ResultsDock::studyWanted, &workbench_, &Workbench::showStudyAgain);
}

void MainWindow::announceLongRun(const RunEstimate& estimate) {
    MessageBar& bar = panel_->messages();
    bar.showHelp(tr("The ray reference takes %1 (%2 rays). The automatic engine takes %3 and reports its "
                    "error against the ray reference.")
                     .arg(describeAbout(estimate.seconds), QString::number(estimate.rays, 'g', 2),
                          describeAbout(estimate.quickerSeconds)));
    bar.offer(tr("Use automatic engine"), [this] { workbench_.runQuicker(); });
    bar.offerToo(tr("Run ray reference"), [this] { workbench_.runAnyway(); });
}

// Order of precedence: saved result, score, comparison, study.
void MainWindow::showAnswer() {
    if (workbench_.saved()) return showSaved();
    if (workbench_.score()) return showScore();
    workbench_.comparison() ? showComparison() : showStudy();
}

void MainWindow::showStudy() {
    docks_.scenarios->table().setStudies(workbench_.studies(), workbench_.document().settings());
    if (workbench_.comparison() || workbench_.score() || workbench_.saved()) return;
    const auto study = workbench_.study();
    panel_->results().setInFront(std::nullopt);
    if (!study) return showPast();
    answered_ = study->settings;
    answerShown_ = true;
    panel_->results().setStudy(study);
    docks_.results->show(makeResultRows(*study));
    docks_.warnings->show(study->warnings);
    showDocument();
}

// The result for the buildings before the edit, marked as outdated, so that an edit does not clear the
// display.
void MainWindow::showPast() {
    const Workbench::PastAnswer& past = workbench_.past();
    if (!past.any()) return docks_.results->show({});
    GroundAnswer answer = past.score        ? makeGroundAnswer(past.score)
                          : past.comparison ? makeGroundAnswer(past.comparison)
                                            : makeGroundAnswer(past.study);
    answer.note = answer.note.isEmpty() ? tr("Outdated: buildings have changed")
                                        : tr("%1. Outdated: buildings have changed").arg(answer.note);
    answer.marked = true;
    panel_->results().setInFront(answer);
    if (past.score)
        docks_.results->show(scoreRows(*past.score), past.score->score.months);
    else
        docks_.results->show(past.comparison ? makeComparisonRows(computeFigures(*past.comparison))
                                             : makeResultRows(*past.study));
    showOutdated();
}

void MainWindow::showComparison() {
    const auto comparison = workbench_.comparison();
    if (workbench_.score() || workbench_.saved()) return;
    answered_ = comparison->settings.study;
    answerShown_ = true;
    panel_->results().setInFront(makeGroundAnswer(comparison));
    docks_.results->show(makeComparisonRows(computeFigures(*comparison)));
    docks_.warnings->show(comparison->study.total.warnings);
    showDocument();
}

void MainWindow::showScore() {
    const auto score = workbench_.score();
    answered_ = score->settings;
    panel_->results().setInFront(makeGroundAnswer(score));
    docks_.results->show(scoreRows(*score), score->score.months);
    docks_.warnings->show(score->score.warnings);
    raiseDock(docks_.results);
    showDocument();
}

void MainWindow::showSaved() {
    const auto saved = workbench_.saved();
    panel_->results().setInFront(makeGroundAnswer(*saved));
    docks_.results->show(makeRows(*saved), monthsOf(*saved));
    raiseDock(docks_.results);
    showDocument();
}

// States whether the displayed figures are up to date.
void MainWindow::showOutdated() {
    const auto saved = workbench_.saved();
    const auto score = workbench_.score();
    docks_.results->offerWayBack(saved || score);
    if (tools_.context().preview.shown())
        return docks_.results->setNote(
            tr("These figures do not include the building being designed. Build it, then run."));
    if (workbench_.past().any())
        return docks_.results->setNote(tr("Outdated figures: buildings have changed; %1.")
                                           .arg(workbench_.running().busy()
                                                    ? tr("new figures are being computed")
                                                    : tr("run again (Ctrl+R)")));
    if (saved) return docks_.results->setNote(describeSaved(*saved), !saved->upToDate());
    if (workbench_.document().settings() != answered_)
        return docks_.results->setNote(tr("Outdated figures: settings have changed; run again (Ctrl+R)."));
    const auto weights =
        score ? findWeights(workbench_.session().project(), score->weights.name) : Result<TimeWeights>();
    const bool other = score && (!weights || *weights != score->weights);
    docks_.results->setNote(other ? tr("Outdated score: the weight table has changed; score again.")
                                  : QString());
}

// The export writes the displayed result; the menu item names it.
QString MainWindow::exportWords() const {
    const auto comparison = workbench_.comparison();
    const auto score = workbench_.score();
    switch (workbench_.shown()) {
        case Workbench::Shown::comparison:
            return tr("Export %1 compared with %2").arg(text(comparison->to), text(comparison->from));
        case Workbench::Shown::score:
            return tr("Export the score of %1").arg(text(score->scenario));
        case Workbench::Shown::study:
            return tr("Export study");
        case Workbench::Shown::nothing:
        case Workbench::Shown::savedResult:
            return tr("Export");
    }
    return {};
}

void MainWindow::showExport() {
    QString words = exportWords();
    words.replace(QLatin1Char('&'), QStringLiteral("&&"));  // an ampersand in a name is not a mnemonic
    menus_.exportStudy->setText(tr("&%1...").arg(words));
}

void MainWindow::showStopped(bool cancelled) {
    panel_->results().setPartial(nullptr);
    if (!cancelled) return;
    panel_->messages().showNote(workbench_.study() ? tr("Cancelled. The previous study is shown.")
                                                   : tr("Cancelled. No study yet."));
}

void MainWindow::compare() {
    const bool comparing = !workbench_.session().baseline().empty();
    panel_->results().setInFront(std::nullopt);
    if (comparing && workbench_.session().baseline() != workbench_.session().scenario())
        return workbench_.run();
    showAnswer();
}

// After an edit or a change of scenario: recomputes the displayed kind of result if it is quick.
void MainWindow::answerAnew() {
    if (!answerShown_ || mode_.mode() == ViewMode::exploration) return;
    const ProjectSession& session = workbench_.session();
    const bool comparing = !session.baseline().empty() && session.baseline() != session.scenario();
    if (comparing ? workbench_.comparison() != nullptr : workbench_.study() != nullptr) return;
    if (workbench_.saved() || workbench_.reading().busy()) return;
    if (workbench_.running().busy()) return;  // the running study already uses the change
    if (workbench_.answerSeconds() < quickSeconds) workbench_.run();
}

void MainWindow::keepResult() {
    const auto comparison = workbench_.comparison();
    const auto score = workbench_.score();
    const std::string& scenario = workbench_.session().scenario();
    QString name = text(scenario);
    if (score)
        name = tr("Score of %1 with %2").arg(text(scenario), text(score->weights.name));
    else if (comparison)
        name = tr("%1 compared with %2").arg(text(comparison->to), text(comparison->from));
    workbench_.keepAnswer(tr("%1, %2").arg(name, text(formatText(answered_.period.start))));
}

}  // namespace noonmark
