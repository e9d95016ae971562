#pragma once

#include <QAbstractTableModel>
#include <QObject>
#include <QPointF>
#include <QSortFilterProxyModel>
#include <QWidget>
#include <memory>
#include <vector>

#include "core/study/elements/element_map.h"

class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QTableView;

namespace noonmark {

/// The table of the points that were measured, one row each, in the order of the map.
class ElementModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    /// From `sun` on, the figures of points in the order of their table (pointFigures()).
    enum Column { id, building, floor, facing, sun };
    static constexpr int valueRole = Qt::UserRole;  ///< a number where the text is one, for sorting

    using QAbstractTableModel::QAbstractTableModel;

    void show(std::shared_ptr<const ElementMap> map);  ///< null: no rows
    [[nodiscard]] const std::shared_ptr<const ElementMap>& map() const { return map_; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::shared_ptr<const ElementMap> map_;
};

/// Over an ElementModel: only the rows that contain a text in their id or building, and that have less sun
/// than a limit.
class ElementFilter final : public QSortFilterProxyModel {
    Q_OBJECT
public:
    explicit ElementFilter(QObject* parent = nullptr);

    void setText(const QString& text);
    void setBelowHours(double hours);  ///< of sun a day; 0: no limit

protected:
    [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    QString text_;
    double belowHours_ = 0;
};

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
    void highlighted(std::vector<std::size_t> elements);  ///< the selected rows
    void goToRequested(std::size_t element);              ///< double click or Enter

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

class ViewPanel;

/// Connects the table of points with the view: selected rows are outlined there, a click on a point selects
/// its row.
class ElementLinks final : public QObject {
    Q_OBJECT
public:
    ElementLinks(ElementsDock& dock, ViewPanel& panel);  ///< both must outlive this object

private:
    void goTo(std::size_t element);
    void click(QPointF pixel);

    ElementsDock& dock_;
    ViewPanel& panel_;
};

class ElementForm;
class Workbench;

/// Clicks on the view choose faces or points for the form that asks for them. One form asks at a time.
class ElementPicking final : public QObject {
    Q_OBJECT
public:
    ElementPicking(Workbench& workbench, ViewPanel& panel);  ///< both must outlive this object

    void serve(ElementForm& form);  ///< it must outlive this object

private:
    void begin(const ElementForm& form, bool faces);
    void click(QPointF pixel);

    Workbench& workbench_;
    ViewPanel& panel_;
    std::vector<ElementForm*> forms_;
};

}  // namespace noonmark
