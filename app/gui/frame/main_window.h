#pragma once

// The main window. Workbench (app/gui/session) owns the open project, its city and the results, and runs the
// long jobs; it knows no widgets. MainWindow is the frame: it creates the view, the docks (window_layout),
// the menus (window_menus) and the objects that do the work, and connects them. What a menu entry does is in
// actions. window_connections.cpp connects the objects, window_project.cpp shows a project and saves the
// state of the window with it; WindowView is what a project saves of the view.

#include <QMainWindow>
#include <QSettings>

#include "app/gui/docks/contributions/contribution_links.h"
#include "app/gui/docks/elements/elements_dock.h"
#include "app/gui/docks/export/movie_actions.h"
#include "app/gui/docks/places/place_links.h"
#include "app/gui/docks/point/dome_display.h"
#include "app/gui/docks/point/point_inspector.h"
#include "app/gui/docks/project/saved_views.h"
#include "app/gui/docks/results/result_display.h"
#include "app/gui/docks/review/glazing/glazing_session.h"
#include "app/gui/docks/review/glazing/verdict_links.h"
#include "app/gui/docks/scenarios/latest_answers.h"
#include "app/gui/docks/study_form/what_form.h"
#include "app/gui/frame/actions/context_menu.h"
#include "app/gui/frame/actions/edit_actions.h"
#include "app/gui/frame/actions/opening_actions.h"
#include "app/gui/frame/actions/place_actions.h"
#include "app/gui/frame/actions/region_actions.h"
#include "app/gui/frame/actions/result_actions.h"
#include "app/gui/frame/actions/saving_actions.h"
#include "app/gui/frame/actions/scenario_actions.h"
#include "app/gui/frame/actions/search_actions.h"
#include "app/gui/frame/actions/study_actions.h"
#include "app/gui/frame/actions/tree_actions.h"
#include "app/gui/frame/actions/view_actions.h"
#include "app/gui/frame/help/help_actions.h"
#include "app/gui/frame/preferences/preferences_dialog.h"
#include "app/gui/frame/tour/tour.h"
#include "app/gui/frame/window_layout.h"
#include "app/gui/session/workbench.h"
#include "app/gui/tools/editing/edit_tools.h"
#include "app/gui/tools/photograph/photograph_actions.h"
#include "app/gui/view/compare/compare_actions.h"
#include "app/gui/view/exploration/exploration.h"
#include "app/gui/view/panel/time_display.h"
#include "app/gui/view/panel/view_presets.h"

class QLabel;

class QAction;

namespace noonmark {

class ProgressStrip;
struct WindowActions;
class ViewPanel;

/// The main window: the view in the middle, docks around it. It computes nothing itself.
class MainWindow final : public QMainWindow {
    Q_OBJECT
public:
    /// Of the places of panels in the settings: raised when panels come, go or move, so that layouts saved
    /// before are not restored over them.
    static constexpr int layoutVersion = 14;

    /// `settings` stores layout and recent files; it must outlive the window.
    /// `workbench`: the work of another window, which takeOver() then shows.
    explicit MainWindow(QSettings& settings,
                        std::shared_ptr<Workbench> workbench = std::make_shared<Workbench>());
    ~MainWindow() override;

    [[nodiscard]] Workbench& workbench() { return workbench_; }
    [[nodiscard]] std::shared_ptr<Workbench> sharedWorkbench() const { return shared_; }
    /// Shows the work of a window that is about to go: its project, results, view and layout.
    void takeOver(MainWindow& before);
    [[nodiscard]] ViewPanel& panel() { return *panel_; }
    [[nodiscard]] EditTools& tools() { return tools_; }
    [[nodiscard]] ModeSwitch& mode() { return mode_; }
    [[nodiscard]] const Exploration& exploration() const { return exploration_; }
    [[nodiscard]] const MomentPreview& moments() const { return time_.moments(); }
    [[nodiscard]] const SunShadow& shadow() const { return time_.shadow(); }

    [[nodiscard]] SavingActions& saving() { return saving_; }
    [[nodiscard]] OpeningActions& opening() { return opening_; }
    [[nodiscard]] ReviewSession& review() { return review_; }
    [[nodiscard]] GlazingSession& glazingReview() { return glazingReview_; }
    [[nodiscard]] LatestAnswers& answers() { return answers_; }
    [[nodiscard]] ContributionLinks& contributions() { return contributions_; }
    [[nodiscard]] PlaceActions& places() { return places_; }
    [[nodiscard]] PhotographActions& photograph() { return photograph_; }
    [[nodiscard]] TreeActions& trees() { return trees_; }
    [[nodiscard]] ResultActions& results() { return results_; }
    [[nodiscard]] CopyActions& copying() { return copying_; }
    [[nodiscard]] MovieActions& movies() { return movies_; }
    [[nodiscard]] HelpActions& help() { return help_; }
    [[nodiscard]] TourActions& tours() { return tours_; }
    [[nodiscard]] PreferencesActions& preferences() { return preferences_; }
    [[nodiscard]] ContextMenu& context() { return context_; }
    [[nodiscard]] ViewActions& camera() { return camera_; }
    [[nodiscard]] ViewPresets& presets() { return presets_; }
    [[nodiscard]] CompareActions& comparing() { return comparing_; }
    [[nodiscard]] DomeDisplay& dome() { return dome_; }
    [[nodiscard]] SavedViews& savedViews() { return savedViews_; }
    [[nodiscard]] PointInspector& points() { return points_; }

    [[nodiscard]] TimeDisplay& time() { return time_; }

    void open(const QStringList& files) { opening_.open(files); }  ///< asks first if there is unsaved work

Q_SIGNALS:
    void textsChanged();  ///< another language or other units: WindowRenewal makes another window

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void makeStatusBar();
    void makeToolBars(const WindowActions& actions);
    void fillMenus(const QList<QAction*>& docks);
    void fitScreen();
    void connectJobs();
    void connectScenarioJobs();
    void connectWorkbench();
    void connectDocks();
    void connectStudyForm();
    void followRegion();
    void connectElementForms();
    void connectModes();
    void connectPreferences();
    void activateExploration();
    void explore();
    void showModes();
    void showReview();
    void showVerdicts();
    void useMapsOfPaper(bool used);
    void showPaper();
    void answerCard(StartQuestion question);
    void storePicture();
    void chooseKind(StudyKind kind);
    void raiseDock(const QWidget* content);
    void showDock(const QWidget* content);
    void showAnswerPanel();
    void hideAnswerPanels();
    void savePoint();
    void showCity();
    ProjectSaving::Compose projectToSave();
    void showProject();
    void showSavedKind();
    void showSavedPlaces();
    void showDocument();
    void showTitle();

    QSettings& settings_;
    std::shared_ptr<Workbench> shared_;
    Workbench& workbench_;
    ReviewSession review_;
    GlazingSession glazingReview_;
    ViewPanel* panel_;
    std::shared_ptr<SharedHorizonCache> horizons_ = std::make_shared<SharedHorizonCache>();
    EditTools tools_;
    PointInspector points_;
    WindowDocks docks_;
    ProgressStrip* progress_;
    QLabel* hover_;
    ModeSwitch mode_;
    Exploration exploration_;
    WindowView view_;
    RecoveryStore store_;
    SavingActions saving_;
    OpeningActions opening_;
    RecoveryOffers recovery_;
    ElementLinks links_;
    VerdictLinks verdicts_;
    ElementPicking picking_;
    ContributionLinks contributions_;
    ResultDisplay display_;
    PlaceLinks placeLinks_;
    ResultActions results_;
    CopyActions copying_;
    MovieActions movies_;
    StudyActions study_;
    RegionActions region_;
    PlaceActions places_;
    PhotographActions photograph_;
    TreeActions trees_;
    ReviewActions reviews_;
    LatestAnswers answers_;
    ScenarioActions scenarios_;
    EditActions edits_;
    TowerDisplay towers_;
    ViewActions camera_;
    SearchActions search_;
    HelpActions help_;
    TimeDisplay time_;
    DomeDisplay dome_;
    ViewPresets presets_;
    CompareActions comparing_;
    PreferencesActions preferences_;
    TourActions tours_;
    SavedViews savedViews_;
    ContextMenu context_;
    bool fillsTable_ = false;   ///< places of all scenarios are being measured, for the table of scenarios
    QAction* paper_ = nullptr;  ///< as in the paper, or not
};

}  // namespace noonmark
