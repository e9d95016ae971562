#include "app/window/elements/element_model.h"

#include <array>
#include <cmath>

#include "app/window/widgets/number_words.h"

namespace noonmark {

namespace {

QString buildingText(const MeasuredElement& element) {
    return QString::fromStdString(element.buildingName.empty() ? element.building : element.buildingName);
}

// Numbers as numbers; nothing where there is none.
QVariant valueOf(const MeasuredElement& element, double possibleMin, int column) {
    switch (column) {
        case ElementModel::id:
            return QString::fromStdString(element.id);
        case ElementModel::building:
            return buildingText(element);
        case ElementModel::floor:
            return element.floor ? QVariant(*element.floor) : QVariant();
        case ElementModel::facing:
            return std::isnan(element.azimuthDeg) ? QVariant() : QVariant(element.azimuthDeg);
        case ElementModel::sun:
            return element.sunlitMin / 60;
        case ElementModel::share:
            return 100 * element.sunlitMin / possibleMin;
        case ElementModel::longestSun:
            return element.longestSunMin / 60;
        case ElementModel::gross:
            return element.grossMin;
        default:
            return element.continuousMin;
    }
}

int decimalsOf(int column) {
    if (column == ElementModel::sun || column == ElementModel::longestSun) return 2;
    return column == ElementModel::facing || column == ElementModel::floor ? 0 : 1;
}

QVariant textOf(const QVariant& value, int column) {
    if (!value.isValid() || column == ElementModel::id || column == ElementModel::building) return value;
    return groupDigits(value.toDouble(), decimalsOf(column));
}

}  // namespace

void ElementModel::show(std::shared_ptr<const ElementMap> map) {
    beginResetModel();
    map_ = std::move(map);
    endResetModel();
}

int ElementModel::rowCount(const QModelIndex& parent) const {
    return map_ && !parent.isValid() ? int(map_->elements.size()) : 0;
}

int ElementModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int(columns); }

QVariant ElementModel::data(const QModelIndex& index, int role) const {
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (index.column() > building ? Qt::AlignRight : Qt::AlignLeft));
    if (role != Qt::DisplayRole && role != valueRole) return {};
    const QVariant value =
        valueOf(map_->elements[std::size_t(index.row())], map_->possibleMin, index.column());
    return role == valueRole ? value : textOf(value, index.column());
}

QVariant ElementModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    const std::array<QString, columns> names{tr("Point"),          tr("Building"),     tr("Floor"),
                                             tr("Facing, °"),      tr("Sun, h a day"), tr("Sun, % of time"),
                                             tr("Longest sun, h"), tr("Gross, min"),   tr("Continuous, min")};
    return names[std::size_t(section)];
}

ElementFilter::ElementFilter(QObject* parent) : QSortFilterProxyModel(parent) {
    setSortRole(ElementModel::valueRole);
    setSortCaseSensitivity(Qt::CaseInsensitive);
}

void ElementFilter::setText(const QString& text) {
    text_ = text;
    invalidateFilter();
}

void ElementFilter::setBelowHours(double hours) {
    belowHours_ = hours;
    invalidateFilter();
}

bool ElementFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const auto at = [&](int column) {
        return sourceModel()->index(row, column, parent).data(ElementModel::valueRole);
    };
    if (belowHours_ > 0 && at(ElementModel::sun).toDouble() >= belowHours_) return false;
    return text_.isEmpty() || at(ElementModel::id).toString().contains(text_, Qt::CaseInsensitive) ||
           at(ElementModel::building).toString().contains(text_, Qt::CaseInsensitive);
}

}  // namespace noonmark
