#include "core/receivers/points/point_list.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "core/base/csv_text.h"
#include "core/receivers/points/solid_parts.h"
#include "core/receivers/rasterize.h"

namespace noonmark {

namespace {

glm::dvec2 centreOf(const Grid& grid, std::uint32_t cell) {
    return grid.centre(int(cell % std::uint32_t(grid.columns)), int(cell / std::uint32_t(grid.columns)));
}

double meanGround(const City& city, const Grid& grid, const std::vector<std::uint32_t>& cells) {
    double sum = 0;
    for (const std::uint32_t cell : cells) sum += double(groundAt(city, centreOf(grid, cell)));
    return cells.empty() ? 0 : sum / double(cells.size());
}

void addPlanePoint(const Grid& grid, std::uint32_t cell, double planeM, PointReceivers& into) {
    into.points.positions.emplace_back(glm::dvec3(centreOf(grid, cell), planeM));
    into.points.normals.emplace_back(0, 0, 1);
    into.elements.push_back(
        {.id = fmt::format("{},{}", cell % std::uint32_t(grid.columns), cell / std::uint32_t(grid.columns)),
         .kind = ElementKind::plane});
    into.panes.push_back({glm::dvec2(-grid.cellM / 2), glm::dvec2(grid.cellM / 2)});
}

}  // namespace

double findMeanGroundM(const City& city, const Region& region) {
    const Box2 box = bounds(region);
    const glm::vec2 size = box.high - box.low;
    ReceiverSettings cells;
    cells.cellM = std::clamp(double(std::max(size.x, size.y)) / 1000, 1.0, ReceiverSettings::maxCellM);
    const auto grid = gridOver(region, cells);
    return grid ? meanGround(city, *grid, collectCells(region.polygons, *grid)) : 0;
}

Result<PlanePoints> placeOnPlane(const City& city, const Region& region, const ReceiverSettings& settings,
                                 double heightM, const std::stop_token& stop) {
    if (!(heightM >= 0 && heightM <= maxPlaneHeightM))
        return failure(fmt::format("A plane {} m above the ground is out of range", heightM), "plane",
                       "Give 0 to 1000 m");
    const auto grid = gridOver(region, settings);
    if (!grid) return tl::make_unexpected(grid.error());
    if (grid->size() > maxReceivers)
        return limitReached(
            fmt::format("The plane has {} cells", grid->size()), region.name,
            fmt::format("Choose larger cells or a smaller region; the limit is {}", maxReceivers));
    const SolidParts solids(city);
    const std::vector<std::uint32_t> cells = collectCells(region.polygons, *grid);
    PlanePoints plane;
    plane.planeM = meanGround(city, *grid, cells) + heightM;
    for (const std::uint32_t cell : cells) {
        if (stop.stop_requested()) return cancelled();
        const glm::dvec2 centre = centreOf(*grid, cell);
        if (plane.planeM < double(groundAt(city, centre)))
            ++plane.belowGround;
        else if (solids.isSolid({centre, plane.planeM}))
            ++plane.insideBuildings;
        else
            addPlanePoint(*grid, cell, plane.planeM, plane.receivers);
    }
    return plane;
}

namespace {

constexpr const char* pointAdvice =
    "Give longitude and latitude in degrees, metres above the ground and the azimuth that a wall faces: "
    "-73.98,40.75,4.5,180";

std::optional<double> pointNumber(std::string_view text) {
    double number = 0;
    const auto end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    if (read.ec != std::errc() || read.ptr != end || !std::isfinite(number)) return std::nullopt;
    return number;
}

/// The fields of one point, as text.
struct PointFields {
    std::string id, lon, lat, height, facing;
};

// Sets an optional number; false where the text is none.
bool readOptional(const std::string& text, double low, double high, std::optional<double>& number) {
    if (text.empty()) return true;
    number = pointNumber(text);
    return number && *number >= low && *number <= high;
}

Result<ListedPoint> pointFrom(const PointFields& fields, const std::string& where) {
    ListedPoint point{.id = fields.id};
    const auto lon = pointNumber(fields.lon), lat = pointNumber(fields.lat);
    if (!lon || !lat || std::abs(*lon) > 180 || std::abs(*lat) > 90)
        return failure(fmt::format("'{},{}' is not a place", fields.lon, fields.lat), where, pointAdvice);
    point.at = {*lon, *lat};
    if (!readOptional(fields.height, 0, ListedPoint::maxHeightM, point.heightM))
        return failure(fmt::format("'{}' is not a height of 0 to 2000 m", fields.height), where, pointAdvice);
    if (!readOptional(fields.facing, 0, 360, point.facingDeg))
        return failure(fmt::format("'{}' is not an azimuth of 0 to 360 degrees", fields.facing), where,
                       pointAdvice);
    return point;
}

/// Positions of the fields in a row; -1: there is none.
struct PointColumns {
    int id = -1, lon = 0, lat = 1, height = 2, facing = 3;

    [[nodiscard]] PointFields of(const CsvRow& row) const {
        const auto field = [&](int column) {
            return column < 0 || std::size_t(column) >= row.fields.size() ? std::string()
                                                                          : row.fields[std::size_t(column)];
        };
        return {field(id), field(lon), field(lat), field(height), field(facing)};
    }
};

std::string lower(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return text;
}

int columnOf(const CsvRow& heading, std::initializer_list<std::string_view> names) {
    for (std::size_t i = 0; i < heading.fields.size(); ++i)
        if (std::ranges::find(names, std::string_view(lower(heading.fields[i]))) != names.end())
            return int(i);
    return -1;
}

bool isHeading(const CsvRow& row) {
    return std::ranges::none_of(row.fields,
                                [](const std::string& field) { return pointNumber(field).has_value(); });
}

Result<PointColumns> columnsOf(const CsvRow& heading, const std::string& source) {
    const PointColumns columns{columnOf(heading, {"id", "name", "point"}),
                               columnOf(heading, {"lon", "longitude", "lon_deg", "x"}),
                               columnOf(heading, {"lat", "latitude", "lat_deg", "y"}),
                               columnOf(heading, {"height", "height_m", "h", "above_ground_m"}),
                               columnOf(heading, {"facing", "facing_deg", "azimuth", "azimuth_deg"})};
    if (columns.lon < 0 || columns.lat < 0)
        return failure("The points have no columns lon and lat", source,
                       "Name the columns in the first row: id,lon,lat,height,facing");
    return columns;
}

}  // namespace

Result<ListedPoint> parsePoint(std::string_view text) {
    const auto rows = parseCsvRows(text);
    if (rows.size() != 1 || rows[0].fields.size() < 2 || rows[0].fields.size() > 4)
        return failure(fmt::format("'{}' is not a point", text), "point", pointAdvice);
    return pointFrom(PointColumns().of(rows[0]), "point");
}

std::string formatText(const ListedPoint& point) {
    std::string text = fmt::format("{:.7f},{:.7f}", point.at.lonDeg, point.at.latDeg);
    if (point.heightM || point.facingDeg)
        text += point.heightM ? fmt::format(",{}", *point.heightM) : std::string(",");
    if (point.facingDeg) text += fmt::format(",{}", *point.facingDeg);
    return text;
}

Result<std::vector<ListedPoint>> parsePointList(std::string_view text, const std::string& source) {
    const auto rows = parseCsvRows(text);
    PointColumns columns;
    const bool headed = !rows.empty() && isHeading(rows.front());
    if (headed) {
        const auto named = columnsOf(rows.front(), source);
        if (!named) return tl::make_unexpected(named.error());
        columns = *named;
    }
    const std::size_t count = rows.size() - (headed ? 1 : 0);
    if (count == 0) return failure("There are no points", source, pointAdvice);
    if (count > maxListedPoints)
        return limitReached(fmt::format("There are {} points", count), source,
                            fmt::format("Give at most {}", maxListedPoints));
    std::vector<ListedPoint> points;
    std::set<std::string> ids;
    for (std::size_t i = headed ? 1 : 0; i < rows.size(); ++i) {
        auto point = pointFrom(columns.of(rows[i]), fmt::format("{}, line {}", source, rows[i].line));
        if (!point) return tl::make_unexpected(point.error());
        if (point->id.empty()) point->id = fmt::format("point {}", points.size() + 1);
        if (!ids.insert(point->id).second)
            return failure(fmt::format("Two points have the id '{}'", point->id),
                           fmt::format("{}, line {}", source, rows[i].line), "Give each point its own id");
        points.push_back(*std::move(point));
    }
    return points;
}

std::string toCsv(const std::vector<ListedPoint>& points) {
    CsvText csv({"id", "lon", "lat", "height", "facing"});
    for (const ListedPoint& point : points) {
        csv.text(point.id).number(point.at.lonDeg, 7).number(point.at.latDeg, 7);
        for (const auto& value : {point.heightM, point.facingDeg}) value ? csv.number(*value) : csv.nothing();
        csv.endRow();
    }
    return csv.take();
}

}  // namespace noonmark
