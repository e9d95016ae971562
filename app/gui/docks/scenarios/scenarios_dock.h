#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QScrollArea;
class QSettings;
class QTimer;
// The project's scenarios: ScenarioBar chooses the displayed one and its baseline, ScenariosDock compares
// them side by side in a ScenarioTable, whose impacts, scores and verdicts LatestAnswers knows and computes.
class QAbstractItemModel;
class QSortFilterProxyModel;
class QTableView;

namespace noonmark {

class BarCharts;
class ProgressStrip;
class ScenarioTable;

/// The months of all scenarios side by side: a figure that is chosen from a list, and below it its changes
/// against the baseline.
class ScenarioCharts final : public QWidget {
    Q_OBJECT
public:
    /// Both must outlive it. `settings` stores which figure is chosen.
    ScenarioCharts(const ScenarioTable& table, QSettings& settings, QWidget* parent = nullptr);

Q_SIGNALS:
    void exportRequested();
    void monthsRequested();  ///< no scenario has any

protected:
    void showEvent(QShowEvent* event) override;

private:
    void fillList(const QString& chosen);
    void placeFields();
    void showCharts(bool shown);
    void follow();
    void draw();

    const ScenarioTable& table_;
    QComboBox* figure_;
    QPushButton* save_;
    QLabel* note_;
    BarCharts* charts_;
    QScrollArea* scroll_;
    QTimer* later_;  // draws once after several changes
};

class ProjectSession;

/// All scenarios with their figures side by side, buttons that compute the missing ones, and charts of the
/// months (ScenarioCharts).
class ScenariosDock final : public QWidget {
    Q_OBJECT
public:
    /// Both must outlive it. `settings` stores which columns are hidden, and what the switches state.
    ScenariosDock(ProjectSession& session, QSettings& settings, QWidget* parent = nullptr);

    [[nodiscard]] ScenarioTable& table() { return *table_; }
    [[nodiscard]] ProgressStrip& progress() { return *progress_; }  ///< of what fills the table
    /// As it is sorted.
    [[nodiscard]] const QAbstractItemModel& shownTable() const;

Q_SIGNALS:
    void measureAllRequested();
    void measureMonthsRequested();  ///< of all scenarios, for the chart of months
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
    ProgressStrip* progress_;
    QSortFilterProxyModel* sorted_;
};

}  // namespace noonmark
