#pragma once

class QMainWindow;
class QMenu;
class QWidget;

namespace noonmark {

class ProjectDock;
class ResultsDock;
class ScenariosDock;
class StudyDock;
class WarningsDock;
class WeightsDock;

/// What stands around the view. Belongs to the window.
struct WindowDocks {
    ProjectDock* project;
    StudyDock* study;
    ResultsDock* results;
    ScenariosDock* scenarios;
    WeightsDock* weights;
    WarningsDock* warnings;
    QWidget* building;  ///< the selected one
    QWidget* tower;     ///< lots, and the tower that is designed
};

/// Places the docks where they stand until the user moves them; `menu` shows and hides them.
void placeDocks(QMainWindow& window, const WindowDocks& docks, QMenu& menu);

}  // namespace noonmark
