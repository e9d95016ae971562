#include "app/gui/docks/scenarios/scenario_table.h"

#include <QFont>
#include <QIcon>
#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/review/verdict_table.h"
#include "app/gui/session/answers/result_rows.h"
#include "app/gui/session/project/project_session.h"
#include "core/base/csv_text.h"
#include "scenarios/scenario.h"

namespace noonmark {

namespace {

// Below every number, while an invalid value would be above.
QVariant sortKey(const QVariant& value) {
    return value.isValid() ? value : QVariant(-std::numeric_limits<double>::infinity());
}

QString named(const std::string& name) { return QString::fromStdString(name); }

// A filled star in the colour of the text.
QIcon bestMark() {
    QPixmap star(24, 24);
    star.fill(Qt::transparent);
    QPainter painter(&star);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(inksOf(themeInUse()).text);
    QPolygonF shape;
    for (int i = 0; i < 10; ++i) {
        const double angle = std::numbers::pi * (i / 5.0 - 0.5), radius = i % 2 == 0 ? 11 : 4.5;
        shape << QPointF(12 + radius * std::cos(angle), 12.5 + radius * std::sin(angle));
    }
    painter.drawPolygon(shape);
    painter.end();
    return star;
}

QString notDone(ScenarioWork work) {
    if (work == ScenarioWork::scoring) return ScenarioTable::tr("not scored");
    if (work == ScenarioWork::comparing) return ScenarioTable::tr("not compared");
    return work == ScenarioWork::reviewing ? ScenarioTable::tr("not reviewed")
                                           : ScenarioTable::tr("not measured");
}

QString beingDone(ScenarioWork work) {
    if (work == ScenarioWork::scoring) return ScenarioTable::tr("being scored");
    return work == ScenarioWork::reviewing ? ScenarioTable::tr("being reviewed")
                                           : ScenarioTable::tr("being measured");
}

constexpr ScenarioWork allWork[] = {ScenarioWork::measuring, ScenarioWork::measuringPlaces,
                                    ScenarioWork::comparing, ScenarioWork::scoring, ScenarioWork::reviewing};

bool isFilled(const ScenarioAnswers& answers, ScenarioWork work) {
    if (work == ScenarioWork::measuring) return answers.measured.has_value();
    if (work == ScenarioWork::measuringPlaces) return answers.sun.has_value();
    if (work == ScenarioWork::comparing) return answers.impact.has_value();
    return work == ScenarioWork::scoring ? answers.score.has_value() : answers.verdicts.has_value();
}

// What a scenario lacks is written once for each kind of work.
const ScenarioColumn& firstColumnOf(ScenarioWork work) {
    return *std::ranges::find(scenarioColumns(), work, &ScenarioColumn::work);
}

// More sun is worse where shade is wanted.
bool isLowerBetter(const ScenarioColumn& column, bool shadeWanted) {
    if (column.work == ScenarioWork::measuringPlaces) return shadeWanted;
    const Better better = betterOf(column);
    return better == Better::lower || (better == Better::lessShadow && !shadeWanted);
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

void ScenarioTable::showAgain() {
    notePast();
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

void ScenarioTable::notePast() {
    for (const Row& row : rows_)
        for (const ScenarioWork work : allWork)
            if (isFilled(answersOf(row), work)) {
                past_.emplace(row.scenario, work);
                failures_.erase({row.scenario, work});
            }
}

void ScenarioTable::setStudies(Studies studies, const StudySettings& settings) {
    std::erase_if(studies, [&](const auto& one) { return one.second->settings != settings; });
    studies_ = std::move(studies);
    region_ = settings.region.name;
    period_ = formatText(settings.period);
    showAgain();
}

void ScenarioTable::setAnswers(std::map<std::string, ScenarioAnswers> answers, const Basis& basis) {
    answers_ = std::move(answers);
    basis_ = basis;
    showAgain();
}

void ScenarioTable::setDifferences(bool differences) {
    differences_ = differences;
    showAgain();
}

void ScenarioTable::setShadeWanted(bool wanted) {
    shadeWanted_ = wanted;
    showAgain();
}

void ScenarioTable::noteFailure(const std::string& scenario, ScenarioWork work, const QString& error) {
    failures_[{scenario, work}] = error;
    showAgain();
}

void ScenarioTable::setWorking(ScenarioWork work, bool isWorking) {
    if (working_.contains(work) == isWorking) return;
    isWorking ? void(working_.insert(work)) : void(working_.erase(work));
    showAgain();
}

void ScenarioTable::forgetPast() {
    past_.clear();
    failures_.clear();
}

// The figures are of the study at hand, or else of an earlier one.
ScenarioAnswers ScenarioTable::answersOf(const Row& row) const {
    const auto found = answers_.find(row.scenario);
    ScenarioAnswers answers = found == answers_.end() ? ScenarioAnswers() : found->second;
    if (const auto study = studies_.find(row.scenario); study != studies_.end())
        answers.measured = study->second->statistics;
    return answers;
}

std::string ScenarioTable::scenarioAt(int row) const { return rows_.at(std::size_t(row)).scenario; }

std::vector<int> ScenarioTable::readingOrder() const {
    const auto rankOf = [this](int column) {
        if (column == 0) return 0;
        if (scenarioColumns()[std::size_t(column)].work == ScenarioWork::none) return 2;
        const bool isKnown =
            std::ranges::any_of(rows_, [&](const Row& row) { return valueAt(row, column).isValid(); });
        return isKnown ? 1 : 3;
    };
    std::vector<int> order(scenarioColumns().size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, rankOf);
    return order;
}

int ScenarioTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(rows_.size());
}

int ScenarioTable::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : int(scenarioColumns().size());
}

QVariant ScenarioTable::valueAt(const Row& row, int column) const {
    return scenarioColumns()[std::size_t(column)].value(row, answersOf(row));
}

bool ScenarioTable::showsDifferenceAt(const Row& row, int column) const {
    return differences_ && scenarioColumns()[std::size_t(column)].isCompared &&
           row.scenario != basis_.baseline;
}

QVariant ScenarioTable::shownValueAt(const Row& row, int column) const {
    return showsDifferenceAt(row, column) ? differenceAt(row, column) : valueAt(row, column);
}

QVariant ScenarioTable::differenceAt(const Row& row, int column) const {
    const QVariant value = valueAt(row, column);
    if (!value.isValid()) return value;
    const auto baseline = std::ranges::find(rows_, basis_.baseline, &Row::scenario);
    const QVariant base = baseline == rows_.end() ? QVariant() : valueAt(*baseline, column);
    if (base.isValid()) return value.toDouble() - base.toDouble();
    // A baseline that adds no building has no height and no floor area: all of the value is the difference.
    return scenarioColumns()[std::size_t(column)].work == ScenarioWork::none ? value : QVariant();
}

bool ScenarioTable::isBest(const Row& row, int column) const {
    const ScenarioColumn& of = scenarioColumns()[std::size_t(column)];
    const QVariant value = valueAt(row, column);
    if (betterOf(of) == Better::none || !value.isValid()) return false;
    const bool lower = isLowerBetter(of, shadeWanted_);
    bool beats = false;
    for (const Row& other : rows_) {
        const QVariant rival = valueAt(other, column);
        if (!rival.isValid()) continue;
        const double lead = rival.toDouble() - value.toDouble();
        if (lower ? lead < 0 : lead > 0) return false;
        beats |= rival.toDouble() != value.toDouble();
    }
    return beats;
}

QString ScenarioTable::textAt(const Row& row, int at) const {
    const ScenarioColumn& column = scenarioColumns()[std::size_t(at)];
    if (at == 0) return named(row.scenario);
    if (column.key == "uses") return describeUses(row.uses);
    const QVariant value = valueAt(row, at);
    if (!value.isValid()) return lackAt(row, column);
    if (column.work == ScenarioWork::reviewing) return describeCounts(answersOf(row).verdicts->counts);
    const QVariant shown = shownValueAt(row, at);
    if (!shown.isValid()) return tr("no baseline");
    return numberText(shown.toDouble(), column, showsDifferenceAt(row, at));
}

bool ScenarioTable::isBaselineOf(const Row& row, ScenarioWork work) const {
    if (work == ScenarioWork::comparing) return row.scenario == basis_.baseline;
    return work == ScenarioWork::reviewing && row.scenario == basis_.ruleBaseline;
}

QString ScenarioTable::lackAt(const Row& row, const ScenarioColumn& column) const {
    const ScenarioWork work = column.work;
    if (work == ScenarioWork::none || isBaselineOf(row, work)) return {};
    if (isFilled(answersOf(row), work)) return tr("not counted");
    if (!row.city) return tr("starting scenario missing");
    if (work == ScenarioWork::scoring && !basis_.hasWeights) return tr("no weights");
    if (work == ScenarioWork::reviewing && basis_.rule.empty()) return tr("no rule");
    if (working_.contains(work)) return beingDone(work);
    if (failures_.contains({row.scenario, work})) return tr("failed");
    return past_.contains({row.scenario, work}) ? tr("out of date") : notDone(work);
}

QString ScenarioTable::listLacks(const Row& row) const {
    QStringList lacks;
    for (const ScenarioWork work : allWork) {
        const ScenarioColumn& column = firstColumnOf(work);
        const auto failure = failures_.find({row.scenario, work});
        if (column.value(row, answersOf(row)).isValid() || lackAt(row, column).isEmpty()) continue;
        const QString reason = failure == failures_.end() ? lackAt(row, column) : failure->second;
        lacks << QString::fromUtf8(column.key.data(), qsizetype(column.key.size())) + QStringLiteral(": ") +
                     reason;
    }
    return lacks.join(QStringLiteral("; "));
}

QString ScenarioTable::tipAt(const Row& row, int at) const {
    const ScenarioColumn& column = scenarioColumns()[std::size_t(at)];
    if (column.key == "floor_area" || column.key == "uses") return describeUseLines(row.uses);
    if (column.key == "height" && !row.heightM) return tr("The scenario adds no building");
    if (column.work == ScenarioWork::none) return {};
    const bool filled = isFilled(answersOf(row), column.work);
    const QString tip = filled ? tipOfValue(row, column) : tipOfLack(row, column);
    return isBest(row, at) ? tr("Best of this column") + QLatin1Char('\n') + tip : tip;
}

// What the figure belongs to.
QString ScenarioTable::tipOfValue(const Row& row, const ScenarioColumn& column) const {
    const ScenarioAnswers answers = answersOf(row);
    if (column.work == ScenarioWork::scoring) {
        QStringList lines{tr("With the weights %1").arg(named(answers.score->weights))};
        for (const ShownError& error : answers.score->errors)
            if (error.facts.key == column.key)
                lines << tr("Measured error against rays: %1").arg(sentenceText(describe(error)));
        return lines.join(QLatin1Char('\n'));
    }
    if (column.work == ScenarioWork::reviewing)
        return tr("%1, compared with %2")
            .arg(named(answers.verdicts->rule), named(answers.verdicts->baseline));
    if (column.work == ScenarioWork::measuring)
        return studies_.contains(row.scenario)
                   ? QString()
                   : tr("Measured earlier and saved with the project: press Measure all for the maps");
    if (column.work == ScenarioWork::measuringPlaces)
        return tr("Over the area of the %Ln place(s) that were measured last", "", int(answers.sun->places));
    const ImpactFigures& figures = answers.impact->figures;
    return tr("Compared with %1. Ground whose gross shadow changes by more than %2 min a day:\n%3")
        .arg(named(answers.impact->baseline))
        .arg(figures.thresholdMin)
        .arg(describeChangedArea(figures.gross));
}

// How to get it for the scenario as it is now.
QString ScenarioTable::tipOfLack(const Row& row, const ScenarioColumn& column) const {
    if (const auto failure = failures_.find({row.scenario, column.work}); failure != failures_.end())
        return failure->second;
    if (column.work == ScenarioWork::measuring)
        return tr("Not computed with the current settings: press Measure all");
    if (column.work == ScenarioWork::measuringPlaces)
        return tr(
            "Not measured since buildings last changed: choose Sun by place in the panel Study, and "
            "press Measure all");
    if (column.work == ScenarioWork::scoring)
        return tr("Not computed with these settings and the weights %1 since buildings last changed: "
                  "press Score all")
            .arg(named(basis_.weights));
    if (column.work == ScenarioWork::reviewing)
        return tr("Not reviewed by the rule %1 since buildings or places last changed: press Review all")
            .arg(named(basis_.rule));
    if (row.scenario == basis_.baseline) return tr("The other scenarios are compared with this one");
    return tr("Not compared with %1 with these settings since buildings last changed: press Measure all")
        .arg(named(basis_.baseline));
}

std::vector<ScenarioMonths> ScenarioTable::months() const {
    std::vector<ScenarioMonths> all;
    for (const Row& row : rows_) {
        ScenarioMonths months{row.scenario};
        if (const auto study = studies_.find(row.scenario); study != studies_.end())
            months.study = study->second;
        const ScenarioAnswers answers = answersOf(row);
        if (answers.score) months.score = answers.score->months;
        months.sun = answers.sun;
        all.insert(row.scenario == basis_.baseline ? all.begin() : all.end(), std::move(months));
    }
    return all;
}

QString ScenarioTable::verdict() const {
    QStringList sentences{impactVerdict(), scoreVerdict()};
    sentences.removeAll(QString());
    return sentences.join(QLatin1Char(' '));
}

QString ScenarioTable::impactVerdict() const {
    using Impact = std::pair<QString, ImpactFigures>;
    std::vector<Impact> impacts;
    for (const Row& row : rows_)
        if (const auto impact = answersOf(row).impact)
            impacts.emplace_back(named(row.scenario), impact->figures);
    if (impacts.empty()) return {};
    const auto area = [](const Impact& one) {
        const double changeM2 = one.second.shadowAreaChangeM2;
        return withPlus(changeM2, describeSmallArea(changeM2));
    };
    const auto ground = [](const Impact& one) { return describeSmallArea(one.second.gross.moreShadowM2); };
    const auto [minimum, maximum] = std::ranges::minmax_element(
        impacts, {}, [](const Impact& one) { return one.second.shadowAreaChangeM2; });
    const double minutes = minimum->second.thresholdMin;
    if (impacts.size() == 1)
        return tr("%1 changes the shadow area by %2: area times its share of the sunlit time. Ground with "
                  "over %3 min more shadow a day: %4.")
            .arg(minimum->first, area(*minimum))
            .arg(minutes)
            .arg(ground(*minimum));
    if (minimum->second.shadowAreaChangeM2 == maximum->second.shadowAreaChangeM2)
        return tr("All scenarios change the shadow area by %1.").arg(area(*minimum));
    return tr("%1 adds less shadow than %2: %3 of shadow area against %4 (area times its share of the sunlit "
              "time), and %5 against %6 of ground with over %7 min more a day.")
        .arg(minimum->first, maximum->first, area(*minimum), area(*maximum), ground(*minimum),
             ground(*maximum))
        .arg(minutes);
}

QString ScenarioTable::scoreVerdict() const {
    using Scored = std::pair<QString, ScoreTotals>;
    std::vector<Scored> scores;
    for (const Row& row : rows_)
        if (const auto score = answersOf(row).score) scores.emplace_back(named(row.scenario), score->totals);
    if (scores.size() < 2) return {};
    const auto [minimum, maximum] =
        std::ranges::minmax_element(scores, {}, [](const Scored& one) { return one.second.scoreM2; });
    if (minimum->second.scoreM2 == maximum->second.scoreM2) return {};
    return tr("By the weights %1, %2 scores best (%3) and %4 worst (%5).")
        .arg(named(basis_.weights), maximum->first, formatAmount(maximum->second.scoreM2, 0), minimum->first,
             formatAmount(minimum->second.scoreM2, 0));
}

std::string ScenarioTable::csv() const {
    const auto& columns = scenarioColumns();
    std::vector<std::string> keys;
    for (const ScenarioColumn& column : columns) keys.emplace_back(column.key);
    for (const ScenarioColumn& column : columns)
        if (column.isCompared) keys.push_back(std::string(column.key) + "_difference");
    for (const char* key : {"baseline", "weights", "rule", "region", "period", "enough_hours", "lacks"})
        keys.emplace_back(key);
    CsvText text(keys);
    const auto number = [&](const QVariant& value) {
        value.isValid() ? text.number(value.toDouble()) : text.nothing();
    };
    for (const Row& row : rows_) {
        for (int at = 0; at < columnCount(); ++at) {
            if (columns[std::size_t(at)].isNumber)
                number(valueAt(row, at));
            else
                text.text((valueAt(row, at).isValid() ? textAt(row, at) : QString()).toStdString());
        }
        for (int at = 0; at < columnCount(); ++at)
            if (columns[std::size_t(at)].isCompared) number(differenceAt(row, at));
        for (const std::string& fact : {basis_.baseline, basis_.weights, basis_.rule, region_, period_})
            text.text(fact);
        const ScenarioAnswers answers = answersOf(row);
        number(answers.sun ? QVariant(answers.sun->enoughHours) : QVariant());
        text.text(listLacks(row).toStdString()).endRow();
    }
    return text.take();
}

QVariant ScenarioTable::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const Row& row = rows_[std::size_t(index.row())];
    const int column = index.column();
    if (role == Qt::DisplayRole) return textAt(row, column);
    if (role == sortRole) return sortKey(shownValueAt(row, column));
    if (role == bestRole) return isBest(row, column);
    if (role == Qt::DecorationRole && isBest(row, column)) return bestMark();
    if (role == Qt::ToolTipRole) return tipAt(row, column);
    if (role == Qt::TextAlignmentRole && scenarioColumns()[std::size_t(column)].isNumber)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ForegroundRole && !valueAt(row, column).isValid()) return inksOf(themeInUse()).quiet;
    if (role == Qt::FontRole && row.scenario == session_.scenario()) {
        QFont bold;
        bold.setBold(true);
        return bold;
    }
    return {};
}

QVariant ScenarioTable::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount()) return {};
    const ScenarioColumn& column = scenarioColumns()[std::size_t(section)];
    if (role == keyRole) return QString::fromUtf8(column.key.data(), qsizetype(column.key.size()));
    if (role == Qt::ToolTipRole) return tipOf(column);
    return role == Qt::DisplayRole ? titleOf(column) : QVariant();
}

}  // namespace noonmark
