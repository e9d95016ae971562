#pragma once

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>
#include <memory>

#include "core/study/elements/element_map.h"

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

}  // namespace noonmark
