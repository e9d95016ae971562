#pragma once

#include <QObject>

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
    [[nodiscard]] QAction* compare() const { return compare_; }

private:
    QAction* newScenario_;
    QAction* newFromThis_;
    QAction* compare_;  ///< checkable
    QAction* measureAll_;
    QAction* scoreAll_;
    QAction* reviewAll_;
};

}  // namespace noonmark
