#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QScrollArea;
class QSettings;
class QTimer;

namespace noonmark {

class BarCharts;
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

}  // namespace noonmark
