#pragma once

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

/// The window: view in the middle, docks around it. Connects them to the workbench; does no work itself.
class MainWindow final : public QMainWindow {
    Q_OBJECT
public:
    /// `settings` keeps layout and recent files; it outlives the window.
    explicit MainWindow(QSettings& settings);
    ~MainWindow() override;

    [[nodiscard]] Workbench& workbench() { return workbench_; }
    [[nodiscard]] ViewPanel& panel() { return *panel_; }
    [[nodiscard]] EditTools& tools() { return tools_; }
    [[nodiscard]] ModeSwitch& mode() { return mode_; }
    [[nodiscard]] const Exploration& exploration() const { return exploration_; }
    [[nodiscard]] const TimeLooking& looking() const { return looking_; }

    [[nodiscard]] ProjectSaving& saving() { return saving_; }

    /// An answer that took no longer is worked out again by itself, seconds.
    static constexpr double quickSeconds = 10;

    /// Unsaved work is asked about first.
    void open(const QStringList& files);
    void openWith(const QStringList& files, const ReadSettings& reading);
    void savePicture(const QString& file);  ///< PNG, or what the name's ending says

    /// What to do with unsaved work before something would lose it. A test answers without a dialog.
    enum class Unsaved { save, discard, cancel };
    void setUnsavedQuestion(std::function<Unsaved()> question) { askUnsaved_ = std::move(question); }
    /// In place of the dialog that asks where to save a project: the suggested name in, the file out; empty:
    /// the user cancelled.
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
    std::function<void()> afterSave_;  ///< what waits for the save that the user asked for
    bool leftTaken_ = false;           ///< the work that an earlier run left is what is open
    bool answerShown_ = false;         ///< a study or comparison of this project was shown
    QStringList opening_;
    ReadSettings reading_;    ///< of the files that were opened last
    StudySettings answered_;  ///< the settings of the study that is shown
};

}  // namespace noonmark
