#include "app/window/scenarios/scenario_table.h"

#include <QFont>
#include <algorithm>

#include "app/report/sheets/study_words.h"
#include "app/window/project/project_session.h"
#include "app/window/scenarios/use_words.h"
#include "app/window/widgets/number_words.h"
#include "core/measures/has_runs.h"

namespace noonmark {

namespace {

struct Column {
    const char* title;
    const char* tip;
};

constexpr Column columns[] = {
    {QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Scenario"),
     QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Double-click to show it")},
    {QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Changes"),
     QT_TRANSLATE_NOOP("noonmark::ScenarioTable",
                       "Steps from the existing city, including those of its bases")},
    {QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Shadow area, m²"),
     QT_TRANSLATE_NOOP("noonmark::ScenarioTable",
                       "Sum over the receivers of (share of the sunlit time in shadow × cell area)")},
    {QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Mean gross, min"),
     QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Minutes in shadow per day, mean over days and receivers")},
    {QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Mean continuous, min"),
     QT_TRANSLATE_NOOP("noonmark::ScenarioTable",
                       "Longest unbroken run in shadow on any day, mean over the receivers")},
    {QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Floor area by use"),
     QT_TRANSLATE_NOOP(
         "noonmark::ScenarioTable",
         "Gross floor area of the scenario's towers by use, sorted by its sum. Imported buildings "
         "and towers whose height was changed afterwards are not counted")},
};

enum Index { nameColumn, changesColumn, areaColumn, grossColumn, continuousColumn, usesColumn };

QVariant figureAt(const ShadowStatistics& figures, int column) {
    if (column == areaColumn) return figures.shadowAreaM2;
    if (column == grossColumn) return figures.meanGrossMin;
    return hasRuns(figures) ? QVariant(figures.meanContinuousMin) : QVariant();
}

// Below every number, while an invalid value would be above.
QVariant sortKey(const QVariant& value) { return value.isValid() ? value : QVariant(-1.0); }

QVariant sumAreas(const ScenarioUses& uses) {
    if (uses.areas.empty()) return {};
    double sumM2 = 0;
    for (const UseArea& area : uses.areas) sumM2 += area.grossFloorM2;
    return sumM2;
}

}  // namespace

ScenarioTable::ScenarioTable(ProjectSession& session, QObject* parent)
    : QAbstractTableModel(parent), session_(session) {
    connect(&session_, &ProjectSession::changed, this, &ScenarioTable::follow);
    follow();
}

// Summing floor areas takes some ms per tower: those of unchanged edits stay.
ScenarioTable::Row ScenarioTable::makeRow(const std::string& scenario) const {
    const auto known = std::ranges::find(rows_, scenario, &Row::scenario);
    const auto edits = collectEdits(session_.project().scenarios, scenario);
    if (!edits) return {scenario, {}, {}};
    if (known != rows_.end() && known->edits == *edits) return *known;
    return {scenario, *edits, sumUses(*edits)};
}

void ScenarioTable::follow() {
    std::vector<Row> rows{makeRow(existingCity)};
    for (const Scenario& scenario : session_.project().scenarios) rows.push_back(makeRow(scenario.name));
    if (std::ranges::equal(rows, rows_, {}, &Row::scenario, &Row::scenario)) {
        rows_ = std::move(rows);
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    } else {
        beginResetModel();
        rows_ = std::move(rows);
        endResetModel();
    }
}

void ScenarioTable::setStudies(Studies studies, const StudySettings& settings) {
    std::erase_if(studies, [&](const auto& one) { return one.second->settings != settings; });
    studies_ = std::move(studies);
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

std::string ScenarioTable::scenarioAt(int row) const { return rows_.at(std::size_t(row)).scenario; }

int ScenarioTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(rows_.size());
}

int ScenarioTable::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(std::size(columns));
}

QVariant ScenarioTable::valueAt(const Row& row, int column) const {
    if (column == nameColumn) return QString::fromStdString(row.scenario);
    if (column == changesColumn) return row.edits ? QVariant(quint64(row.edits->size())) : QVariant();
    if (column == usesColumn) return sumAreas(row.uses);
    const auto study = studies_.find(row.scenario);
    return study == studies_.end() ? QVariant() : figureAt(study->second->statistics, column);
}

QString ScenarioTable::textAt(const Row& row, int column) const {
    const QVariant value = valueAt(row, column);
    if (column == nameColumn) return value.toString();
    if (column == usesColumn) return describeUses(row.uses);
    if (column == continuousColumn && !value.isValid() && studies_.contains(row.scenario))
        return QObject::tr("not counted");
    if (!value.isValid()) return {};
    return formatAmount(value.toDouble(), column == changesColumn || column == areaColumn ? 0 : 1);
}

QString ScenarioTable::tipAt(const Row& row, int column) const {
    if (column == usesColumn) return describeUseLines(row.uses);
    const bool figure = column == areaColumn || column == grossColumn || column == continuousColumn;
    if (!figure || studies_.contains(row.scenario)) return {};
    return tr("Not computed with the current settings: show the scenario and press Run");
}

QVariant ScenarioTable::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const Row& row = rows_[std::size_t(index.row())];
    const int column = index.column();
    const bool number = column != nameColumn && column != usesColumn;
    if (role == Qt::DisplayRole) return textAt(row, column);
    if (role == sortRole) return sortKey(valueAt(row, column));
    if (role == Qt::ToolTipRole) return tipAt(row, column);
    if (role == Qt::TextAlignmentRole && number) return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::FontRole && row.scenario == session_.scenario()) {
        QFont bold;
        bold.setBold(true);
        return bold;
    }
    return {};
}

QVariant ScenarioTable::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount()) return {};
    if (role == Qt::DisplayRole) return tr(columns[section].title);
    if (role == Qt::ToolTipRole) return tr(columns[section].tip);
    return {};
}

}  // namespace noonmark
