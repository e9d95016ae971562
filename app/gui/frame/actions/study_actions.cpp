#include "app/gui/frame/actions/study_actions.h"

#include <QMenu>
#include <algorithm>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/project/project_dock.h"
#include "app/gui/docks/results/result_display.h"
#include "app/gui/docks/review/glazing/glazing_session.h"
#include "app/gui/docks/review/review_dock.h"
#include "app/gui/docks/review/review_form.h"
#include "app/gui/docks/review/verdict_table.h"
#include "app/gui/docks/study_form/study_dock.h"
#include "app/gui/docks/weights/weights_dock.h"
#include "app/gui/frame/actions/place_actions.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/workbench.h"
#include "app/gui/tools/preview/edit_preview.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/panel/view_presets.h"

namespace noonmark {

namespace {

constexpr float aroundRegion = 0.25F;  // of its sides, shown on each side of it

}  // namespace

StudyActions::StudyActions(Workbench& workbench, const ModeSwitch& mode, ResultDisplay& display,
                           ViewPanel& panel)
    : workbench_(workbench),
      mode_(mode),
      display_(display),
      panel_(panel),
      run_(makeAction(this, tr("&Run"), QKeySequence(tr("Ctrl+R")), tr("Compute the shadow in the region"),
                      "run")),
      cancel_(makeAction(this, tr("&Cancel"), QKeySequence(tr("Ctrl+.")),
                         tr("Stop the study that is running"), "cancel")),
      gross_(makeAction(this, tr("Show &gross shadow"), QKeySequence(tr("Ctrl+1")),
                        tr("Minutes in shadow per day"))),
      continuous_(makeAction(this, tr("Show c&ontinuous shadow"), QKeySequence(tr("Ctrl+2")),
                             tr("Longest unbroken run in shadow"))) {
    connect(cancel_, &QAction::triggered, &workbench_.running(), &JobSlot::cancel);
    connect(gross_, &QAction::triggered, this, [this] { panel_.legend().setMeasure(ShadowMeasure::gross); });
    connect(continuous_, &QAction::triggered, this,
            [this] { panel_.legend().setMeasure(ShadowMeasure::continuous); });
    connect(&workbench_, &Workbench::answered, &panel_.messages(), &MessageBar::dismiss);
    connect(&workbench_, &Workbench::studyStopped, this, &StudyActions::showStopped);
    connect(&workbench_, &Workbench::longRun, this, &StudyActions::announceLongRun);
    connect(&workbench_.session(), &ProjectSession::comparisonRequested, this, &StudyActions::compare);
}

void StudyActions::listenTo(StudyDock& study, ProjectDock& tree, WeightsDock& weights) {
    connect(&study, &StudyDock::runRequested, this, &StudyActions::run);
    connect(run_, &QAction::triggered, &study,
            [this, &study] { study.kind() == StudyKind::places ? study.run() : run(); });
    connect(&weights, &WeightsDock::scoreRequested, this, [this](const std::string& table) {
        goToRegion();
        workbench_.runScore(table);
    });
    connect(&tree, &ProjectDock::periodChosen, this, &StudyActions::setPeriod);
    connect(&tree, &ProjectDock::savePeriodRequested, this, &StudyActions::savePeriod);
}

void StudyActions::run() {
    goToRegion();
    workbench_.run();
}

// The map of a region out of sight would appear where nobody looks.
void StudyActions::goToRegion() const {
    const Region &region = workbench_.document().settings().region, seen = panel_.visibleGround();
    if (region.polygons.empty() || workbench_.measuresElements()) return;
    const auto middleOf = [](const Region& of) {
        const Box2 box = bounds(of);
        return glm::dvec2(box.low + box.high) * 0.5;
    };
    const auto holds = [](const Region& of, glm::dvec2 point) {
        return std::ranges::any_of(of.polygons, [&](const Footprint& one) { return contains(one, point); });
    };
    const bool seesGround = !seen.polygons.empty();
    if (seesGround && (holds(seen, middleOf(region)) || holds(region, middleOf(seen)))) return;
    const Box2 box = bounds(region);
    const glm::vec2 border = (box.high - box.low) * aroundRegion;
    panel_.navigator().show({box.low - border, box.high + border});
}

void StudyActions::listQuestions(QMenu& menu) const {
    menu.setObjectName(QStringLiteral("questions"));
    menu.menuAction()->setVisible(false);
    connect(qobject_cast<QMenu*>(menu.parent()), &QMenu::aboutToShow, &menu, [this, &menu] {
        menu.clear();
        for (const Question* question : workbench_.questions()) {
            if (question->help.empty()) continue;
            QAction* entry = menu.addAction(translated(question->label));
            entry->setStatusTip(translated(question->help));
            connect(entry, &QAction::triggered, this, [this, question] {
                goToRegion();
                workbench_.ask(*question);
            });
        }
        menu.menuAction()->setVisible(!menu.isEmpty());
    });
}

void StudyActions::setPeriod(const Period& period) {
    StudySettings settings = workbench_.document().settings();
    settings.period = period;
    workbench_.document().change(settings, tr("period"));
}

void StudyActions::savePeriod() {
    Project next = workbench_.session().project();
    const Period& period = workbench_.document().settings().period;
    const std::string name = freeName(next, ProjectPart::period, formatText(period.start));
    next.periods.push_back({name, period});
    workbench_.session().change(std::move(next), tr("save period %1").arg(QString::fromStdString(name)));
}

void StudyActions::compare() {
    if (workbench_.comparing()) run_->trigger();
}

void StudyActions::runAgainIfQuick() {
    if (!display_.anyShown() || mode_.mode() == ViewMode::exploration) return;
    if (workbench_.isAnswered()) return;
    if (const auto answer = workbench_.answer(); answer && !answer->settings())
        return;  // a review, or a saved result
    if (workbench_.reading().busy()) return;
    if (workbench_.running().busy()) return;  // the running study already uses the change
    if (workbench_.answerSeconds() < quickSeconds) workbench_.runAgain();
}

// A quick result is recomputed at once, so that it can be explored; of a slow one the results dock shows what
// the project file holds, or says how to compute it again.
void StudyActions::repeatSaved() {
    const ViewState& view = workbench_.openedView();
    display_.setHint({});
    const bool isExploring = view.mode == ViewMode::exploration;
    if (!view.answer.empty() && !isExploring && view.answerSeconds < quickSeconds)
        return workbench_.runAgain();
    if (isExploring) offerMeasured();
    if (!isExploring && showMeasured()) return;
    if (view.answer.empty()) return;
    display_.setHint(
        view.answer == "comparison"
            ? tr("%1 was compared with %2 when the project was saved. Run (Ctrl+R) repeats the comparison, "
                 "in %3.")
                  .arg(scenarioName(view.scenario), scenarioName(view.baseline),
                       describeAbout(view.answerSeconds))
            : tr("A study was shown when the project was saved. Run (Ctrl+R) computes it again, in %1.")
                  .arg(describeAbout(view.answerSeconds)));
}

// Whether the project file holds the answer that was displayed.
bool StudyActions::showMeasured() {
    const MeasuredAnswers measured = workbench_.measured();
    const auto shown = std::ranges::find_if(
        measured, [&](const auto& one) { return one->name() == workbench_.openedView().shown; });
    if (shown == measured.end()) return false;
    workbench_.showMeasured(**shown);
    return true;
}

// The one that was displayed, else the last. What was measured is not to be missed where none is shown.
void StudyActions::offerMeasured() {
    const MeasuredAnswers measured = workbench_.measured();
    if (measured.empty()) return;
    const auto shown = std::ranges::find_if(
        measured, [&](const auto& one) { return one->name() == workbench_.openedView().shown; });
    const auto offered = shown == measured.end() ? measured.back() : *shown;
    const QString name = shownName(*offered);
    MessageBar& bar = panel_.messages();
    bar.showHelp(measured.size() == 1
                     ? tr("The project holds what was measured: %1.").arg(name)
                     : tr("The project holds %1 answers, all in the list of Results; among them %2.")
                           .arg(formatCount(measured.size()), name));
    bar.offer(tr("Show it"), [this, offered] { workbench_.showMeasured(*offered); });
}

void StudyActions::announceLongRun(const RunEstimate& estimate) {
    MessageBar& bar = panel_.messages();
    if (estimate.quickerSeconds < estimate.seconds / 2) {
        bar.showHelp(
            tr("This study takes %1 (%2). The accuracy Quick takes %3 and measures its error against "
               "rays.")
                .arg(describeAbout(estimate.seconds), estimate.engine,
                     describeAbout(estimate.quickerSeconds)));
        bar.offer(tr("Run quickly"), [this] { workbench_.runQuicker(); });
        bar.offerSecond(tr("Run it all the same"), [this] { workbench_.runAnyway(); });
        return;
    }
    bar.showHelp(tr("This study takes %1 (%2). Larger cells, fewer days or a smaller region make it quicker.")
                     .arg(describeAbout(estimate.seconds), estimate.engine));
    bar.offer(tr("Run it all the same"), [this] { workbench_.runAnyway(); });
}

void StudyActions::showStopped(bool cancelled) {
    if (!cancelled) return;
    const bool isShown = workbench_.answer() || workbench_.past();
    panel_.messages().showNote(isShown ? tr("Cancelled. The previous answer is shown.") : tr("Cancelled."));
}

ReviewActions::ReviewActions(ReviewSession& review, GlazingSession& windows, const Panels& panels,
                             EditPreview& preview, PlaceActions& places, ViewPanel& panel)
    : review_(review),
      windows_(windows),
      panel_(panel),
      show_(makeAction(this, tr("Re&view by a rule..."), QKeySequence(tr("Ctrl+Shift+R")),
                       tr("Evaluate the rule of a review board on the places of the project"), "review")),
      export_(makeAction(this, tr("Export t&he review..."), {},
                         tr("Shows the sheets of the review, and writes them with its tables and drawings"),
                         "sheets")) {
    show_->setObjectName(QStringLiteral("reviewByRule"));
    connect(show_, &QAction::triggered, this, &ReviewActions::dockRequested);
    connect(export_, &QAction::triggered, this, &ReviewActions::exportReview);
    connect(&panels.answer, &ReviewDock::exportRequested, this, &ReviewActions::exportReview);
    connect(&panels.question, &ReviewForm::placePointedAt, &panel_, &ViewPanel::highlightPlace);
    connect(&panels.question, &ReviewForm::drawPlaceRequested, &places,
            [&places, &form = panels.question](PlaceKind kind) {
                places.draw(kind, [&form](const std::string& name) { form.takeDrawn(name); });
            });
    connect(&panels.answer, &ReviewDock::placePointedAt, &panel_, &ViewPanel::highlightPlace);
    connect(&panels.answer, &ReviewDock::zoomRequested, &places, &PlaceActions::zoomTo);
    connect(&review_, &ReviewSession::failed, &panel_.messages(), &MessageBar::showError);
    connect(&windows_, &GlazingSession::failed, &panel_.messages(), &MessageBar::showError);
    connect(&review_, &ReviewSession::noted, &panel_.messages(), &MessageBar::showNote);
    connect(&preview, &EditPreview::shapeChanged, &review_, &ReviewSession::shape);
    connect(&review_, &ReviewSession::answered, this, [this, &preview] { showVerdicts(preview); });
}

// On the building that is being shaped.
void ReviewActions::showVerdicts(EditPreview& preview) const {
    if (!review_.isLive()) return preview.setVerdicts({});
    const ReviewStudy& study = review_.shown()->study;
    preview.setVerdicts(tr("%1: %2").arg(ruleName(study.rule.name), describeVerdicts(study)));
}

void ReviewActions::exportReview() {
    const auto shown = windows_.applies() ? windows_.showFinished() : review_.showFinished();
    if (!shown) return panel_.messages().showError(shown.error());
    Q_EMIT exportRequested();
}

}  // namespace noonmark
