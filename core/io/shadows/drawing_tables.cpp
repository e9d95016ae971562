#include "core/io/shadows/drawing_tables.h"

#include <fmt/format.h>

#include <set>

namespace noonmark {

namespace {

using Columns = std::vector<DrawingColumn>;

const DrawingValue text = std::string(), number = 0.0, instant = Instant();

Columns sunColumns() {
    return {{"time", text}, {"utc", instant}, {"azimuth_deg", number}, {"altitude_deg", number}};
}

std::vector<DrawingValue> sunValues(const DrawnTime& time) {
    return {time.clock, time.sun.at, double(time.sun.azimuthDeg), double(time.sun.altitudeDeg)};
}

void append(std::vector<DrawingValue>& values, std::vector<DrawingValue> more) {
    values.insert(values.end(), more.begin(), more.end());
}

DrawingTable shadowTable(const ShadowDrawing& drawing) {
    DrawingTable table{"shadows", false, sunColumns(), {}};
    for (const char* name : {"kind", "area_m2", "cell_m"})
        table.columns.push_back({name, std::string_view(name) == "kind" ? text : number});
    for (const DrawnMoment& moment : drawing.moments)
        for (const auto& [kind, polygons] : listShadows(moment.outlines)) {
            if (polygons->empty()) continue;
            DrawingRow& row = table.rows.emplace_back();
            row.polygons = *polygons;
            row.values = sunValues(moment.time);
            append(row.values, {std::string(kind), area(*polygons), moment.outlines.cellM});
        }
    return table;
}

DrawingTable buildingTable(const ShadowDrawing& drawing) {
    DrawingTable table{
        "buildings",
        false,
        {{"id", text}, {"name", text}, {"state", text}, {"height_m", number}, {"bottom_m", number}},
        {}};
    for (const DrawnPart& part : drawing.buildings)
        table.rows.push_back(
            {{part.outline},
             {},
             {part.id, part.name, std::string(nameOf(part.state)), part.topM, part.bottomM}});
    return table;
}

DrawingTable placeTable(const ShadowDrawing& drawing) {
    DrawingTable table{"places", false, {{"name", text}, {"kind", text}, {"area_m2", number}}, {}};
    for (const Place& place : drawing.places)
        table.rows.push_back(
            {place.polygons, {}, {place.name, std::string(nameOf(place.kind)), area(place.polygons)}});
    return table;
}

DrawingTable fanTable(const ShadowDrawing& drawing) {
    DrawingTable table{"fan", false, {{"day", text}}, {}};
    for (DrawingColumn& column : sunColumns()) table.columns.push_back(std::move(column));
    table.columns.push_back({"area_m2", number});
    for (const DrawnFan& fan : drawing.fans)
        for (const DrawnFanStep& step : fan.steps) {
            if (step.outlines.empty()) continue;
            DrawingRow& row = table.rows.emplace_back();
            row.polygons = step.outlines;
            row.values = {fan.name};
            append(row.values, sunValues(step.time));
            append(row.values, {area(step.outlines)});
        }
    return table;
}

// In the colours of maps of shadow, a colour for each line's minutes.
LayerStyle colourLevels(const ShadowDrawing& drawing) {
    std::set<double> levels;
    for (const DrawnIsochrones& day : drawing.isochrones)
        for (const Isochrone& line : day.lines) levels.insert(line.level);
    if (levels.empty()) return {};
    const ColourScale scale = plainScale(*levels.rbegin());
    std::vector<ColourClass> classes;
    for (const double level : levels)
        classes.push_back({level, level, scale.colourOf(level), fmt::format("{:g}", level)});
    return {"Minutes in shadow", categorizedStyle(StyledShape::lines, "minutes", classes)};
}

DrawingTable isochroneTable(const ShadowDrawing& drawing) {
    DrawingTable table{
        "isochrones", true, {{"day", text}, {"minutes", number}, {"closed", number}, {"cell_m", number}}, {}};
    for (const DrawnIsochrones& day : drawing.isochrones)
        for (const Isochrone& line : day.lines)
            table.rows.push_back(
                {{}, {pointsToDraw(line)}, {day.day, line.level, line.closed ? 1.0 : 0.0, day.cellM}});
    table.style = colourLevels(drawing);
    return table;
}

DrawingTable distanceTable(const ShadowDrawing& drawing) {
    DrawingTable table{"distances", false, {{"distance_m", number}}, {}};
    for (const DrawnDistance& distance : drawing.distances)
        table.rows.push_back({distance.outlines, {}, {distance.metres}});
    return table;
}

}  // namespace

std::vector<DrawingTable> makeDrawingTables(const ShadowDrawing& drawing) {
    std::vector<DrawingTable> tables{shadowTable(drawing), buildingTable(drawing),  placeTable(drawing),
                                     fanTable(drawing),    isochroneTable(drawing), distanceTable(drawing)};
    std::erase_if(tables,
                  [](const DrawingTable& table) { return table.rows.empty() && table.name != "shadows"; });
    return tables;
}

std::vector<NamedShadow> listShadows(const ShadowOutlines& outlines) {
    return {{"baseline", &outlines.baseline},
            {"incremental", &outlines.incremental},
            {"gained", &outlines.gained}};
}

std::vector<glm::vec2> pointsToDraw(const Isochrone& line) {
    std::vector<glm::vec2> points = line.points;
    if (line.closed && !points.empty()) points.push_back(points.front());
    return points;
}

}  // namespace noonmark
