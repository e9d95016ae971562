#pragma once

#include <QAbstractTableModel>

#include "app/gui/docks/contributions/contribution_sheet.h"

namespace noonmark {

/// The table of the buildings of a sheet, one row each, in the sheet's order: the name, then its columns.
class ContributionModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    static constexpr int valueRole = Qt::UserRole;  ///< a number where the text is one, for sorting
    /// Of a share: how long its bar is, 0 to 1, 1 for the largest share of the sheet.
    static constexpr int barRole = Qt::UserRole + 1;

    using QAbstractTableModel::QAbstractTableModel;

    void show(ContributionSheet sheet);
    [[nodiscard]] const ContributionSheet& sheet() const { return sheet_; }
    [[nodiscard]] const std::shared_ptr<const Building>& buildingOf(int row) const;  ///< null: the terrain
    [[nodiscard]] int rowOf(const Building* building) const;                         ///< -1: not in the table

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    ContributionSheet sheet_;
    double largestShare_ = 0;
};

}  // namespace noonmark
