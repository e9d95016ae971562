#include "app/window/scenarios/scenario_table.h"

#include <QFont>

#include "app/report/sheets/study_words.h"
#include "app/window/project/project_session.h"
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
};

QString figureAt(const Study& study, int column) {
    const ShadowStatistics& figures = study.statistics;
    if (column == 2) return formatAmount(figures.shadowAreaM2, 0);
    if (column == 4 && !hasRuns(figures)) return QObject::tr("not counted");
    return formatAmount(column == 3 ? figures.meanGrossMin : figures.meanContinuousMin);
}

}  // namespace

ScenarioTable::ScenarioTable(ProjectSession& session, QObject* parent)
    : QAbstractTableModel(parent), session_(session), scenarios_{existingCity} {
    connect(&session_, &ProjectSession::changed, this, &ScenarioTable::follow);
    follow();
}

void ScenarioTable::follow() {
    std::vector<std::string> names{existingCity};
    for (const Scenario& scenario : session_.project().scenarios) names.push_back(scenario.name);
    if (names != scenarios_) {
        beginResetModel();
        scenarios_ = std::move(names);
        endResetModel();
    } else {
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    }
}

void ScenarioTable::setStudies(Studies studies, const StudySettings& settings) {
    std::erase_if(studies, [&](const auto& one) { return one.second->settings != settings; });
    studies_ = std::move(studies);
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

std::string ScenarioTable::scenarioAt(int row) const { return scenarios_.at(std::size_t(row)); }

int ScenarioTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(scenarios_.size());
}

int ScenarioTable::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(std::size(columns));
}

QString ScenarioTable::textAt(const std::string& scenario, int column) const {
    if (column == 0) return QString::fromStdString(scenario);
    if (column == 1) {
        const auto edits = collectEdits(session_.project().scenarios, scenario);
        return edits ? QString::number(edits->size()) : QString();
    }
    const auto study = studies_.find(scenario);
    return study == studies_.end() ? QString() : figureAt(*study->second, column);
}

QVariant ScenarioTable::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const std::string& scenario = scenarios_[std::size_t(index.row())];
    if (role == Qt::DisplayRole) return textAt(scenario, index.column());
    if (role == Qt::TextAlignmentRole && index.column() > 0) return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && index.column() > 1 && !studies_.contains(scenario))
        return tr("Not computed with the current settings: show the scenario and press Run");
    if (role == Qt::FontRole && scenario == session_.scenario()) {
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
