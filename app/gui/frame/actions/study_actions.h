#pragma once

#include <QObject>

#include "app/gui/session/study/run_estimate.h"
#include "core/sun/period.h"

class QAction;
class QMenu;

namespace noonmark {

class ModeSwitch;
class ProjectDock;
class ResultDisplay;
class StudyDock;
class ViewPanel;
class WeightsDock;
class Workbench;

/// Runs and cancels studies, changes their period, and chooses the measure shown. A result that was quick is
/// computed again without asking after an edit, or when its project is opened.
class StudyActions final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    StudyActions(Workbench& workbench, const ModeSwitch& mode, ResultDisplay& display, ViewPanel& panel);

    void listenTo(StudyDock& study, ProjectDock& tree, WeightsDock& weights);

    [[nodiscard]] QList<QAction*> runActions() const { return {run_, cancel_}; }
    /// Puts the questions that need no form of their own (Question::help) into a menu whenever it is shown.
    void listQuestions(QMenu& menu) const;
    [[nodiscard]] QList<QAction*> measureActions() const { return {gross_, continuous_}; }

    /// A result that took at most this many seconds is recomputed without asking.
    static constexpr double quickSeconds = 10;

    void runAgainIfQuick();  ///< the displayed kind of result, after an edit or a change of scenario
    /// The result displayed when the opened project was saved, or says how to; while exploring, where no
    /// result is shown, offers it.
    void repeatSaved();

private:
    void run();
    void goToRegion() const;
    void setPeriod(const Period& period);
    void savePeriod();
    void compare();
    [[nodiscard]] bool showMeasured();
    void offerMeasured();
    void announceLongRun(const RunEstimate& estimate);
    void showStopped(bool cancelled);

    Workbench& workbench_;
    const ModeSwitch& mode_;
    ResultDisplay& display_;
    ViewPanel& panel_;
    QAction* run_;
    QAction* cancel_;
    QAction* gross_;
    QAction* continuous_;
};

class EditPreview;
class PlaceActions;
class ReviewDock;
class ReviewForm;
class ReviewSession;
class GlazingSession;

/// Shows the panels of a review, and lets the verdicts follow the building that is being shaped.
class ReviewActions final : public QObject {
    Q_OBJECT
public:
    struct Panels {
        ReviewForm& question;
        ReviewDock& answer;
    };

    /// All must outlive this object.
    ReviewActions(ReviewSession& review, GlazingSession& windows, const Panels& panels, EditPreview& preview,
                  PlaceActions& places, ViewPanel& panel);

    [[nodiscard]] QList<QAction*> actions() const { return {show_, export_}; }

Q_SIGNALS:
    void dockRequested();
    void exportRequested();  ///< of the review, which is displayed

private:
    void showVerdicts(EditPreview& preview) const;
    void exportReview();

    ReviewSession& review_;
    GlazingSession& windows_;
    ViewPanel& panel_;
    QAction* show_;
    QAction* export_;
};

}  // namespace noonmark
