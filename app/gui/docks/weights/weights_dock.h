#pragma once

#include <QStyledItemDelegate>
#include <QWidget>

#include "app/gui/session/project/project_changes.h"

// The project's weight tables: WeightsDock edits one through WeightsModel, as a list drawn by WeightBar and
// as a WeightCalendar, and asks for a score.
class QComboBox;
class QLabel;
class QMenu;
class QPushButton;
class QTableView;

namespace noonmark {

/// Draws a weight as a number with a bar: from the middle to the right if shade is wanted, to the left if
/// shadow is unwanted. Reads the weight, -1 to 1, from Qt::UserRole.
class WeightBar final : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

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
