#pragma once

#include <QStyledItemDelegate>
#include <QWidget>
#include <array>
#include <optional>

#include "app/gui/session/project/project_changes.h"
#include "scenarios/weights/edit_weights.h"

// The project's weight tables: WeightsDock edits one through WeightsModel, as a list drawn by WeightBar and
// as a WeightCalendar, and asks for a score.
class QComboBox;
class QLabel;
class QMenu;
class QPushButton;
class QTableView;

namespace noonmark {

class WeightsModel;

/// The chosen table as a calendar: months from above, hours of the day from the left, in colours from wanted
/// sun to wanted shade; hatched where the weight changes within a cell. Below, the weights to paint with,
/// which are its legend. A drag gives a rectangle that weight, a drag with the right button erases it; the
/// wheel, + and - choose the weight; arrows move the cell, with Shift they extend it, Enter paints it, Delete
/// erases it. Each is one undo step.
class WeightCalendar final : public QWidget {
    Q_OBJECT
public:
    explicit WeightCalendar(WeightsModel& model, QWidget* parent = nullptr);  ///< `model` must outlive it

    [[nodiscard]] double brush() const { return brush_; }  ///< the weight to paint with, -1 to 1
    void setBrush(double weight);
    /// The rectangle of a cell, and that of a weight's swatch, in the widget. Months 0 to 11, hours 0 to 23.
    [[nodiscard]] QRectF cellAt(int month, int hour) const;
    [[nodiscard]] QRectF swatchOf(double weight) const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Cell {
        int month = 5, hour = 12;
    };
    void follow();
    [[nodiscard]] std::optional<Cell> findCell(QPointF at) const;
    [[nodiscard]] MonthsAndHours selected() const;
    void paintSelected(std::optional<double> weight);
    void moveCell(int key, bool extends);
    void drawCells(QPainter& painter) const;
    void drawLabels(QPainter& painter) const;
    void drawSwatches(QPainter& painter) const;
    void drawSelection(QPainter& painter) const;
    [[nodiscard]] QString tipAt(Cell cell) const;
    [[nodiscard]] int labelWidth() const;
    [[nodiscard]] int lineHeight() const;
    [[nodiscard]] double swatchTop() const;

    WeightsModel& model_;
    std::array<std::array<WeightCell, 24>, 12> grid_{};
    Cell anchor_, cell_;
    Qt::MouseButton dragged_ = Qt::NoButton;
    double brush_ = 1;
};

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
    void report(const QString& text);

    ProjectSession& session_;
    WeightsModel* model_;
    QComboBox* tables_;
    QTableView* view_;
    QLabel* refusal_;
    QPushButton* score_;
    QLabel* note_;
};

}  // namespace noonmark
