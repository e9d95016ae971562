#include "core/study/elements/element_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/csv_field.h"
#include "core/geo/earth_drop.h"
#include "core/study/elements/facing_azimuth.h"
#include "core/study/provenance/source_columns.h"

namespace noonmark {

namespace {

std::set<unsigned> monthsIn(const SunSteps& sun) {
    std::set<unsigned> months;
    for (const SunDay& day : sun.days) months.insert(unsigned(day.date.month()));
    return months;
}

std::vector<ElementColumn> columnsOf(const ElementStudy& study) {
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
    for (const unsigned month : monthsIn(study.sun))
        columns.push_back({fmt::format("sunlit_min_{:02}", month), 0.0});
    for (const char* name : sourceColumnNames) columns.push_back({name, text});
    return columns;
}

/// Makes the rows of a study.
class ElementRows {
public:
    explicit ElementRows(const ElementStudy& study)
        : study_(study), months_(monthsIn(study.sun)), source_(sourceValues(study.provenance)) {}

    void add(std::size_t point, ElementTable& table) const {
        const glm::dvec3 position(study_.receivers.points.positions[point]);
        const LonLat place = study_.city.frame.lonLatFromLocal(glm::dvec2(position));
        const double drop = study_.city.terrain ? earthDropM(glm::dvec2(position)) : 0;
        const double elevation = position.z + study_.city.frame.originElevationM() + drop;
        std::vector<ElementValue> row = elementValues(point);
        row.insert(
            row.end(),
            {facingAzimuthDeg(study_.city.frame, place, study_.receivers.points.normals[point]), place.lonDeg,
             place.latDeg, elevation, position.z - double(groundAt(study_.city, glm::dvec2(position)))});
        addMinutes(point, row);
        for (const std::string& value : source_) row.emplace_back(value);
        table.rows.push_back(std::move(row));
        table.places.emplace_back(place.lonDeg, place.latDeg, elevation);
    }

private:
    [[nodiscard]] std::vector<ElementValue> elementValues(std::size_t point) const {
        const PointElement& element = study_.receivers.elements[point];
        std::vector<ElementValue> row{element.id, std::string(nameOf(element.kind))};
        if (element.building < study_.city.buildings.size()) {
            const Building& building = *study_.city.buildings[element.building];
            row.insert(row.end(), {building.sourceId, building.name});
        } else {
            row.insert(row.end(), {ElementValue(), ElementValue()});
        }
        row.push_back(element.kind == ElementKind::plane ? ElementValue() : std::int64_t(element.floor));
        return row;
    }

    void addMinutes(std::size_t point, std::vector<ElementValue>& row) const {
        const PointMonths& minutes = study_.minutes;
        const double sunlit = minutes.sunlitOf(point);
        row.insert(row.end(), {sunlit / double(study_.sun.dayCount()), 100 * sunlit / minutes.possibleMin,
                               study_.grossMin(point), double(minutes.longestShadowMin[point]),
                               double(minutes.longestSunMin[point])});
        for (const unsigned month : months_) row.emplace_back(double(minutes.sunlitMin[point][month - 1]));
    }

    const ElementStudy& study_;
    std::set<unsigned> months_;
    std::array<std::string, sourceColumnNames.size()> source_;
};

// Degrees of places need more digits than metres and minutes.
std::string textOf(const ElementValue& value, const std::string& column) {
    if (const auto* text = std::get_if<std::string>(&value)) return csvField(*text);
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return fmt::to_string(*whole);
    const auto* number = std::get_if<double>(&value);
    if (number == nullptr || !std::isfinite(*number)) return {};
    return column == "lon_deg" || column == "lat_deg" ? fmt::format("{:.8f}", *number)
                                                      : fmt::format("{:.3f}", *number);
}

}  // namespace

ElementTable makeElementTable(const ElementStudy& study) {
    ElementTable table{.columns = columnsOf(study)};
    const ElementRows rows(study);
    for (std::size_t point = 0; point < study.receivers.size(); ++point) rows.add(point, table);
    return table;
}

std::string toCsv(const ElementTable& table) {
    std::string csv;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        csv += table.columns[i].name;
        csv += i + 1 < table.columns.size() ? ',' : '\n';
    }
    for (const auto& row : table.rows)
        for (std::size_t i = 0; i < row.size(); ++i) {
            csv += textOf(row[i], table.columns[i].name);
            csv += i + 1 < row.size() ? ',' : '\n';
        }
    return csv;
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
