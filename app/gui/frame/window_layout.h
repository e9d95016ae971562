#pragma once

#include <QList>
#include <map>
#include <string>

class QWidget;
class QAction;
class QDockWidget;
class QMainWindow;
class QSettings;

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
class ReviewForm;
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
    ReviewForm* reviewForm;
    ReviewDock* review;
    PointDock* point;
    ElementsDock* elements;
    ContributionsDock* contributions;
    PlacesDock* places;
    QWidget* building;  ///< the selected building
    QWidget* tower;     ///< lots, and the tower being designed
    QWidget* trees;
};

/// Switches that hide all docks at the left, the right and below, for more of the view, and show them again.
QList<QAction*> makeSideSwitches(QMainWindow& window);

enum class DockPlace { inFront, behindOthers };
/// Shows a dock among its tabs. A side that was empty begins narrow, so that the view stays large.
void openDock(QMainWindow& window, QDockWidget& dock, DockPlace place = DockPlace::inFront);

/// Adds the docks at their default places: the question at the left in front, the others hidden until they
/// are wanted. Returns the actions that show and hide them.
QList<QAction*> placeDocks(QMainWindow& window, const WindowDocks& docks);

class ModeSwitch;
class ReviewSession;
class ViewPanel;
struct ViewState;
class Workbench;

/// The window's state that is saved in the project: camera, mode, measure, scenario, study, review.
class WindowView {
public:
    /// All must outlive this object.
    WindowView(Workbench& workbench, ViewPanel& panel, ModeSwitch& mode, ReviewSession& review,
               QSettings& settings)
        : workbench_(workbench), panel_(panel), mode_(mode), review_(review), settings_(settings) {}

    [[nodiscard]] std::map<std::string, std::string> toSave() const;
    /// Shows the project that has been opened as it was saved; a new one from the south, its region in the
    /// middle, with shadow or sun as it was last chosen. Scenario and study are in the workbench already.
    void restore();
    /// Shows another window's view of the same project.
    void restore(const ViewState& view);
    /// For new projects: shadow or sun, as it is shown now.
    void rememberShown();

private:
    Workbench& workbench_;
    ViewPanel& panel_;
    ModeSwitch& mode_;
    ReviewSession& review_;
    QSettings& settings_;
};

}  // namespace noonmark
