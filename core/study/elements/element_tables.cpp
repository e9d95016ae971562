#include "core/study/elements/element_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/base/csv_text.h"
#include "core/describe/shown_as.h"
#include "core/describe/text.h"
#include "core/geo/frame.h"
#include "core/measures/shadow_figures.h"
#include "core/measures/statistics.h"

namespace noonmark {

namespace {

std::vector<unsigned> monthsIn(const ElementMap& map) {
    std::vector<unsigned> months;
    for (unsigned month = 1; month <= 12; ++month)
        if (!map.elements.empty() && !std::isnan(map.elements.front().monthMin[month - 1]))
            months.push_back(month);
    return months;
}

// `rows`: without trees or with them; `suffix`: of the columns of months.
void addColumns(std::vector<ElementColumn>& columns, std::span<const Figure> rows,
                const std::vector<unsigned>& months, const std::string& suffix) {
    for (const Figure& figure : rows) columns.push_back({std::string(figure.key), 0.0, figure.decimals});
    for (const unsigned month : months)
        columns.push_back({fmt::format("sunlit_min_{:02}{}", month, suffix), 0.0});
}

std::vector<ElementColumn> columnsOf(const ElementMap& map, const std::vector<unsigned>& months) {
    const std::string text;
    std::vector<ElementColumn> columns{{"id", text},
                                       {"kind", text},
                                       {"building", text},
                                       {"building_name", text},
                                       {"floor", std::int64_t(0)},
                                       {"azimuth_deg", 0.0},
                                       {"lon_deg", 0.0, placeDecimals},
                                       {"lat_deg", 0.0, placeDecimals},
                                       {"elevation_m", 0.0},
                                       {"above_ground_m", 0.0}};
    addColumns(columns, pointFigures().rows(), months, {});
    if (!map.elements.empty())
        for (const ShadedMinutes& with : map.elements.front().withTrees)
            addColumns(columns, pointFiguresWithTrees(with.column), months, suffixOf(with.column));
    for (const char* name : sourceColumnNames) columns.push_back({name, text});
    return columns;
}

/// Makes the rows of a map.
class ElementRows {
public:
    ElementRows(const ElementMap& map, const City& city, const SourceValues& source,
                std::vector<unsigned> months)
        : map_(map), city_(city), source_(source), months_(std::move(months)) {}

    void add(const MeasuredElement& element, ElementTable& table) const {
        const glm::dvec3 position(element.position);
        const LonLat place = city_.frame.lonLatFromLocal(glm::dvec2(position));
        const double drop = city_.terrain ? earthDropM(glm::dvec2(position)) : 0;
        const double elevation = position.z + city_.frame.originElevationM() + drop;
        std::vector<ElementValue> row = elementValues(element);
        row.insert(row.end(), {element.azimuthDeg, place.lonDeg, place.latDeg, elevation,
                               position.z - double(groundAt(city_, glm::dvec2(position)))});
        addMinutes(element, pointFigures().rows(), row);
        for (const ShadedMinutes& with : element.withTrees)
            addMinutes(with, pointFiguresWithTrees(with.column), row);
        for (const std::string& value : source_) row.emplace_back(value);
        table.rows.push_back(std::move(row));
        table.places.emplace_back(place.lonDeg, place.latDeg, elevation);
    }

private:
    [[nodiscard]] static std::vector<ElementValue> elementValues(const MeasuredElement& element) {
        std::vector<ElementValue> row{element.id, std::string(nameOf(element.kind))};
        if (element.building.empty() && element.buildingName.empty())
            row.insert(row.end(), {ElementValue(), ElementValue()});
        else
            row.insert(row.end(), {element.building, element.buildingName});
        row.push_back(element.floor ? ElementValue(std::int64_t(*element.floor)) : ElementValue());
        return row;
    }

    void addMinutes(const ElementMinutes& minutes, std::span<const Figure> figures,
                    std::vector<ElementValue>& row) const {
        const MapPoint point{&minutes, map_.possibleMin};
        for (const Figure& figure : figures) row.emplace_back(figure.get(&point));
        for (const unsigned month : months_) row.emplace_back(minutes.monthMin[month - 1]);
    }

    const ElementMap& map_;
    const City& city_;
    const SourceValues& source_;
    std::vector<unsigned> months_;
};

void addValue(CsvText& csv, const ElementValue& value, int decimals) {
    if (const auto* text = std::get_if<std::string>(&value))
        csv.text(*text);
    else if (const auto* whole = std::get_if<std::int64_t>(&value))
        csv.whole(*whole);
    else if (const auto* number = std::get_if<double>(&value))
        csv.number(*number, decimals);
    else
        csv.nothing();
}

}  // namespace

ElementTable makeElementTable(const ElementMap& map, const City& city, const SourceValues& source) {
    const std::vector<unsigned> months = monthsIn(map);
    ElementTable table{.columns = columnsOf(map, months)};
    const ElementRows rows(map, city, source, months);
    for (const MeasuredElement& element : map.elements) rows.add(element, table);
    return table;
}

ElementTable makeElementTable(const ElementStudy& study) {
    return makeElementTable(makeElementMap(study), study.city, sourceValues(study.provenance));
}

LayerStyle makeStyle(const ColourScale& scale, const std::string& suffix) {
    const ShownAs as = scale.quantity.as;
    const char* column = as == ShownAs::sun     ? "sunlit_min"
                         : as == ShownAs::share ? "sunlit_pct"
                                                : "gross_min";
    return {std::string(scale.quantity.title()),
            graduatedStyle(StyledShape::points, column + suffix,
                           styleClasses(scale, as == ShownAs::sun ? minutesPerHour : 1))};
}

std::string toCsv(const ElementTable& table) {
    std::vector<std::string> columns;
    for (const ElementColumn& column : table.columns) columns.push_back(column.name);
    CsvText csv(columns);
    for (const auto& row : table.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) addValue(csv, row[i], table.columns[i].decimals);
        csv.endRow();
    }
    return csv.take();
}

namespace {

ElementFigures sumUpPoints(const ElementStudy& study, const PointMonths& minutes) {
    ElementFigures figures{.points = study.receivers.size(), .minSunlitMin = 1e30};
    figures.possibleMin = minutes.possibleMin / double(study.sun.dayCount());
    const auto count = double(study.receivers.size());
    for (std::size_t point = 0; point < study.receivers.size(); ++point) {
        const double sunlit = minutes.sunlitOf(point) / double(study.sun.dayCount());
        const auto run = double(minutes.longestShadowMin[point]);
        figures.meanSunlitMin += sunlit / count;
        figures.minSunlitMin = std::min(figures.minSunlitMin, sunlit);
        figures.maxSunlitMin = std::max(figures.maxSunlitMin, sunlit);
        figures.meanContinuousMin += run / count;
        figures.maxContinuousMin = std::max(figures.maxContinuousMin, run);
    }
    figures.meanGrossMin = figures.possibleMin - figures.meanSunlitMin;
    return figures;
}

}  // namespace

ElementFigures computeFigures(const ElementStudy& study) { return sumUpPoints(study, study.minutes); }

std::vector<ShadedElementFigures> listFiguresWithTrees(const ElementStudy& study) {
    std::vector<ShadedElementFigures> all;
    if (!study.trees) return all;
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal})
        if (const auto& minutes = study.trees->of(column))
            all.push_back({column, sumUpPoints(study, *minutes)});
    return all;
}

std::vector<FigureLine> listElementLines(const ElementFigures& figures,
                                         std::span<const ShadedElementFigures> withTrees,
                                         FigureContext context) {
    context.sunlitMin = figures.possibleMin;
    std::vector<FigureLine> lines = listLines(elementFigures().of(figures), context);
    for (const ShadedElementFigures& with : withTrees)
        std::ranges::move(listLines({elementFiguresWithTrees(with.column), &with.figures}, context),
                          std::back_inserter(lines));
    return lines;
}

AnswerPage makePage(const ElementMap& map, const ElementFigures& figures) {
    const auto hours = [](double minutes) { return Amount{minutes, FigureUnit::hours}; };
    std::vector<double> sunMin;
    for (const MeasuredElement& element : map.elements) sunMin.push_back(element.sunlitMin);
    return {{NM_TEXT("%1 of sun a day on average at %2 points"),
             {hours(figures.meanSunlitMin), Amount{double(figures.points), FigureUnit::none, 0}}},
            {{NM_TEXT("The darkest point gets %1, the sunniest %2, of %3 a day with the sun up."),
              {hours(figures.minSunlitMin), hours(figures.maxSunlitMin), hours(figures.possibleMin)}}},
            {makeSunHistogram(sunMin, map.possibleMin, NM_TEXT("Share of the points, %"))}};
}

const Figures<ElementFigures>& elementFigures() {
    static const Figures<ElementFigures> figures{
        figure(&ElementFigures::points, {.key = "receivers",
                                         .label = NM_TEXT("Points"),
                                         .definition = NM_TEXT("points where sun is measured"),
                                         .use = FigureUse::basis}),
        figure(&ElementFigures::possibleMin,
               {.key = "sunlit_min_per_day",
                .label = NM_TEXT("Sunlit time"),
                .definition = NM_TEXT("mean minutes a day with the sun above the horizon: 100 % of the time"),
                .unit = FigureUnit::minutesADay,
                .use = FigureUse::basis}),
        figure(&ElementFigures::meanSunlitMin,
               {.key = "mean_sunlit_min",
                .label = NM_TEXT("Mean sun"),
                .definition = NM_TEXT("time in the sun per day, mean over days and points"),
                .unit = FigureUnit::hoursADay,
                .whole = Whole::sunlitTime,
                .shownDecimals = 2}),
        figure(&ElementFigures::minSunlitMin,
               {.key = "min_sunlit_min",
                .label = NM_TEXT("Least sun"),
                .definition = NM_TEXT("time in the sun per day at the darkest point"),
                .unit = FigureUnit::hoursADay,
                .whole = Whole::sunlitTime,
                .shownDecimals = 2}),
        figure(&ElementFigures::maxSunlitMin,
               {.key = "max_sunlit_min",
                .label = NM_TEXT("Most sun"),
                .definition = NM_TEXT("time in the sun per day at the sunniest point"),
                .unit = FigureUnit::hoursADay,
                .whole = Whole::sunlitTime,
                .shownDecimals = 2}),
        figure(&ElementFigures::meanGrossMin,
               {.key = "mean_gross_min",
                .label = NM_TEXT("Mean gross"),
                .definition = NM_TEXT("minutes in shadow per day, mean over days and points; a point that "
                                      "faces away from the sun is in shadow"),
                .valueIfMissing = std::nan(""),
                .unit = FigureUnit::minutesADay,
                .whole = Whole::sunlitTime,
                .shownWith = ShownWith::shadow}),
        figure(&ElementFigures::meanContinuousMin,
               {.key = "mean_continuous_min",
                .label = NM_TEXT("Mean continuous"),
                .definition = NM_TEXT("longest unbroken run in shadow on any day, mean over the points"),
                .unit = FigureUnit::minutes}),
        figure(&ElementFigures::maxContinuousMin,
               {.key = "max_continuous_min",
                .label = NM_TEXT("Max continuous"),
                .definition = NM_TEXT("longest unbroken run in shadow at any point on any day"),
                .unit = FigureUnit::minutes}),
    };
    return figures;
}

std::span<const Figure> elementFiguresWithTrees(TreeColumns column) {
    static const FiguresWithTrees evergreen(elementFigures().rows(), TreeColumns::evergreen);
    static const FiguresWithTrees seasonal(elementFigures().rows(), TreeColumns::seasonal);
    return (column == TreeColumns::evergreen ? evergreen : seasonal).rows();
}

std::span<const Figure> pointFiguresWithTrees(TreeColumns column) {
    static const FiguresWithTrees evergreen(pointFigures().rows(), TreeColumns::evergreen);
    static const FiguresWithTrees seasonal(pointFigures().rows(), TreeColumns::seasonal);
    return (column == TreeColumns::evergreen ? evergreen : seasonal).rows();
}

// Minutes are sums of steps that count a hair more or less than whole minutes: 179 of them are 179.00, and
// not 178.999.
const Figures<MapPoint>& pointFigures() {
    using Point = const MapPoint&;
    static const Figures<MapPoint> figures{
        derivedFigure<MapPoint>(
            [](Point point) { return point.minutes->sunlitMin; },
            {.key = "sunlit_min",
             .label = NM_TEXT("Sun"),
             .definition = NM_TEXT("minutes per day that a point is in the sun, mean over the days"),
             .decimals = 2,
             .unit = FigureUnit::hoursADay,
             .shownDecimals = 2}),
        derivedFigure<MapPoint>(
            [](Point point) { return 100 * point.minutes->sunlitMin / point.possibleMin; },
            {.key = "sunlit_pct",
             .label = NM_TEXT("Share of time"),
             .definition = NM_TEXT("sun, of the time with the sun above the horizon"),
             .decimals = 3,
             .unit = FigureUnit::percent}),
        derivedFigure<MapPoint>(
            [](Point point) { return point.minutes->grossMin; },
            {.key = "gross_min",
             .label = NM_TEXT("Gross"),
             .definition = NM_TEXT("minutes in shadow per day, mean over the days; a point "
                                   "that faces away from the sun is in shadow"),
             .decimals = 2,
             .unit = FigureUnit::minutesADay}),
        derivedFigure<MapPoint>([](Point point) { return point.minutes->continuousMin; },
                                {.key = "continuous_min",
                                 .label = NM_TEXT("Continuous"),
                                 .definition = NM_TEXT("longest unbroken run in shadow on any day"),
                                 .decimals = 2,
                                 .unit = FigureUnit::minutes}),
        derivedFigure<MapPoint>([](Point point) { return point.minutes->longestSunMin; },
                                {.key = "longest_sun_min",
                                 .label = NM_TEXT("Longest sun"),
                                 .definition = NM_TEXT("longest unbroken run in the sun on any day"),
                                 .decimals = 2,
                                 .unit = FigureUnit::hours,
                                 .shownDecimals = 2}),
    };
    return figures;
}

}  // namespace noonmark
