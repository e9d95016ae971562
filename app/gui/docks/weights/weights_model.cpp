#include "app/gui/docks/weights/weights_model.h"

#include <QLocale>
#include <algorithm>

#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/project/project_session.h"
#include "scenarios/weights/edit_weights.h"
#include "scenarios/weights/time_weights.h"

namespace noonmark {

namespace {

struct ColumnWords {
    const char* key;  ///< key in textsOf(WeightedInterval)
    const char* title;
    const char* tip;
};

constexpr ColumnWords columns[] = {
    {"name", QT_TRANSLATE_NOOP("noonmark::WeightsModel", "Interval"),
     QT_TRANSLATE_NOOP("noonmark::WeightsModel", "Name of the interval")},
    {"first", QT_TRANSLATE_NOOP("noonmark::WeightsModel", "First"),
     QT_TRANSLATE_NOOP("noonmark::WeightsModel",
                       "First day, every year: month and day such as 06-01, or a month such as June")},
    {"last", QT_TRANSLATE_NOOP("noonmark::WeightsModel", "Last"),
     QT_TRANSLATE_NOOP(
         "noonmark::WeightsModel",
         "Last day, included; before the first: across New Year. Such as 08-31, or a month such as August")},
    {"from", QT_TRANSLATE_NOOP("noonmark::WeightsModel", "From"),
     QT_TRANSLATE_NOOP("noonmark::WeightsModel",
                       "Time of day at which it begins, wall clock: 00:00 to 24:00")},
    {"to", QT_TRANSLATE_NOOP("noonmark::WeightsModel", "To"),
     QT_TRANSLATE_NOOP("noonmark::WeightsModel", "Time of day at which it ends: 00:00 to 24:00")},
    {"weight", QT_TRANSLATE_NOOP("noonmark::WeightsModel", "Weight"),
     QT_TRANSLATE_NOOP("noonmark::WeightsModel", "-1 (shadow unwanted) to 1 (shade wanted)")},
};

QString describeDay(std::chrono::month_day day) {
    return QStringLiteral("%1 %2")
        .arg(unsigned(day.day()))
        .arg(QLocale().standaloneMonthName(int(unsigned(day.month())), QLocale::ShortFormat));
}

constexpr int weightDigits = 3;

QString shownText(const WeightedInterval& interval, int column) {
    if (column == WeightsModel::firstDay) return describeDay(interval.first);
    if (column == WeightsModel::lastDay) return describeDay(interval.last);
    if (column == WeightsModel::intervalName) return weightName(interval.name);
    if (column == WeightsModel::intervalWeight) return formatShort(interval.weight, weightDigits);
    return QString::fromStdString(textsOf(interval).at(columns[column].key));
}

// Names and numbers are edited as they are shown.
QString editedText(const WeightedInterval& interval, int column) {
    if (column == WeightsModel::intervalName || column == WeightsModel::intervalWeight)
        return shownText(interval, column);
    return QString::fromStdString(textsOf(interval).at(columns[column].key));
}

}  // namespace

WeightsModel::WeightsModel(ProjectSession& session, QObject* parent)
    : QAbstractTableModel(parent), session_(session) {
    connect(&session_, &ProjectSession::changed, this, &WeightsModel::follow);
    connect(&session_, &ProjectSession::renamed, this,
            [this](ProjectPart part, const std::string& from, const std::string& to) {
                if (part == ProjectPart::weights && table_.name == from) table_.name = to;
            });
}

void WeightsModel::setTable(const std::string& name) {
    table_.name = name;
    follow();
    Q_EMIT chosen();
}

void WeightsModel::follow() {
    replaceTable(findWeights(session_.project(), table_.name).value_or(TimeWeights{table_.name, {}}));
}

// Keeps rows that are equal at the beginning and at the end, replaces those in between, and then adds or
// removes what is left: views take the rows around an insertion for unchanged.
void WeightsModel::replaceTable(TimeWeights table) {
    auto& was = table_.intervals;
    const auto& is = table.intervals;
    const auto [oldFirst, newFirst] = std::ranges::mismatch(was, is);
    const int first = int(oldFirst - was.begin());
    const int common = int(std::min(was.size(), is.size())) - first;
    int same = 0;
    while (same < common && *(was.end() - 1 - same) == *(is.end() - 1 - same)) ++same;
    const int replaced = std::min(int(was.size()), int(is.size())) - first - same;
    const int grown = int(is.size()) - int(was.size());
    std::copy_n(newFirst, replaced, oldFirst);
    if (replaced > 0) Q_EMIT dataChanged(index(first, 0), index(first + replaced - 1, intervalWeight));
    if (grown > 0) beginInsertRows({}, first + replaced, first + replaced + grown - 1);
    if (grown < 0) beginRemoveRows({}, first + replaced, first + replaced - grown - 1);
    table_ = std::move(table);
    if (grown > 0) endInsertRows();
    if (grown < 0) endRemoveRows();
}

bool WeightsModel::change(const Result<TimeWeights>& next) {
    const Result<void> sound = next ? validate(*next) : tl::make_unexpected(next.error());
    if (!sound) {
        Q_EMIT refused(sound.error());
        return false;
    }
    Project project = session_.project();
    std::ranges::replace_if(
        project.weights, [&](const TimeWeights& one) { return one.name == table_.name; }, *next);
    if (!session_.change(std::move(project), tr("edit weights %1").arg(weightName(table_.name))))
        return false;
    Q_EMIT edited();
    return true;
}

int WeightsModel::add(int afterRow) {
    if (table_.intervals.empty()) return -1;
    const auto added = addInterval(table_, std::size_t(std::clamp(afterRow, 0, rowCount() - 1)));
    return change(added.map([](const AddedInterval& one) { return one.table; })) ? int(added->position) : -1;
}

bool WeightsModel::paint(const MonthsAndHours& time, std::optional<double> weight) {
    if (table_.intervals.empty()) return false;
    const auto painted = paintWeights(table_, time, weight);
    return painted == table_ || change(painted);
}

bool WeightsModel::removeRows(int row, int count, const QModelIndex& parent) {
    if (parent.isValid() || count != 1 || row < 0 || row >= rowCount()) return false;
    return change(removeInterval(table_, std::size_t(row)));
}

int WeightsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(table_.intervals.size());
}

int WeightsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(std::size(columns));
}

QVariant WeightsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const WeightedInterval& interval = table_.intervals[std::size_t(index.row())];
    if (role == Qt::DisplayRole) return shownText(interval, index.column());
    if (role == Qt::EditRole) return editedText(interval, index.column());
    if (role == Qt::UserRole) return interval.weight;
    if (role == Qt::ToolTipRole) return tr(columns[index.column()].tip);
    return {};
}

bool WeightsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || role != Qt::EditRole) return false;
    const auto row = std::size_t(index.row());
    auto texts = textsOf(table_.intervals[row]);
    QString typed = value.toString().trimmed();
    if (typed == editedText(table_.intervals[row], index.column())) return true;
    if (index.column() == intervalWeight) typed.replace(QLocale().decimalPoint(), QStringLiteral("."));
    texts.at(columns[index.column()].key) = typed.toStdString();
    const auto interval = intervalFrom(texts, tr("row %1").arg(index.row() + 1).toStdString());
    return change(interval.map([&](const WeightedInterval& one) {
        TimeWeights next = table_;
        next.intervals[row] = one;
        return next;
    }));
}

QVariant WeightsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount()) return {};
    if (role == Qt::DisplayRole) return tr(columns[section].title);
    if (role == Qt::ToolTipRole) return tr(columns[section].tip);
    return {};
}

Qt::ItemFlags WeightsModel::flags(const QModelIndex& index) const {
    return index.isValid() ? Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable : Qt::NoItemFlags;
}

}  // namespace noonmark
