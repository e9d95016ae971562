#include "core/mesh_reader/dxf_shapes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace noonmark {

namespace {

std::string trimmed(const std::string& line) {
    constexpr const char* blanks = " \t\r";
    const auto first = line.find_first_not_of(blanks);
    return first == line.npos ? std::string() : line.substr(first, line.find_last_not_of(blanks) - first + 1);
}

template <class Number>
std::optional<Number> parse(const std::string& text) {
    Number number{};
    const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

}  // namespace

std::optional<double> parseDxfNumber(const std::string& text) {
    const auto number = parse<double>(text);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

std::string DxfEntity::text(int code) const {
    const auto found = std::ranges::find(groups, code, &std::pair<int, std::string>::first);
    return found == groups.end() ? std::string() : found->second;
}

double DxfEntity::number(int code, double otherwise) const {
    return parseDxfNumber(text(code)).value_or(otherwise);
}

int DxfEntity::whole(int code, int otherwise) const { return parse<int>(text(code)).value_or(otherwise); }

glm::dvec3 DxfEntity::point(int first) const {
    return {number(first), number(first + 10), number(first + 20)};
}

bool DxfEntity::has(int code) const {
    return std::ranges::find(groups, code, &std::pair<int, std::string>::first) != groups.end();
}

DxfReader::DxfReader(std::istream& stream) : stream_(stream) { good_ = readPair(); }

bool DxfReader::readPair() {
    std::string line;
    if (!std::getline(stream_, line)) return false;
    const auto code = parse<int>(trimmed(line));
    if (!code || !std::getline(stream_, line)) return false;
    code_ = *code;
    value_ = trimmed(line);
    return true;
}

std::optional<DxfEntity> DxfReader::next() {
    while (good_ && code_ != 0) good_ = readPair();  // comments (999) before the first entity
    if (!good_) return std::nullopt;
    DxfEntity entity{value_, {}};
    for (good_ = readPair(); good_ && code_ != 0; good_ = readPair())
        entity.groups.emplace_back(code_, value_);
    return entity;
}

namespace {

constexpr double arcStep = 10 * std::numbers::pi / 180;
constexpr std::size_t maxMeshSide = 32767;  // points along one side of a polygon mesh, as in the format

// A corner of an outline and the bulge of the edge after it: the tangent of a quarter of its arc's angle.
struct OutlinePoint {
    double x = 0, y = 0, bulge = 0;
};

// The points on the arc from `a` to `b`, without its ends.
void addArc(const OutlinePoint& a, const OutlinePoint& b, std::vector<OutlinePoint>& points) {
    const double angle = 4 * std::atan(a.bulge);
    const int steps = int(std::ceil(std::abs(angle) / arcStep));
    if (steps < 2) return;
    const double half = (1 / a.bulge - a.bulge) / 4;  // from the chord's middle to the centre, in chords
    const double x = (a.x + b.x) / 2 - (b.y - a.y) * half, y = (a.y + b.y) / 2 + (b.x - a.x) * half;
    for (int i = 1; i < steps; ++i) {
        const double turn = angle * i / steps, cos = std::cos(turn), sin = std::sin(turn);
        points.push_back({x + (a.x - x) * cos - (a.y - y) * sin, y + (a.x - x) * sin + (a.y - y) * cos, 0});
    }
}

std::vector<OutlinePoint> withArcs(const std::vector<OutlinePoint>& corners) {
    std::vector<OutlinePoint> points;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        points.push_back(corners[i]);
        if (corners[i].bulge != 0) addArc(corners[i], corners[(i + 1) % corners.size()], points);
    }
    return points;
}

bool isClosed(const DxfEntity& entity, std::vector<OutlinePoint>& corners) {
    if (corners.size() > 3 && corners.front().x == corners.back().x &&
        corners.front().y == corners.back().y) {
        corners.pop_back();
        return true;
    }
    return (entity.whole(70) & 1) != 0;
}

DxfShape extrude(const DxfEntity& entity, const std::vector<OutlinePoint>& corners, double elevation) {
    const double thickness = entity.number(39);
    const glm::dmat3 axes = ownAxes(entity);
    DxfPolygon low, high;
    for (const OutlinePoint& point : withArcs(corners)) {
        low.push_back(axes * glm::dvec3(point.x, point.y, elevation));
        high.push_back(axes * glm::dvec3(point.x, point.y, elevation + thickness));
    }
    if (low.size() < 3) return {{}, "outlines of fewer than three corners"};
    if (thickness == 0) return {{}, "outlines without a thickness", std::move(low)};
    DxfShape shape;
    for (std::size_t i = 0; i < low.size(); ++i) {
        const std::size_t next = (i + 1) % low.size();
        shape.polygons.push_back({low[i], low[next], high[next], high[i]});
    }
    shape.polygons.push_back(high);
    std::ranges::reverse(low);
    shape.polygons.push_back(std::move(low));
    return shape;
}

DxfShape makePolyface(const std::vector<DxfEntity>& vertices) {
    constexpr int facePart = 128, meshPoint = 64;
    std::vector<glm::dvec3> points;
    DxfShape shape;
    for (const DxfEntity& vertex : vertices) {
        const int flags = vertex.whole(70);
        if ((flags & facePart) == 0 || (flags & meshPoint) != 0) {
            points.push_back(vertex.point(10));
            continue;
        }
        DxfPolygon face;
        for (const int code : {71, 72, 73, 74}) {
            const auto corner = std::size_t(std::abs(double(vertex.whole(code))));  // negative: a hidden edge
            if (corner > 0 && corner <= points.size()) face.push_back(points[corner - 1]);
        }
        if (face.size() >= 3) shape.polygons.push_back(std::move(face));
    }
    if (shape.polygons.empty()) shape.leftOut = "polyface meshes without faces";
    return shape;
}

DxfShape makeGridMesh(const DxfEntity& polyline, const std::vector<DxfEntity>& vertices) {
    const auto rows = std::size_t(std::max(0, polyline.whole(71)));
    const auto columns = std::size_t(std::max(0, polyline.whole(72)));
    if (rows > maxMeshSide || columns > maxMeshSide || rows < 2 || columns < 2 ||
        rows * columns != vertices.size())
        return {{}, "polygon meshes that are smoothed or incomplete"};
    const std::size_t lastRow = (polyline.whole(70) & 1) != 0 ? rows : rows - 1;
    const std::size_t lastColumn = (polyline.whole(70) & 32) != 0 ? columns : columns - 1;
    const auto at = [&](std::size_t row, std::size_t column) {
        return vertices[(row % rows) * columns + column % columns].point(10);
    };
    DxfShape shape;
    for (std::size_t row = 0; row < lastRow; ++row)
        for (std::size_t column = 0; column < lastColumn; ++column)
            shape.polygons.push_back(
                {at(row, column), at(row, column + 1), at(row + 1, column + 1), at(row + 1, column)});
    return shape;
}

}  // namespace

// Autodesk's "arbitrary axis algorithm".
glm::dmat3 ownAxes(const DxfEntity& entity) {
    const glm::dvec3 direction(entity.number(210), entity.number(220), entity.number(230, 1));
    const double length = glm::length(direction);
    if (!(length > 1e-9) || !std::isfinite(length)) return glm::dmat3(1);
    const glm::dvec3 z = direction / length;
    constexpr double nearVertical = 1.0 / 64;
    const bool isVertical = std::abs(z.x) < nearVertical && std::abs(z.y) < nearVertical;
    const glm::dvec3 x =
        glm::normalize(glm::cross(isVertical ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1), z));
    return {x, glm::cross(z, x), z};
}

// Group 92 counts the points that follow, 93 the numbers of the list of faces in groups 90: the corners of a
// face, then their numbers. Groups before 92 and after the list have other meanings.
DxfShape makeSubdivisionMesh(const DxfEntity& mesh) {
    std::vector<glm::dvec3> points;
    std::vector<std::size_t> list;
    bool isInFaces = false;
    for (const auto& [code, value] : mesh.groups) {
        const double number = parseDxfNumber(value).value_or(-1);
        if (code == 10 && !isInFaces) points.emplace_back(number, 0, 0);
        if (code == 20 && !points.empty()) points.back().y = number;
        if (code == 30 && !points.empty()) points.back().z = number;
        if (code == 93 || code == 94) isInFaces = code == 93;
        if (code == 90 && isInFaces && number >= 0) list.push_back(std::size_t(number));
    }
    DxfShape shape;
    for (std::size_t at = 0; at < list.size() && list[at] < list.size() - at; at += list[at] + 1) {
        DxfPolygon face;
        for (std::size_t i = at + 1; i <= at + list[at]; ++i)
            if (list[i] < points.size()) face.push_back(points[list[i]]);
        if (face.size() >= 3 && face.size() == list[at]) shape.polygons.push_back(std::move(face));
    }
    if (shape.polygons.empty()) shape.leftOut = "meshes without faces";
    return shape;
}

// The fourth corner of a triangle repeats the third.
DxfShape makeFace(const DxfEntity& face) {
    DxfPolygon polygon;
    for (const int code : {10, 11, 12, 13}) {
        const glm::dvec3 corner = face.has(code) ? face.point(code) : face.point(12);
        if (polygon.empty() || corner != polygon.back()) polygon.push_back(corner);
    }
    if (polygon.size() > 3 && polygon.back() == polygon.front()) polygon.pop_back();
    if (polygon.size() < 3) return {{}, "faces of fewer than three corners"};
    return {{std::move(polygon)}, {}};
}

// Corners are stored crosswise: the third and the fourth are exchanged.
DxfShape makeSolid(const DxfEntity& solid) {
    std::vector<OutlinePoint> corners;
    for (const int code : {10, 11, 13, 12}) {
        if (!solid.has(code)) continue;
        const glm::dvec3 point = solid.point(code);
        if (corners.empty() || point.x != corners.back().x || point.y != corners.back().y)
            corners.push_back({point.x, point.y, 0});
    }
    return extrude(solid, corners, solid.number(30));
}

DxfShape makeLightOutline(const DxfEntity& outline) {
    std::vector<OutlinePoint> corners;
    for (const auto& [code, value] : outline.groups) {
        const double number = parseDxfNumber(value).value_or(0);
        if (code == 10) corners.push_back({number, 0, 0});
        if (code == 20 && !corners.empty()) corners.back().y = number;
        if (code == 42 && !corners.empty()) corners.back().bulge = number;
    }
    if (!isClosed(outline, corners)) return {{}, "open lines"};
    return extrude(outline, corners, outline.number(38));
}

DxfShape makePolyline(const DxfEntity& polyline, const std::vector<DxfEntity>& vertices) {
    constexpr int line3d = 8, gridMesh = 16, polyface = 64;
    const int flags = polyline.whole(70);
    if ((flags & polyface) != 0) return makePolyface(vertices);
    if ((flags & gridMesh) != 0) return makeGridMesh(polyline, vertices);
    if ((flags & line3d) != 0) return {{}, "3D lines"};
    std::vector<OutlinePoint> corners;
    for (const DxfEntity& vertex : vertices)
        corners.push_back({vertex.number(10), vertex.number(20), vertex.number(42)});
    if (!isClosed(polyline, corners)) return {{}, "open lines"};
    return extrude(polyline, corners, polyline.number(30));
}

}  // namespace noonmark
