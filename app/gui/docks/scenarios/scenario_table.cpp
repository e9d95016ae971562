#include "app/gui/docks/scenarios/scenario_table.h"

#include <QFont>
#include <algorithm>
#include <cmath>
#include <limits>

#include "app/gui/docks/review/verdict_words.h"
#include "app/gui/docks/scenarios/scenario_columns.h"
#include "app/gui/docks/scenarios/use_words.h"
#include "app/gui/session/answers/result_rows.h"
#include "app/gui/session/project/project_session.h"
#include "core/measures/has_runs.h"
#include "scenarios/scenario_list.h"

namespace noonmark {

namespace {

bool isOfStudy(int column) {
    return column >= ScenarioTable::shadowArea && column <= ScenarioTable::continuous;
}
bool isOfAnswers(int column) { return column >= ScenarioTable::impact && column <= ScenarioTable::verdicts; }

QVariant figureAt(const ShadowStatistics& figures, int column) {
    if (column == ScenarioTable::shadowArea) return figures.shadowAreaM2;
    if (column == ScenarioTable::gross) return figures.meanGrossMin;
    return hasRuns(figures) ? QVariant(figures.meanContinuousMin) : QVariant();
}

QVariant orNone(const std::optional<double>& value) { return value ? QVariant(*value) : QVariant(); }

// The fewest fails first, then the fewest borderline verdicts.
double rankOf(const VerdictCounts& counts) {
    const double share = 1 / double(counts.all() + 1);
    return double(counts.fail) + share * (double(counts.borderline) + share * double(counts.notChecked));
}

// Below every number, while an invalid value would be above.
QVariant sortKey(const QVariant& value) {
    return value.isValid() ? value : QVariant(-std::numeric_limits<double>::infinity());
}

QString named(const std::string& name) { return QString::fromStdString(name); }

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
    const auto city = session_.cityOf(scenario).value_or(nullptr);
    if (!edits || !city) return {scenario, nullptr, {}, {}, {}};
    if (known != rows_.end() && known->edits == *edits && known->city == city) return *known;
    return {scenario, city, *edits, sumUses(*edits), findProposedHeightM(*city, *edits)};
}

void ScenarioTable::follow() {
    std::vector<Row> rows;
    for (const std::string& name : listNames(session_.project().scenarios)) rows.push_back(makeRow(name));
    if (std::ranges::equal(rows, rows_, {}, &Row::scenario, &Row::scenario)) {
        rows_ = std::move(rows);
        showAgain();
    } else {
        beginResetModel();
        rows_ = std::move(rows);
        endResetModel();
    }
}

void ScenarioTable::showAgain() { Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1)); }

void ScenarioTable::setStudies(Studies studies, const StudySettings& settings) {
    std::erase_if(studies, [&](const auto& one) { return one.second->settings != settings; });
    studies_ = std::move(studies);
    showAgain();
}

void ScenarioTable::setAnswers(std::map<std::string, ScenarioAnswers> answers, const Basis& basis) {
    answers_ = std::move(answers);
    basis_ = basis;
    showAgain();
}

ScenarioAnswers ScenarioTable::answersOf(const Row& row) const {
    const auto found = answers_.find(row.scenario);
    return found == answers_.end() ? ScenarioAnswers() : found->second;
}

std::string ScenarioTable::scenarioAt(int row) const { return rows_.at(std::size_t(row)).scenario; }

int ScenarioTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(rows_.size());
}

int ScenarioTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : columns; }

QVariant ScenarioTable::answerAt(const Row& row, int column) const {
    const ScenarioAnswers answers = answersOf(row);
    if (column == impact && answers.impact) return answers.impact->figures.shadowAreaChangeM2;
    if (column == score && answers.score) return answers.score->totals.scoreM2;
    if (column == weightedShade && answers.score && !std::isnan(answers.score->totals.weightedShadeM2h))
        return answers.score->totals.weightedShadeM2h;
    if (column == verdicts && answers.verdicts) return rankOf(answers.verdicts->counts);
    return {};
}

QVariant ScenarioTable::valueAt(const Row& row, int column) const {
    if (column == scenario) return named(row.scenario);
    if (column == changes) return row.edits ? QVariant(quint64(row.edits->size())) : QVariant();
    if (column == height) return orNone(row.heightM);
    if (column == floorArea || column == uses) return orNone(sumFloorAreaM2(row.uses));
    if (isOfAnswers(column)) return answerAt(row, column);
    const auto measured = measuredOf(row);
    return measured ? figureAt(*measured, column) : QVariant();
}

// Of the study at hand, or else of an earlier one.
std::optional<ShadowStatistics> ScenarioTable::measuredOf(const Row& row) const {
    const auto study = studies_.find(row.scenario);
    return study == studies_.end() ? answersOf(row).measured : study->second->statistics;
}

QString ScenarioTable::textAt(const Row& row, int column) const {
    const QVariant value = valueAt(row, column);
    if (column == scenario) return value.toString();
    if (column == uses) return describeUses(row.uses);
    if (column == continuous && !value.isValid() && measuredOf(row)) return QObject::tr("not counted");
    if (!value.isValid()) return {};
    if (column == verdicts) return describeCounts(answersOf(row).verdicts->counts);
    return numberText(value.toDouble(), Column(column));
}

QString ScenarioTable::tipAt(const Row& row, int column) const {
    if (column == floorArea || column == uses) return describeUseLines(row.uses);
    if (column == height && !row.heightM) return tr("The scenario adds no building");
    if (isOfStudy(column) && !measuredOf(row))
        return tr("Not computed with the current settings: press Measure all");
    if (isOfStudy(column) && !studies_.contains(row.scenario))
        return tr("Measured earlier and saved with the project: press Measure all for the maps");
    return isOfAnswers(column) ? tipOfAnswer(row, column) : QString();
}

// What the figure belongs to or, where there is none for the scenario as it is now, how to get it.
QString ScenarioTable::tipOfAnswer(const Row& row, int column) const {
    const ScenarioAnswers answers = answersOf(row);
    if (column == score || column == weightedShade)
        return answers.score
                   ? tr("With the weights %1").arg(named(answers.score->weights))
                   : tr("Not computed with these settings and the weights %1 since buildings last changed: "
                        "press Score all")
                         .arg(named(basis_.weights));
    if (column == verdicts)
        return answers.verdicts ? tr("%1, compared with %2")
                                      .arg(named(answers.verdicts->rule), named(answers.verdicts->baseline))
                                : tr("Not reviewed by the rule %1 since buildings or places last changed: "
                                     "press Review all")
                                      .arg(named(basis_.rule));
    if (row.scenario == basis_.baseline) return tr("The other scenarios are compared with this one");
    if (!answers.impact)
        return tr("Not compared with %1 with these settings since buildings last changed: press Measure all")
            .arg(named(basis_.baseline));
    const ImpactFigures& figures = answers.impact->figures;
    return tr("Compared with %1. Ground whose gross shadow changes by more than %2 min a day:\n%3")
        .arg(named(answers.impact->baseline))
        .arg(figures.thresholdMin)
        .arg(describeChangedArea(figures.gross));
}

QVariant ScenarioTable::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const Row& row = rows_[std::size_t(index.row())];
    const int column = index.column();
    const bool number = column != scenario && column != verdicts && column != uses;
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
    return headingOf(Column(section), role);
}

}  // namespace noonmark
