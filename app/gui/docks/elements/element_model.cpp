#include "app/gui/docks/elements/element_model.h"

#include <array>
#include <cmath>

#include "app/gui/base/widgets/number_words.h"
#include "app/gui/session/answers/result_rows.h"
#include "core/study/elements/element_tables.h"

namespace noonmark {

namespace {

const std::string& textIn(const MeasuredElement& element, int column) {
    if (column == ElementModel::id) return element.id;
    return element.buildingName.empty() ? element.building : element.buildingName;
}

constexpr double minutesOfHour = 60;

const Figure& figureOf(int column) { return pointFigures().rows()[std::size_t(column - ElementModel::sun)]; }

bool isInHours(const Figure& figure) {
    return figure.unit == FigureUnit::hours || figure.unit == FigureUnit::hoursADay;
}

// NaN where there is none.
double numberIn(const MeasuredElement& element, double possibleMin, int column) {
    if (column == ElementModel::floor) return element.floor ? *element.floor : std::nan("");
    if (column == ElementModel::facing) return element.azimuthDeg;
    const Figure& figure = figureOf(column);
    const MapPoint point{&element, possibleMin};
    const double value = figure.get(&point);
    return isInHours(figure) ? value / minutesOfHour : value;
}

bool isText(int column) { return column == ElementModel::id || column == ElementModel::building; }

QVariant valueOf(const MeasuredElement& element, double possibleMin, int column) {
    if (isText(column)) return QString::fromStdString(textIn(element, column));
    const double number = numberIn(element, possibleMin, column);
    return std::isnan(number) ? QVariant() : QVariant(number);
}

int decimalsOf(int column) { return column < ElementModel::sun ? 0 : figureOf(column).shownDecimals; }

QVariant textOf(const QVariant& value, int column) {
    if (!value.isValid() || isText(column)) return value;
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

int ElementModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : sun + int(pointFigures().rows().size());
}

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
    const std::array<QString, sun> names{tr("Point"), tr("Building"), tr("Floor"), tr("Facing, °")};
    return section < sun ? names[std::size_t(section)] : headingOf(figureOf(section));
}

ElementFilter::ElementFilter(QObject* parent) : QSortFilterProxyModel(parent) {
    setSortRole(ElementModel::valueRole);
}

void ElementFilter::setText(const QString& text) {
    text_ = text;
    invalidateFilter();
}

void ElementFilter::setBelowHours(double hours) {
    belowHours_ = hours;
    invalidateFilter();
}

// Without a QVariant for each value: a quarter of a million rows are sorted at a click. Rows without a number
// come first.
bool ElementFilter::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    const ElementMap& map = *static_cast<const ElementModel*>(sourceModel())->map();
    const MeasuredElement &a = map.elements[std::size_t(left.row())],
                          &b = map.elements[std::size_t(right.row())];
    const int column = left.column();
    if (isText(column)) return textIn(a, column) < textIn(b, column);
    const double first = numberIn(a, map.possibleMin, column), second = numberIn(b, map.possibleMin, column);
    return std::isnan(first) ? !std::isnan(second) : first < second;
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
