#pragma once

// The project's weight tables: WeightsDock edits one through WeightsModel, as a list drawn by WeightBar and
// as a WeightCalendar, and asks for a score.

#include <QWidget>

#include "app/gui/session/project/project_changes.h"

class QComboBox;
class QLabel;
class QMenu;
class QPushButton;
class QTableView;

namespace noonmark {

class ProjectSession;
class WeightsModel;

/// The weight tables of the project; the chosen one is edited and used to compute a score.
class WeightsDock final : public QWidget {
    Q_OBJECT
public:
    explicit WeightsDock(ProjectSession& session, QWidget* parent = nullptr);  ///< `session` must outlive it

    void choose(const std::string& table);  ///< shows and edits this one
    [[nodiscard]] WeightsModel& model() { return *model_; }

    void score();  ///< asks for the score with the table on display

Q_SIGNALS:
    void scoreRequested(const std::string& table);

private:
    void makeView();
    void fitColumns();
    QWidget* makeButtons();
    void follow();
    void addTable(TimeWeights table);
    QWidget* makeTemplates();
    void fillTemplates(QMenu& menu);
    void addInterval();
    void removeInterval();
    void tell(const QString& text);

    ProjectSession& session_;
    WeightsModel* model_;
    QComboBox* tables_;
    QTableView* view_;
    QLabel* refusal_;
    QPushButton* score_;
    QLabel* note_;
};

}  // namespace noonmark
