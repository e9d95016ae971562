#include "app/gui/docks/scenarios/scenario_table.h"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/tools/massing/massing_text.h"
#include "core/measures/shadow_figures.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/weights/score_text.h"

namespace noonmark {

namespace {

QString nameOf(const UseArea& area) {
    return area.use.empty() ? QObject::tr("Use not stated") : QString::fromStdString(area.use);
}

// Imported buildings, and towers whose height was changed after they were designed.
QString describeNotCounted(int towers) {
    return QObject::tr("Not counted: %1 building(s) whose floors are not known", "", towers)
        .arg(formatCount(quint64(towers)));
}

}  // namespace

QString describeUses(const ScenarioUses& uses) {
    QStringList words;
    for (const UseArea& area : uses.areas)
        if (area.storeys > 0)
            words << QStringLiteral("%1 %2").arg(nameOf(area), describeSmallArea(area.grossFloorM2));
    return words.join(QStringLiteral(", "));
}

QString describeUseLines(const ScenarioUses& uses) {
    QStringList lines;
    for (const UseArea& area : uses.areas)
        if (area.storeys > 0)
            lines << QStringLiteral("%1: %2, %3")
                         .arg(nameOf(area), describeStoreys(area.storeys),
                              describeSmallArea(area.grossFloorM2));
    if (uses.towersNotCounted > 0) lines << describeNotCounted(uses.towersNotCounted);
    return lines.join(QLatin1Char('\n'));
}

namespace {

constexpr std::string_view heightKey = "height", floorAreaKey = "floor_area", changesKey = "changes";

QVariant orNone(const std::optional<double>& value) { return value ? QVariant(*value) : QVariant(); }
QVariant orNone(double value) { return std::isnan(value) ? QVariant() : QVariant(value); }

// The fewest fails first, then the fewest borderline verdicts.
double rankOf(const VerdictCounts& counts) {
    const double share = 1 / double(counts.all() + 1);
    return double(counts.fail) + share * (double(counts.borderline) + share * double(counts.notChecked));
}

ScenarioColumn nameColumn() {
    return {.key = "scenario",
            .title = QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Scenario"),
            .tip = QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Double-click to show it"),
            .isNumber = false,
            .value = [](const ScenarioRow& row, const ScenarioAnswers&) -> QVariant {
                return scenarioName(row.scenario);
            }};
}

ScenarioColumn changesColumn() {
    return {.key = changesKey,
            .title = QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Changes"),
            .tip = QT_TRANSLATE_NOOP("noonmark::ScenarioTable",
                                     "Steps from the existing city, including those of its bases"),
            .value = [](const ScenarioRow& row, const ScenarioAnswers&) {
                return row.edits ? QVariant(quint64(row.edits->size())) : QVariant();
            }};
}

ScenarioColumn heightColumn() {
    return {
        .key = heightKey,
        .title = QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Height, %1"),
        .tip = QT_TRANSLATE_NOOP("noonmark::ScenarioTable",
                                 "Highest point above its ground of the buildings that the scenario adds"),
        .isCompared = true,
        .value = [](const ScenarioRow& row, const ScenarioAnswers&) { return orNone(row.heightM); }};
}

QVariant floorAreaOf(const ScenarioRow& row, const ScenarioAnswers& /*answers*/) {
    return orNone(sumFloorAreaM2(row.uses));
}

ScenarioColumn floorAreaColumn() {
    return {
        .key = floorAreaKey,
        .title = QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Floor area, %1"),
        .tip = QT_TRANSLATE_NOOP("noonmark::ScenarioTable",
                                 "Gross floor area of the scenario's towers. Imported buildings and towers "
                                 "whose height was changed afterwards are not counted"),
        .isCompared = true,
        .value = floorAreaOf};
}

ScenarioColumn usesColumn() {
    return {.key = "uses",
            .title = QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Floor area by use"),
            .tip = QT_TRANSLATE_NOOP(
                "noonmark::ScenarioTable",
                "Gross floor area of the scenario's towers by use, sorted by its sum. Imported buildings "
                "and towers whose height was changed afterwards are not counted"),
            .isNumber = false,
            .value = floorAreaOf};
}

ScenarioColumn verdictsColumn() {
    return {
        .key = "verdicts",
        .title = QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Verdicts"),
        .tip = QT_TRANSLATE_NOOP("noonmark::ScenarioTable",
                                 "By the rule and the baseline that the panel Review shows; sorted by the "
                                 "number that fail, then by borderline ones"),
        .work = ScenarioWork::reviewing,
        .better = Better::lower,
        .isNumber = false,
        .value = [](const ScenarioRow&, const ScenarioAnswers& answers) {
            return answers.verdicts ? QVariant(rankOf(answers.verdicts->counts)) : QVariant();
        }};
}

ScenarioColumn shadowColumn(const Figure& figure) {
    const bool isOfRuns = figure.unit == FigureUnit::minutes;
    return {.key = figure.key,
            .figure = &figure,
            .work = ScenarioWork::measuring,
            .isCompared = true,
            .value = [&figure, isOfRuns](const ScenarioRow&, const ScenarioAnswers& answers) -> QVariant {
                const auto& measured = answers.measured;
                if (!measured || (isOfRuns && !hasRuns(*measured))) return {};
                return orNone(figure.get(&*measured));
            }};
}

ScenarioColumn sunColumn(std::string_view key, const char* title) {
    const Figure& figure = findFigure(sunOfPlaceFigures().rows(), key);
    return {.key = figure.key,
            .figure = &figure,
            .title = title,
            .work = ScenarioWork::measuringPlaces,
            .isCompared = true,
            .value = [&figure](const ScenarioRow&, const ScenarioAnswers& answers) {
                return answers.sun ? orNone(figure.get(&answers.sun->mean)) : QVariant();
            }};
}

ScenarioColumn impactColumn(const Figure& figure) {
    return {.key = figure.key,
            .figure = &figure,
            .title = QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Impact, %1"),
            .tip = QT_TRANSLATE_NOOP("noonmark::ScenarioTable",
                                     "Change of the shadow area from the chosen baseline, else from the "
                                     "existing city, on the receivers of both"),
            .work = ScenarioWork::comparing,
            .value = [&figure](const ScenarioRow&, const ScenarioAnswers& answers) {
                return answers.impact ? orNone(figure.get(&answers.impact->figures)) : QVariant();
            }};
}

ScenarioColumn scoreColumn(const Figure& figure) {
    return {.key = figure.key,
            .figure = &figure,
            .work = ScenarioWork::scoring,
            .isCompared = true,
            .value = [&figure](const ScenarioRow&, const ScenarioAnswers& answers) {
                return answers.score ? orNone(figure.get(&answers.score->totals)) : QVariant();
            }};
}

// The figures that tables show of each result.
std::vector<ScenarioColumn> listColumns() {
    std::vector columns{nameColumn(), changesColumn(), heightColumn(), floorAreaColumn()};
    for (const Figure& figure : shadowFigures().rows())
        if (figure.inTable && figure.use == FigureUse::result) columns.push_back(shadowColumn(figure));
    columns.push_back(
        sunColumn("hours_mean", QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Sun of places, h")));
    columns.push_back(sunColumn(
        "share_enough", QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Area of places with enough sun, %")));
    for (const Figure& figure : impactFigures().rows())
        if (figure.isChange && figure.inFiles) columns.push_back(impactColumn(figure));
    for (const Figure& figure : scoreFigures().rows())
        if (figure.isChange && figure.inFiles) columns.push_back(scoreColumn(figure));
    columns.push_back(verdictsColumn());
    columns.push_back(usesColumn());
    return columns;
}

FigureUnit unitIn(const ScenarioColumn& column) {
    if (column.figure) return column.figure->unit;
    return column.key == floorAreaKey ? FigureUnit::squareMetres : FigureUnit::none;
}

QString unitText(const ScenarioColumn& column) {
    if (column.key == heightKey) return lengthUnit();
    const FigureUnit unit = unitIn(column);
    if (unit == FigureUnit::squareMetres) return areaUnit();
    return unit == FigureUnit::squareMetreHours ? QStringLiteral("m² h") : QStringLiteral("min");
}

QString absoluteText(double value, const ScenarioColumn& column) {
    if (column.key == heightKey) return lengthNumber(value);
    const FigureUnit unit = unitIn(column);
    if (unit == FigureUnit::squareMetres) return areaNumber(value);
    if (unit == FigureUnit::share) return formatAmount(percentOfWhole * value, 0);
    if (column.work == ScenarioWork::measuringPlaces) return groupDigits(value, column.figure->shownDecimals);
    return formatAmount(value, unit == FigureUnit::squareMetreHours || column.key == changesKey ? 0 : 1);
}

}  // namespace

const std::vector<ScenarioColumn>& scenarioColumns() {
    static const std::vector<ScenarioColumn> columns = listColumns();
    return columns;
}

int scenarioColumn(std::string_view key) {
    const auto& columns = scenarioColumns();
    return int(std::ranges::find(columns, key, &ScenarioColumn::key) - columns.begin());
}

Better betterOf(const ScenarioColumn& column) {
    return column.figure ? column.figure->better : column.better;
}

QString titleOf(const ScenarioColumn& column) {
    if (!column.title)
        return QStringLiteral("%1, %2").arg(translated(column.figure->label), unitText(column));
    const QString title = ScenarioTable::tr(column.title);
    return title.contains(QStringLiteral("%1")) ? title.arg(unitText(column)) : title;
}

QString tipOf(const ScenarioColumn& column) {
    return column.tip ? ScenarioTable::tr(column.tip) : translatedSentence(column.figure->definition);
}

QString numberText(double value, const ScenarioColumn& column, bool isDifference) {
    const bool isSigned = isDifference || (column.figure && column.figure->isChange);
    if (isSigned && unitIn(column) == FigureUnit::squareMetres) return signedAreaNumber(value);
    const QString text = absoluteText(value, column);
    return isSigned ? withPlus(value, text) : text;
}

}  // namespace noonmark
