#pragma once

// The main window and the state behind it. Workbench owns the open project, its city and the results, and
// runs the long jobs; it knows no widgets. MainWindow creates the view, the docks (window_docks) and the
// menus (window_menus) and connects them to the workbench. It is implemented in several files, one per
// subject: main_window_connections (menus, docks, view), _editing (edit tools), _project (scenarios, saving,
// recovery), _results (studies, comparisons, scores) and _time (time sliders). The remaining files are
// independent: application style, allocator settings, recent files, date conversion and the guess of the time
// zone (zone_guess, gazetteer_cities).

#include <QMainWindow>
#include <QSettings>

#include "app/window/frame/window_docks.h"
#include "app/window/frame/window_menus.h"
#include "app/window/frame/workbench.h"
#include "app/window/massing/edit_tools.h"
#include "app/window/project/project_saving.h"
#include "app/window/project/recovery_store.h"
#include "app/window/time/time_looking.h"
#include "app/window/view/exploration.h"
#include "app/window/view/mode_switch.h"
#include "app/window/widgets/recent_menu.h"

class QLabel;

namespace noonmark {

class OpenOptions;
class ProgressStrip;
class ViewPanel;

/// The main window: the view in the middle, docks around it. It connects them to the workbench and computes
/// nothing itself.
class MainWindow final : public QMainWindow {
    Q_OBJECT
public:
    /// `settings` stores layout and recent files; it must outlive the window.
    explicit MainWindow(QSettings& settings);
    ~MainWindow() override;

    [[nodiscard]] Workbench& workbench() { return workbench_; }
    [[nodiscard]] ViewPanel& panel() { return *panel_; }
    [[nodiscard]] EditTools& tools() { return tools_; }
    [[nodiscard]] ModeSwitch& mode() { return mode_; }
    [[nodiscard]] const Exploration& exploration() const { return exploration_; }
    [[nodiscard]] const TimeLooking& looking() const { return looking_; }

    [[nodiscard]] ProjectSaving& saving() { return saving_; }

    /// A result that took at most this many seconds is recomputed without asking.
    static constexpr double quickSeconds = 10;

    /// Asks first if there is unsaved work.
    void open(const QStringList& files);
    void openWith(const QStringList& files, const ReadSettings& reading);
    void savePicture(const QString& file);  ///< format by the file extension, PNG by default

    /// What to do with unsaved work before an action that would lose it. Tests answer here instead of in a
    /// dialog.
    enum class Unsaved { save, discard, cancel };
    void setUnsavedQuestion(std::function<Unsaved()> question) { askUnsaved_ = std::move(question); }
    /// Replaces the "Save as" dialog: takes the suggested name, returns the file, or an empty string if the
    /// user cancelled.
    using SaveAsQuestion = std::function<QString(const QString& suggested)>;
    void setSaveAsQuestion(SaveAsQuestion question) { askSaveAs_ = std::move(question); }

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void makeStatusBar();
    void makeModeBar();
    void fitScreen();
    void connectJobs();
    void connectWorkbench();
    void connectFileMenu();
    void connectOptions();
    void connectStudyMenu();
    void connectViewMenu();
    void connectRegion();
    void connectModes();
    void connectResults();
    void connectProject();
    void connectEditing();
    void connectTime();
    void offerTime();
    void showTime();
    void studyTime(const TimeLook& look);
    void askLive();
    void raiseDock(const QWidget* content);
    void connectTree();
    void connectScenarios();
    void connectSaving();
    [[nodiscard]] bool maySafely(const std::function<void()>& afterSave);
    void whenSafe(const std::function<void()>& then);
    void discardWork();
    void save();
    void saveAs();
    void showProject();
    void showTitle();
    void offerRecovery();
    void offerOlderWork();
    void offerLeftWork();
    void compare();
    void answerAnew();
    void answerAsSaved();
    void showComparison();
    void keepRegion();
    void keepPeriod();
    void keepResult();
    [[nodiscard]] ProjectSaving::View viewNow();
    [[nodiscard]] Unsaved askUnsaved();
    [[nodiscard]] QString projectName();
    void draw(bool on);
    void changeRegion(const Region& region);
    void takeDrawnRegion(const std::vector<Footprint>& pieces);
    void takeWholeCity();
    void readRegionFile();
    void showCity();
    void showOpenFailure(const Error& error);
    void showGuesses();
    void showAnswer();
    void showStudy();
    void showScore();
    void showPast();
    void announceLongRun(const RunEstimate& estimate);
    void showSaved();
    void showOutdated();
    void showExport();
    [[nodiscard]] QString exportWords() const;
    void showStopped(bool cancelled);
    void showDocument();
    void goToPlace(const QString& where);

    QSettings& settings_;
    Workbench workbench_;
    WindowMenus menus_;
    RecentMenu recent_;
    ViewPanel* panel_;
    std::shared_ptr<SharedHorizonCache> horizons_ = std::make_shared<SharedHorizonCache>();
    EditTools tools_;
    WindowDocks docks_;
    ProgressStrip* progress_;
    QLabel* hover_;
    OpenOptions* options_;
    ModeSwitch mode_;
    Exploration exploration_;
    TimeLooking looking_{horizons_};
    RecoveryStore place_;
    ProjectSaving saving_;
    std::function<Unsaved()> askUnsaved_;
    SaveAsQuestion askSaveAs_;
    /// Action to continue with after the save that the user asked for.
    std::function<void()> afterSave_;
    /// The open project was recovered from work that an earlier run left unsaved.
    bool leftTaken_ = false;
    bool answerShown_ = false;  ///< a study or comparison of this project has been shown
    QStringList opening_;
    ReadSettings reading_;    ///< of the files opened last
    StudySettings answered_;  ///< settings of the displayed study
};

}  // namespace noonmark
