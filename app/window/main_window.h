#pragma once

#include <QMainWindow>
#include <QSettings>

#include "app/window/recent_files.h"
#include "app/window/window_menus.h"
#include "app/window/workbench.h"

class QLabel;

namespace noonmark {

class ProgressStrip;
class ResultsDock;
class StudyDock;
class ViewPanel;
class WarningsDock;

/// The window: view in the middle, docks around it. Connects them to the workbench; does no work itself.
class MainWindow final : public QMainWindow {
    Q_OBJECT
public:
    /// `settings` keeps layout and recent files; it outlives the window.
    explicit MainWindow(QSettings& settings);
    ~MainWindow() override;

    [[nodiscard]] Workbench& workbench() { return workbench_; }
    [[nodiscard]] ViewPanel& panel() { return *panel_; }

    void open(const QStringList& files);
    void savePicture(const QString& file);  ///< PNG, or what the name's ending says

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void makeDocks();
    void addDock(const QString& title, const char* name, QWidget* content, Qt::DockWidgetArea area);
    void makeStatusBar();
    void connectWorkbench();
    void connectMenus();
    void connectViewMenu();
    void connectStudyDock();
    void showCity();
    void showStudy();
    void showDocument();
    void changeRegion(const Region& region);
    void fillRecent();
    void askToOpen();
    void askToSavePicture();
    void askToExport();
    void restoreLayout();

    QSettings& settings_;
    RecentFiles recent_;
    Workbench workbench_;
    WindowMenus menus_;
    ViewPanel* panel_;
    StudyDock* study_;
    ResultsDock* results_;
    WarningsDock* warnings_;
    ProgressStrip* progress_;
    QLabel* hover_;
    QStringList opening_;
    StudySettings answered_;  ///< the settings of the study that is shown
};

}  // namespace noonmark
