#include "app/gui/docks/contributions/contribution_sheet.h"

#include <QCoreApplication>
#include <QObject>
#include <QUuid>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/session/answers/result_rows.h"
#include "core/describe/figure_text.h"
#include "core/describe/shown_as.h"
#include "core/measures/shadow_figures.h"
#include "core/receivers/rasterize.h"

namespace noonmark {

namespace {

QString nameOf(const std::string& name, const std::string& id) {
    return QString::fromStdString(name.empty() ? id : name);
}

std::vector<const Figure*> shownFigures() {
    std::vector<const Figure*> shown;
    for (const Figure& figure : contributionFigures().rows())
        if (figure.use == FigureUse::result) shown.push_back(&figure);
    return shown;
}

// What is attributed and what is sole is defined once, in the rows of the files.
QString meaningOf(const Figure& figure) {
    const bool sole = figure.key.starts_with("sole");
    const bool attributed = figure.key.starts_with("attributed");
    const QString own = translatedSentence(figure.definition);
    if (!sole && !attributed) return own;
    return own + QStringLiteral(".\n") +
           QObject::tr("%1: %2", "a term and its definition")
               .arg(translated(sole ? "Sole contribution" : "Attributed shadow"),
                    translated(sole ? soleDefinition() : attributedDefinition()));
}

std::vector<ContributionColumn> columnsOfStudy() {
    std::vector<ContributionColumn> columns;
    for (const Figure* figure : shownFigures())
        columns.push_back({headingOf(*figure).replace(QStringLiteral(" x "), QStringLiteral(" × ")),
                           meaningOf(*figure), figure->unit, figure->shownDecimals});
    return columns;
}

ContributionRow makeRow(const Contribution& one, const QString& name,
                        std::shared_ptr<const Building> building) {
    ContributionRow row{.name = name, .building = std::move(building), .share = one.share};
    for (const Figure* figure : shownFigures()) row.values.push_back(figure->get(&one));
    return row;
}

ContributionRow makeTreeRow(const Contribution& one) {
    ContributionRow row = makeRow(one, nameOfTree(one), nullptr);
    row.tree = one.id;
    return row;
}

QString describeDirection(const glm::dvec2& by) {
    static constexpr std::array winds{QT_TRANSLATE_NOOP("noonmark::Contributions", "E"),
                                      QT_TRANSLATE_NOOP("noonmark::Contributions", "NE"),
                                      QT_TRANSLATE_NOOP("noonmark::Contributions", "N"),
                                      QT_TRANSLATE_NOOP("noonmark::Contributions", "NW"),
                                      QT_TRANSLATE_NOOP("noonmark::Contributions", "W"),
                                      QT_TRANSLATE_NOOP("noonmark::Contributions", "SW"),
                                      QT_TRANSLATE_NOOP("noonmark::Contributions", "S"),
                                      QT_TRANSLATE_NOOP("noonmark::Contributions", "SE")};
    const double eighths = std::atan2(by.y, by.x) / (2 * std::numbers::pi) * winds.size();
    const auto at = std::size_t(std::lround(eighths) + std::ptrdiff_t(winds.size())) % winds.size();
    return QCoreApplication::translate("noonmark::Contributions", winds[at]);
}

// "23 m high, 120 m NE": in metres and tens of metres, which tell buildings apart at sight.
QString describeUnnamed(const Building& building, const City& city, const std::optional<glm::dvec2>& from) {
    const Box2 box = bounds(building);
    const glm::dvec2 middle = (glm::dvec2(box.low) + glm::dvec2(box.high)) * 0.5;
    const QString height = describeLength(double(topM(building) - groundAt(city, middle)), 0);
    if (!from) return QObject::tr("%1 high").arg(height);
    constexpr double roundedM = 10;
    const double awayM = std::round(glm::distance(middle, *from) / roundedM) * roundedM;
    return QObject::tr("%1 high, %2 %3", "a building: its height, how far it is, in which direction")
        .arg(height, describeLength(awayM, 0), describeDirection(middle - *from));
}

// `building`: null where it no longer stands.
ContributionRow makeBuildingRow(const Contribution& one, std::shared_ptr<const Building> building,
                                const City& city, const ContributionView& view) {
    if (isReadableName(one.name) || !building)
        return makeRow(one, nameOf(one.name, one.id), std::move(building));
    ContributionRow row = makeRow(one, describeUnnamed(*building, city, view.from), building);
    row.isDescribed = true;
    return row;
}

ContributionRow makeRow(const Contribution& one, const City& city, const ContributionView& view) {
    if (!one.building) return makeRow(one, QObject::tr("Terrain"), nullptr);
    return makeBuildingRow(one, city.buildings[*one.building], city, view);
}

// Small amounts with two significant digits: much of a park may have hardly any shadow.
QString describeNumber(double number) {
    return std::abs(number) < 1 ? formatShort(number, 2) : formatAmount(number);
}

QString percentOf(double share) { return describeNumber(100 * share); }

// Without the sunlit time sun cannot be told from shadow.
QString describeTime(double minutesADay, double sunlitMin, ShownAs show) {
    if (!(sunlitMin > 0)) return QObject::tr("%1 min a day in shadow").arg(describeNumber(minutesADay));
    const double sunMin = std::max(0.0, sunlitMin - minutesADay);
    if (show != ShownAs::shadow)
        return QObject::tr("%1 h of sun a day, %2 % of the sunlit time")
            .arg(formatAmount(sunMin / minutesPerHour, 2), percentOf(sunMin / sunlitMin));
    return QObject::tr("%1 min a day in shadow, %2 % of the sunlit time")
        .arg(describeNumber(minutesADay), percentOf(minutesADay / sunlitMin));
}

QString wordsFor(const ContributionRow& row) {
    return row.isDescribed ? QObject::tr("a building %1", "23 m high, 120 m NE").arg(row.name) : row.name;
}

// Buildings that the city no longer has count, too.
QString describeLargest(const std::vector<ContributionRow>& rows, const std::vector<Contribution>& of) {
    const auto buildings =
        std::ranges::count_if(of, [](const Contribution& one) { return !one.isTree && one.id != terrainId; });
    return QObject::tr("%1 building(s) shade it; %2 takes the most, %3 %", "",
                       pluralNumber(quint64(buildings)))
        .arg(formatCount(quint64(buildings)), wordsFor(rows.front()), percentOf(rows.front().share));
}

/// What all rows of a list take.
struct SumOfRows {
    double allMin = 0, withoutTreesMin = 0;  ///< a day, mean over the cells
    std::size_t trees = 0;
};

SumOfRows sumUp(const std::vector<Contribution>& rows) {
    SumOfRows sum;
    for (const Contribution& row : rows) {
        sum.allMin += row.attributedMin;
        if (row.isTree)
            ++sum.trees;
        else
            sum.withoutTreesMin += row.attributedMin;
    }
    return sum;
}

// "284 min a day in shadow, 30 % of the sunlit time (trees with their seasons); 197 min ... (without trees)."
QString describeTimes(const SumOfRows& sum, double sunlitMin, ShownAs show, TreeColumns trees) {
    const auto of = [&](double minutes, TreeColumns column) {
        return QObject::tr("%1 (%2)", "time in shadow, which trees are counted")
            .arg(describeTime(minutes, sunlitMin, show), translated(describeTrees(column)));
    };
    return QStringLiteral("%1; %2").arg(of(sum.allMin, trees), of(sum.withoutTreesMin, TreeColumns::without));
}

QString describeTreeSum(const SumOfRows& sum) {
    return QObject::tr("%1 tree(s) take sun from it, %2 % of the shadow.", "",
                       pluralNumber(quint64(sum.trees)))
        .arg(formatCount(quint64(sum.trees)), percentOf(1 - sum.withoutTreesMin / sum.allMin));
}

QString describeSum(const ContributionSheet& sheet, const std::vector<Contribution>& rows, double sunlitMin,
                    const ContributionView& view) {
    if (rows.empty()) return QObject::tr("No building shades it in the period.");
    const SumOfRows sum = sumUp(rows);
    if (sum.trees == 0)
        return QStringLiteral("%1. %2.").arg(describeTime(sum.allMin, sunlitMin, view.show),
                                             describeLargest(sheet.rows, rows));
    const QString buildings = sum.trees == rows.size() ? QObject::tr("No building shades it in the period.")
                                                       : describeLargest(sheet.rows, rows) + QLatin1Char('.');
    return QStringLiteral("%1. %2 %3")
        .arg(describeTimes(sum, sunlitMin, view.show, view.trees), buildings, describeTreeSum(sum));
}

// Rows and headline. `rowOf`: of a building or the terrain.
template <class RowOf>
void fillSheet(ContributionSheet& sheet, const std::vector<Contribution>& buildings,
               const std::vector<TreeContribution>& trees, double sunlitMin, ContributionView view,
               const RowOf& rowOf) {
    view.trees = chooseRankedColumn(trees, view.trees);
    const std::vector<Contribution> rows =
        trees.empty() ? buildings : rankWithTrees(buildings, trees, view.trees);
    for (const Contribution& one : rows) sheet.rows.push_back(one.isTree ? makeTreeRow(one) : rowOf(one));
    sheet.areTreesListed = !trees.empty();
    sheet.headline = describeSum(sheet, rows, sunlitMin, view);
}

/// The change over the cells of a place, or of the whole region.
struct CellChanges {
    double sumMin = 0;  ///< a day, over the cells
    std::size_t cells = 0;
};

CellChanges sumUpChanges(const Impact& impact, const Place* place) {
    CellChanges sum;
    const auto add = [&](std::size_t cell) {
        const float change = impact.grossMin[cell];
        if (std::isnan(change)) return;
        sum.sumMin += double(change);
        ++sum.cells;
    };
    if (place != nullptr)
        for (const std::uint32_t cell : collectCells(place->polygons, impact.grid)) add(cell);
    else
        for (std::size_t cell = 0; cell < impact.grossMin.size(); ++cell) add(cell);
    return sum;
}

std::vector<ContributionColumn> columnsOfComparison() {
    const QString alone = QObject::tr(
        "The scenario minus the scenario without this building: what it adds alone, on ground that is open "
        "in "
        "both scenarios");
    return {{QObject::tr("Share, %"), QObject::tr("Share of the sum of what each new building adds alone"),
             FigureUnit::share, 1},
            {QObject::tr("Adds, min a day"), alone + QObject::tr("; mean over the cells"),
             FigureUnit::minutesADay, 2},
            {QObject::tr("Adds a day"), alone + QObject::tr("; area × hours a day"),
             FigureUnit::squareMetreHours, 1}};
}

std::shared_ptr<const Building> recordedBuilding(const City& city, const std::string& id) {
    const auto found = std::ranges::find(city.buildings, id, [](const auto& one) { return one->sourceId; });
    return found == city.buildings.end() ? nullptr : *found;
}

// Of a saved study, whose buildings have no index.
bool isTerrain(const Contribution& one) { return one.id == terrainId; }

ContributionRow makeRecordedRow(const Contribution& one, const City& city, const ContributionView& view) {
    if (isTerrain(one)) return makeRow(one, QObject::tr("Terrain"), nullptr);
    return makeBuildingRow(one, recordedBuilding(city, one.id), city, view);
}

QString describeChange(const ImpactAnswer& answer, double meanMin, std::size_t cells, ShownAs show) {
    const bool isSun = show != ShownAs::shadow;
    const double shown = isSun ? -meanMin : meanMin;
    const QString text =
        isSun ? QObject::tr("%1 compared with %2: %3 min of sun a day, mean over %4 cell(s).", "",
                            pluralNumber(cells))
              : QObject::tr("%1 compared with %2: %3 min a day in shadow, mean over %4 cell(s).", "",
                            pluralNumber(cells));
    return text.arg(scenarioName(answer.to), scenarioName(answer.from),
                    withPlus(shown, formatAmount(shown, 2)), formatCount(cells));
}

// Shares of the sum of what is added; a building that takes shadow away has none.
void shareOut(ContributionSheet& sheet) {
    double added = 0;
    for (const ContributionRow& row : sheet.rows) added += std::max(0.0, row.values.back());
    for (ContributionRow& row : sheet.rows)
        row.values.front() = row.share = added > 0 ? std::max(0.0, row.values.back()) / added : 0;
    std::ranges::stable_sort(sheet.rows, std::ranges::greater{}, &ContributionRow::share);
}

}  // namespace

ContributionSheet makeContributionSheet(const Study& study, const ShadowBreakdown& breakdown,
                                        const std::vector<Contribution>& rows, const ContributionView& view,
                                        const std::vector<TreeContribution>& trees) {
    ContributionSheet sheet{.columns = columnsOfStudy()};
    fillSheet(sheet, rows, trees, study.field.sunlitMinutesPerDay, view,
              [&](const Contribution& one) { return makeRow(one, study.city, view); });
    sheet.method = QString::fromStdString(breakdown.engine);
    sheet.months = makeMonthBars(study);
    return sheet;
}

ContributionSheet makeContributionSheet(const Study& study, const PlaceContributions& of,
                                        const ContributionView& view) {
    ContributionSheet sheet = makeContributionSheet(study, of.breakdown, of.rows, view, of.trees);
    sheet.months = makeMonthBars(of.breakdown, study.sun);
    const double cellDays = double(of.cells) * of.breakdown.grid.cellAreaM2() * double(of.days);
    const QString itself = describeTime(of.studyMinM2 / cellDays, study.field.sunlitMinutesPerDay, view.show);
    sheet.note = QObject::tr("%1 cell(s); in the study itself %2.", "", pluralNumber(of.cells))
                     .arg(formatCount(of.cells), itself) +
                 QLatin1Char(' ') + periodText(of.period);
    sheet.method =
        QObject::tr("Attributed by: %1\nThe study: %2")
            .arg(QString::fromStdString(of.breakdown.engine), QString::fromStdString(study.field.engine));
    return sheet;
}

ContributionSheet makeContributionSheet(const SavedStudy& study, const City& city,
                                        const ContributionView& view) {
    ContributionSheet sheet{.columns = columnsOfStudy()};
    fillSheet(sheet, *study.contributions, study.trees, study.field.sunlitMinutesPerDay, view,
              [&](const Contribution& one) { return makeRecordedRow(one, city, view); });
    sheet.method = QString::fromStdString(study.field.engine);
    sheet.months = makeMonthBars(study.months, study.start, study.field.days);
    return sheet;
}

ContributionSheet makeContributionSheet(const ContributionTable& of, const City& city,
                                        const ContributionView& view) {
    ContributionSheet sheet{.columns = columnsOfStudy()};
    fillSheet(sheet, of.rows, of.trees, of.sunlitMinutesPerDay, view,
              [&](const Contribution& one) { return makeRecordedRow(one, city, view); });
    sheet.note = QObject::tr("%1 cell(s)", "", pluralNumber(of.cells)).arg(formatCount(of.cells));
    if (const QString period = periodText(of.period); !period.isEmpty())
        sheet.note += QStringLiteral("; ") + period;
    sheet.method = QObject::tr("Attributed by: %1").arg(QString::fromStdString(of.engine));
    return sheet;
}

ContributionSheet makeContributionSheet(const ImpactAnswer& answer, const City& after, const Place* place,
                                        ShownAs show) {
    ContributionSheet sheet{.columns = columnsOfComparison()};
    for (const BuildingImpact& one : answer.study.byBuilding) {
        const CellChanges sum = sumUpChanges(one.impact, place);
        const double mean = sum.cells > 0 ? sum.sumMin / double(sum.cells) : 0;
        sheet.rows.push_back({nameOf(one.name, one.id),
                              recordedBuilding(after, one.id),
                              0,
                              {0, mean, sum.sumMin * one.impact.grid.cellAreaM2() / minutesPerHour},
                              {}});
    }
    shareOut(sheet);
    const CellChanges all = sumUpChanges(answer.study.total, place);
    const double mean = all.cells > 0 ? all.sumMin / double(all.cells) : 0;
    sheet.headline = describeChange(answer, mean, all.cells, show);
    sheet.method = QString::fromStdString(answer.study.total.engine);
    return sheet;
}

// Numbers of registers are long words with digits among their letters.
bool isReadableName(const std::string& name) {
    if (name.empty()) return false;
    if (!QUuid::fromString(QString::fromStdString(name)).isNull()) return false;
    constexpr std::size_t lettersOfIfc = 22;  // of a GUID in base 64
    const bool isOneWord = name.find(' ') == name.npos;
    const auto digits = std::ranges::count_if(name, [](unsigned char c) { return std::isdigit(c) != 0; });
    return !isOneWord || name.size() < lettersOfIfc || digits == 0;
}

std::size_t classOf(double share) {
    std::size_t i = 0;
    while (i + 1 < contributionClasses.size() && share >= contributionClasses[i + 1].from) ++i;
    return i;
}

QString describeClass(std::size_t i) {
    const auto percent = [](std::size_t at) { return formatAmount(100 * contributionClasses[at].from); };
    if (i == 0) return QObject::tr("< %1 %").arg(percent(1));
    if (i + 1 == contributionClasses.size()) return QObject::tr("≥ %1 %").arg(percent(i));
    return QObject::tr("%1-%2 %", "from and to, per cent").arg(percent(i), percent(i + 1));
}

}  // namespace noonmark
