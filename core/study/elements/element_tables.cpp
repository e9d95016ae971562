#include "core/study/elements/element_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/csv_text.h"
#include "core/geo/earth_drop.h"

namespace noonmark {

namespace {

std::vector<unsigned> monthsIn(const ElementMap& map) {
    std::vector<unsigned> months;
    for (unsigned month = 1; month <= 12; ++month)
        if (!map.elements.empty() && !std::isnan(map.elements.front().monthMin[month - 1]))
            months.push_back(month);
    return months;
}

std::vector<ElementColumn> columnsOf(const std::vector<unsigned>& months) {
    const std::string text;
    std::vector<ElementColumn> columns{{"id", text},
                                       {"kind", text},
                                       {"building", text},
                                       {"building_name", text},
                                       {"floor", std::int64_t(0)},
                                       {"azimuth_deg", 0.0},
                                       {"lon_deg", 0.0},
                                       {"lat_deg", 0.0},
                                       {"elevation_m", 0.0},
                                       {"above_ground_m", 0.0},
                                       {"sunlit_min", 0.0},
                                       {"sunlit_pct", 0.0},
                                       {"gross_min", 0.0},
                                       {"continuous_min", 0.0},
                                       {"longest_sun_min", 0.0}};
    for (const unsigned month : months) columns.push_back({fmt::format("sunlit_min_{:02}", month), 0.0});
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
        addMinutes(element, row);
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

    void addMinutes(const MeasuredElement& element, std::vector<ElementValue>& row) const {
        row.insert(row.end(), {element.sunlitMin, 100 * element.sunlitMin / map_.possibleMin,
                               element.grossMin, element.continuousMin, element.longestSunMin});
        for (const unsigned month : months_) row.emplace_back(element.monthMin[month - 1]);
    }

    const ElementMap& map_;
    const City& city_;
    const SourceValues& source_;
    std::vector<unsigned> months_;
};

// Degrees of places need more digits than metres and minutes.
void addValue(CsvText& csv, const ElementValue& value, const std::string& column) {
    const bool isPlace = column == "lon_deg" || column == "lat_deg";
    if (const auto* text = std::get_if<std::string>(&value))
        csv.text(*text);
    else if (const auto* whole = std::get_if<std::int64_t>(&value))
        csv.whole(*whole);
    else if (const auto* number = std::get_if<double>(&value))
        csv.number(*number, isPlace ? 8 : 3);
    else
        csv.nothing();
}

}  // namespace

ElementTable makeElementTable(const ElementMap& map, const City& city, const SourceValues& source) {
    const std::vector<unsigned> months = monthsIn(map);
    ElementTable table{.columns = columnsOf(months)};
    const ElementRows rows(map, city, source, months);
    for (const MeasuredElement& element : map.elements) rows.add(element, table);
    return table;
}

ElementTable makeElementTable(const ElementStudy& study) {
    return makeElementTable(makeElementMap(study), study.city, sourceValues(study.provenance));
}

std::string toCsv(const ElementTable& table) {
    std::vector<std::string> columns;
    for (const ElementColumn& column : table.columns) columns.push_back(column.name);
    CsvText csv(columns);
    for (const auto& row : table.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) addValue(csv, row[i], columns[i]);
        csv.endRow();
    }
    return csv.take();
}

ElementFigures computeFigures(const ElementStudy& study) {
    ElementFigures figures{.leastSunlitMin = 1e30};
    const auto count = double(study.receivers.size());
    for (std::size_t point = 0; point < study.receivers.size(); ++point) {
        const double sunlit = study.minutes.sunlitOf(point) / double(study.sun.dayCount());
        const auto run = double(study.minutes.longestShadowMin[point]);
        figures.meanSunlitMin += sunlit / count;
        figures.leastSunlitMin = std::min(figures.leastSunlitMin, sunlit);
        figures.mostSunlitMin = std::max(figures.mostSunlitMin, sunlit);
        figures.meanContinuousMin += run / count;
        figures.mostContinuousMin = std::max(figures.mostContinuousMin, run);
    }
    return figures;
}

}  // namespace noonmark
