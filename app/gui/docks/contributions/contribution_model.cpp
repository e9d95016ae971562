#include "app/gui/docks/contributions/contribution_model.h"

#include <algorithm>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/number_words.h"
#include "app/report/maps/palette.h"

namespace noonmark {

namespace {

QString textOf(double value, const ContributionColumn& column) {
    if (column.unit == FigureUnit::squareMetreHours)
        return localiseNumbers(QString::fromStdString(formatAreaHours(value, unitsInUse())));
    return groupDigits(column.unit == FigureUnit::share ? 100 * value : value, column.decimals);
}

}  // namespace

void ContributionModel::show(ContributionSheet sheet) {
    beginResetModel();
    sheet_ = std::move(sheet);
    largestShare_ = 0;
    for (const ContributionRow& row : sheet_.rows) largestShare_ = std::max(largestShare_, row.share);
    endResetModel();
}

const std::shared_ptr<const Building>& ContributionModel::buildingOf(int row) const {
    return sheet_.rows[std::size_t(row)].building;
}

int ContributionModel::rowOf(const Building* building) const {
    const auto found = std::ranges::find(sheet_.rows, building,
                                         [](const ContributionRow& row) { return row.building.get(); });
    return building == nullptr || found == sheet_.rows.end() ? -1 : int(found - sheet_.rows.begin());
}

int ContributionModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(sheet_.rows.size());
}

int ContributionModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() || sheet_.columns.empty() ? 0 : 1 + int(sheet_.columns.size());
}

QVariant ContributionModel::data(const QModelIndex& index, int role) const {
    const ContributionRow& row = sheet_.rows[std::size_t(index.row())];
    const bool isName = index.column() == 0;
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (isName ? Qt::AlignLeft : Qt::AlignRight));
    if (role == Qt::DecorationRole && isName && row.building)
        return toColour(contributionClasses[classOf(row.share)].colour);
    if (role == Qt::ToolTipRole && isName && row.building) {
        const QString id = QString::fromStdString(row.building->sourceId);
        return id == row.name ? row.name : QStringLiteral("%1 (%2)").arg(row.name, id);
    }
    if (role == barRole) return largestShare_ > 0 ? row.share / largestShare_ : 0;
    if (role != Qt::DisplayRole && role != valueRole) return {};
    if (isName) return row.name;
    const std::size_t column = std::size_t(index.column()) - 1;
    return role == valueRole ? QVariant(row.values[column])
                             : textOf(row.values[column], sheet_.columns[column]);
}

QVariant ContributionModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (section == 0) return role == Qt::DisplayRole ? QVariant(tr("Building")) : QVariant();
    const ContributionColumn& column = sheet_.columns[std::size_t(section) - 1];
    if (role == Qt::DisplayRole) return column.heading;
    return role == Qt::ToolTipRole ? QVariant(column.meaning) : QVariant();
}

}  // namespace noonmark
