#pragma once

#include <QWidget>
#include <vector>

#include "app/gui/docks/elements/element_model.h"

class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QTableView;

namespace noonmark {

/// The table of the points of facades, windows or a plane: it sorts, filters, and points at the view.
class ElementsDock final : public QWidget {
    Q_OBJECT
public:
    explicit ElementsDock(QWidget* parent = nullptr);

    void show(std::shared_ptr<const ElementMap> map);  ///< null: none; the filter stays
    void select(std::size_t element);                  ///< with a signal; a filter that hides it is emptied
    [[nodiscard]] const ElementModel& model() const { return *model_; }
    [[nodiscard]] std::vector<std::size_t> selected() const;

Q_SIGNALS:
    void pointedAt(std::vector<std::size_t> elements);  ///< the selected rows
    void wanted(std::size_t element);                   ///< double click or Enter

private:
    void placeFields();
    void connectFields();
    void count();
    [[nodiscard]] std::size_t elementOf(const QModelIndex& index) const;

    ElementModel* model_;
    ElementFilter* filter_;
    QLineEdit* text_;
    QDoubleSpinBox* below_;
    QLabel* count_;
    QTableView* table_;
};

}  // namespace noonmark
