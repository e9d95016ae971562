#pragma once

#include <QObject>
#include <memory>

class QAction;

namespace noonmark {

class LatestAnswers;
class ProjectDock;
class ScenariosDock;
class Workbench;

/// New scenarios, the comparison with the existing city, and the runs over all scenarios.
class ScenarioActions final : public QObject {
    Q_OBJECT
public:
    /// All must outlive this object.
    ScenarioActions(Workbench& workbench, LatestAnswers& answers, ProjectDock& tree,
                    ScenariosDock& scenarios);

    [[nodiscard]] QList<QAction*> actions() const;
    [[nodiscard]] QAction* compareAction() const { return compare_; }
    /// Writes the table of scenarios as CSV; asks for no file. Empty: nothing.
    void saveTable(const QString& file);
    /// Writes the buildings that the displayed scenario proposes, or all of the existing city, in the format
    /// of the file's ending (app/report/bodies/body_files.h). Empty: nothing.
    void saveBuildings(const QString& file);
    /// Likewise the months of the scenarios.
    void saveMonths(const QString& file);
    /// What shows both scenarios side by side until their comparison is computed; it must outlive this
    /// object.
    void setSideBySide(QAction* beside) { beside_ = beside; }
    /// Measures the places of all scenarios where those are asked for instead of a region; false: they are
    /// not.
    using MeasurePlaces = std::function<bool()>;
    void setPlacesMeasured(MeasurePlaces measure) { measurePlaces_ = std::move(measure); }

Q_SIGNALS:
    void tableRequested();   ///< what fills the table of scenarios was asked for in a menu
    void comparisonShown();  ///< the one that was wanted is there

private:
    void connectMeasuring();
    void measure(void (Workbench::*all)());
    void compare(bool on);
    void save(const QString& file, const std::string& csv);
    void compareScores();
    void awaitComparison();
    void stopWaiting();
    void endWaiting();
    Workbench& workbench_;
    ScenariosDock& dock_;
    QAction* newScenario_;
    QAction* newFromThis_;
    QAction* compare_;  ///< checkable
    QAction* beside_ = nullptr;
    MeasurePlaces measurePlaces_;
    std::unique_ptr<QObject> awaited_;  ///< while a comparison is computed
    bool measuring_ = false;            ///< all scenarios, until their figures are there
    QAction* measureAll_;
    QAction* scoreAll_;
    QAction* reviewAll_;
    QAction* exportBuildings_;
};

}  // namespace noonmark
