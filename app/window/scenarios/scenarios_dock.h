#pragma once

// The project's scenarios: ScenarioBar chooses the displayed one and its baseline, ScenariosDock compares
// them side by side in a ScenarioTable.

#include <QWidget>

class QSortFilterProxyModel;
class QTableView;

namespace noonmark {

class ProjectSession;
class ScenarioTable;

/// All scenarios with their figures side by side, and a button that computes the missing ones.
class ScenariosDock final : public QWidget {
    Q_OBJECT
public:
    /// `session` must outlive it
    explicit ScenariosDock(ProjectSession& session, QWidget* parent = nullptr);

    [[nodiscard]] ScenarioTable& table() { return *table_; }

Q_SIGNALS:
    void measureAllRequested();

private:
    QTableView* makeView();

    ScenarioTable* table_;
    QSortFilterProxyModel* sorted_;
};

}  // namespace noonmark
