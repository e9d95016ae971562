#pragma once

#include <QList>

class QWidget;
class QAction;
class QMainWindow;

namespace noonmark {

/// Gives each widget inside that takes the keyboard a name for screen readers, where it has none by its text
/// or label: the first line of its tool tip, or the name or title of what it is in.
void nameForScreenReaders(QWidget& window);

class ContributionsDock;
class ElementsDock;
class PlacesDock;
class PointDock;
class ProjectDock;
class ResultsDock;
class ReviewDock;
class ScenariosDock;
class StudyDock;
class WarningsDock;
class WeightsDock;

/// The contents of the docks around the view. The window owns them.
struct WindowDocks {
    ProjectDock* project;
    StudyDock* study;
    ResultsDock* results;
    ScenariosDock* scenarios;
    WeightsDock* weights;
    WarningsDock* warnings;
    ReviewDock* review;
    PointDock* point;
    ElementsDock* elements;
    ContributionsDock* contributions;
    PlacesDock* places;
    QWidget* building;  ///< the selected building
    QWidget* tower;     ///< lots, and the tower being designed
};

/// Switches that hide all docks at the left, the right and below, for more of the view, and show them again.
QList<QAction*> makeSideSwitches(QMainWindow& window);

/// Adds the docks at their default places. Returns the actions that show and hide them.
QList<QAction*> placeDocks(QMainWindow& window, const WindowDocks& docks);

}  // namespace noonmark
