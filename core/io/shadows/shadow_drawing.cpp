#include "core/io/shadows/shadow_drawing.h"

#include <fmt/format.h>
#include <algorithm>
#include <set>

#include "core/city/terrain/building_ground.h"
#include "core/measures/places/place_run.h"
#include "core/sun/day_clock.h"

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

namespace {

bool meet(const Box2& a, const Box2& b) {
    return !a.empty() && a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y &&
           b.low.y <= a.high.y;
}

}  // namespace

std::string_view nameOf(BuildingState state) {
    switch (state) {
        case BuildingState::unchanged:
            return "unchanged";
        case BuildingState::proposed:
            return "proposed";
        case BuildingState::removed:
            break;
    }
    return "removed";
}

void addBuildings(const City& city, BuildingState state, const Box2& area, std::vector<DrawnPart>& to) {
    for (const auto& building : city.buildings) {
        if (!meet(bounds(*building), area)) continue;
        const auto groundM = double(findGroundUnder(*building, city));
        for (const Part& part : building->parts)
            to.push_back({building->sourceId, building->name, state, part.footprint,
                          double(part.bottomM) - groundM, double(part.topM) - groundM});
    }
}

std::vector<Place> choosePlacesIn(const std::vector<Place>& places, const Box2& area) {
    std::vector<Place> chosen;
    for (const Place& place : places)
        if (std::ranges::any_of(place.polygons,
                                [&](const Footprint& polygon) { return meet(bounds(polygon), area); }))
            chosen.push_back(place);
    return chosen;
}

namespace {

/// Minutes since midnight, in order.
Result<std::vector<std::chrono::minutes>> timesOfDay(const DrawnTimeChoice& choice) {
    std::vector<std::chrono::minutes> times;
    for (const std::string& text : choice.times) {
        const auto time = parseTimeOfDay(text);
        if (!time) return tl::make_unexpected(time.error());
        times.push_back(*time);
    }
    for (int minute = 0; choice.everyMin > 0 && minute < 24 * 60; minute += choice.everyMin)
        times.emplace_back(minute);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    if (times.empty())
        return failure("The times are missing", "times",
                       "Name times such as 09:00, or an interval in minutes");
    return times;
}

struct NamedHours {
    DayHours window;
    std::string clock;  // "09:00"
};

Result<std::vector<NamedHours>> namedHoursOf(const DrawnTimeChoice& choice, const Zone& zone) {
    const auto times = timesOfDay(choice);
    if (!times) return tl::make_unexpected(times.error());
    std::vector<NamedHours> windows;
    for (const std::string& text : choice.days) {
        const auto day = parseDate(text);
        if (!day) return tl::make_unexpected(day.error());
        for (const std::chrono::minutes time : *times)
            windows.push_back({{*day, zone.instantAt(*day, time), 1}, formatText(time)});
    }
    std::ranges::stable_sort(windows, {}, [](const NamedHours& named) { return named.window.from; });
    return windows;
}

DrawnTime timeOf(const NamedHours& named, const SunStep& sun, const Zone& zone) {
    const std::string day = formatText(named.window.date);
    std::string digits = named.clock;
    std::erase(digits, ':');
    return {day + "_" + digits, day, fmt::format("{} {} {}", day, named.clock, zone.name()), sun};
}

}  // namespace

Result<std::vector<DrawnTime>> listDrawnTimes(const DrawnTimeChoice& choice, const City& city,
                                              Warnings& warnings) {
    const auto zone = Zone::named(choice.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    const auto named = namedHoursOf(choice, *zone);
    if (!named) return tl::make_unexpected(named.error());
    std::vector<DayHours> windows;
    for (const NamedHours& one : *named) windows.push_back(one.window);
    const auto sun = computeSunSteps(windows, {.stepMinutes = 1}, observerOfPlaces(city));
    if (!sun) return tl::make_unexpected(sun.error());
    std::vector<DrawnTime> times;
    for (std::size_t i = 0; i < windows.size(); ++i) {
        if (sun->days[i].count > 0)
            times.push_back(timeOf((*named)[i], sun->steps[sun->days[i].first], *zone));
        else if (choice.everyMin == 0)
            warnings.push_back({WarningKind::leftOut, "a time with the sun below the horizon",
                                formatText(windows[i].date) + " " + (*named)[i].clock});
    }
    if (!times.empty()) return times;
    return failure("The sun is below the horizon at all times", "times", "Choose other times or days");
}

std::vector<std::string> listDaysOf(int year) {
    using namespace std::chrono;
    std::vector<std::string> days;
    const sys_days end = std::chrono::year(year) / December / 31;
    for (sys_days day = std::chrono::year(year) / January / 1; day <= end; day += std::chrono::days(1))
        days.push_back(formatText(CivilDate(day)));
    return days;
}

}  // namespace noonmark
