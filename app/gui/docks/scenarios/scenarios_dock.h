#pragma once

// The project's scenarios: ScenarioBar chooses the displayed one and its baseline, ScenariosDock compares
// them side by side in a ScenarioTable, whose impacts, scores and verdicts LatestAnswers knows and computes.

#include <QWidget>

class QAbstractItemModel;
class QSettings;
class QSortFilterProxyModel;
class QTableView;

namespace noonmark {

class ProjectSession;
class ScenarioTable;

/// All scenarios with their figures side by side, buttons that compute the missing ones, and charts of the
/// months (ScenarioCharts).
class ScenariosDock final : public QWidget {
    Q_OBJECT
public:
    /// Both must outlive it. `settings` stores which columns are hidden, and what the switches state.
    ScenariosDock(ProjectSession& session, QSettings& settings, QWidget* parent = nullptr);

    [[nodiscard]] ScenarioTable& table() { return *table_; }
    /// As it is sorted.
    [[nodiscard]] const QAbstractItemModel& shownTable() const;

Q_SIGNALS:
    void measureAllRequested();
    void scoreAllRequested();
    void reviewAllRequested();
    void copyRequested();
    void exportRequested();
    void monthsExportRequested();

private:
    QTableView* makeView(QSettings& settings);
    QWidget* makeButtons();
    QWidget* makeSwitches(QSettings& settings);

    ScenarioTable* table_;
    QSortFilterProxyModel* sorted_;
};

}  // namespace noonmark
