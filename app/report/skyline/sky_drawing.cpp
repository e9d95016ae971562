#include "app/report/skyline/skyline_svg.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <iterator>

namespace noonmark {

namespace {

std::uint32_t buildingAt(const PointView& view, double azimuthDeg) {
    for (const SkylineStretch& stretch : view.stretches) {
        const double width = std::fmod(stretch.toDeg - stretch.fromDeg + 360, 360);
        if (std::fmod(azimuthDeg - stretch.fromDeg + 360, 360) <= width) return stretch.building;
    }
    return SkyObstacles::terrain;
}

std::string fillOf(std::uint32_t building, const BuildingColours& colours, const char* standard) {
    const auto found = colours.find(building);
    return found == colours.end() ? standard : found->second;
}

}  // namespace

void SkyDrawing::addPoint(double azimuthDeg, double altitudeDeg, std::string& points) const {
    const glm::dvec2 at = frame_.at(azimuthDeg, std::clamp(altitudeDeg, 0.0, 90.0));
    fmt::format_to(std::back_inserter(points), "{:.2f},{:.2f} ", at.x, at.y);
}

// The horizon is an arc in the stereographic frame; skylines have an entry at each degree.
void SkyDrawing::addCurve(SkylinePlace from, SkylinePlace to, std::string& points) const {
    const int parts = std::max(1, int(std::ceil(std::abs(to.azimuthDeg - from.azimuthDeg))));
    for (int i = 0; i <= parts; ++i) {
        const double t = double(i) / parts;
        addPoint(from.azimuthDeg + t * (to.azimuthDeg - from.azimuthDeg),
                 from.altitudeDeg + t * (to.altitudeDeg - from.altitudeDeg), points);
    }
}

void SkyDrawing::drawPolyline(const std::string& points, const char* style) {
    if (!points.empty())
        fmt::format_to(std::back_inserter(svg_), "<polyline points=\"{}\" fill=\"none\" {}/>\n", points,
                       style);
}

void SkyDrawing::drawSky() {
    std::string whole;
    addCurve({0, 0}, {360, 0}, whole);
    if (frame_.kind == SkyFrame::Kind::cylindrical) addCurve({360, 90}, {0, 90}, whole);
    fmt::format_to(std::back_inserter(svg_), "<polygon points=\"{}\" fill=\"#eef5fb\" stroke=\"#7f8c99\"/>\n",
                   whole);
    for (int altitude = 10; altitude < 90; altitude += 10) {
        std::string line;
        addCurve({0, double(altitude)}, {360, double(altitude)}, line);
        drawPolyline(line, "stroke=\"#c9d6e2\" stroke-width=\"0.6\"");
    }
    for (int azimuth = 0; azimuth < 360; azimuth += 30) {
        std::string line;
        addPoint(azimuth, 0, line);
        addPoint(azimuth, 90, line);
        drawPolyline(line, "stroke=\"#c9d6e2\" stroke-width=\"0.6\"");
    }
}

void SkyDrawing::drawBehindWall(double facingDeg) {
    for (int degree = 0; degree < 360; ++degree) {
        if (std::cos((degree + 0.5 - facingDeg) * std::numbers::pi / 180) > 0) continue;
        std::string behind;
        for (const auto& [azimuth, altitude] : std::array<std::pair<int, int>, 4>{
                 {{degree, 0}, {degree + 1, 0}, {degree + 1, 90}, {degree, 90}}})
            addPoint(azimuth, altitude, behind);
        fmt::format_to(std::back_inserter(svg_),
                       "<polygon points=\"{0}\" fill=\"{1}\" stroke=\"{1}\" stroke-width=\"0.7\"/>\n", behind,
                       behindWallFill);
    }
}

void SkyDrawing::drawSkyline(const PointView& view, const BuildingColours& colours, const char* fill) {
    const auto& places = view.skyline;
    for (std::size_t i = 0; i + 1 < places.size();) {
        const std::uint32_t building =
            buildingAt(view, (places[i].azimuthDeg + places[i + 1].azimuthDeg) / 2);
        const std::size_t first = i;
        std::string points;
        bool rises = false;
        for (; i + 1 < places.size(); ++i) {
            const double middle = (places[i].azimuthDeg + places[i + 1].azimuthDeg) / 2;
            if (i > first && buildingAt(view, middle) != building) break;
            rises = rises || places[i].altitudeDeg > 0 || places[i + 1].altitudeDeg > 0;
            addPoint(places[i].azimuthDeg, places[i].altitudeDeg, points);
        }
        addPoint(places[i].azimuthDeg, places[i].altitudeDeg, points);
        addCurve({places[i].azimuthDeg, 0}, {places[first].azimuthDeg, 0}, points);
        if (rises)
            fmt::format_to(std::back_inserter(svg_),
                           "<polygon points=\"{}\" fill=\"{}\" stroke=\"#ffffff\" stroke-width=\"0.3\"/>\n",
                           points, fillOf(building, colours, fill));
    }
}

void SkyDrawing::drawOverhangs(const PointView& view) {
    for (const OverhangSpan& span : view.overhangs) {
        std::string points;
        addPoint(span.fromDeg, span.lowDeg, points);
        addPoint(span.toDeg, span.lowDeg, points);
        addPoint(span.toDeg, span.highDeg, points);
        addPoint(span.fromDeg, span.highDeg, points);
        fmt::format_to(std::back_inserter(svg_), "<polygon points=\"{}\" fill=\"{}\"/>\n", points,
                       overhangFill);
    }
}

namespace {

constexpr double fullTurnDeg = 360;

// The columns within one turn, from 0 to 360 degrees: a crown that stands across north has two pieces.
std::vector<CrownColumn> cutTurn(const std::vector<CrownColumn>& columns, int turn) {
    std::vector<CrownColumn> piece;
    for (CrownColumn column : columns) {
        column.azimuthDeg -= turn * fullTurnDeg;
        if (column.azimuthDeg >= 0 && column.azimuthDeg <= fullTurnDeg) piece.push_back(column);
    }
    return piece;
}

}  // namespace

void SkyDrawing::drawCrowns(const PointCrowns& crowns) {
    for (const SeenCrown& crown : crowns.seen) {
        const double through = crown.inLeaf ? crown.leafOnTransmissivity : crown.leafOffTransmissivity;
        for (int turn = 0; turn < 2; ++turn) {
            const std::vector<CrownColumn> piece = cutTurn(crown.columns, turn);
            if (piece.size() < 2) continue;
            std::string points;
            for (const CrownColumn& column : piece) addPoint(column.azimuthDeg, column.highDeg, points);
            for (auto column = piece.rbegin(); column != piece.rend(); ++column)
                addPoint(column->azimuthDeg, column->lowDeg, points);
            fmt::format_to(std::back_inserter(svg_),
                           "<polygon points=\"{0}\" fill=\"{1}\" fill-opacity=\"{2:.3f}\" stroke=\"{1}\" "
                           "stroke-opacity=\"0.5\" stroke-width=\"0.4\"/>\n",
                           points, crownFill, 1 - through);
        }
    }
}

void SkyDrawing::drawOutline(const PointView& view, const char* stroke) {
    std::string points;
    for (const SkylinePlace& place : view.skyline) addPoint(place.azimuthDeg, place.altitudeDeg, points);
    drawPolyline(points, fmt::format("stroke=\"{}\" stroke-width=\"0.9\"", stroke).c_str());
}

void SkyDrawing::drawPath(const SunSteps& sun, const ShadedSteps& shaded, std::size_t day,
                          const char* colour) {
    const SunDay& steps = sun.days[day];
    std::string points;
    for (std::uint32_t i = steps.first; i < steps.first + steps.count; ++i) {
        const SunStep& step = sun.steps[i];
        addPoint(double(step.azimuthDeg), double(step.altitudeDeg), points);
        const bool last = i + 1 == steps.first + steps.count;
        // Across north the line of the cylindrical frame begins anew.
        const bool ends = last || shaded[i + 1] != shaded[i] ||
                          std::abs(sun.steps[i + 1].azimuthDeg - step.azimuthDeg) > 180;
        if (!ends) continue;
        drawPolyline(points, fmt::format("stroke=\"{}\" stroke-width=\"{}\" stroke-opacity=\"{}\"", colour,
                                         shaded[i] != 0 ? 0.7 : 2.6, shaded[i] != 0 ? 0.6 : 1)
                                 .c_str());
        points.clear();
        if (!last && shaded[i + 1] == shaded[i]) continue;
        addPoint(double(step.azimuthDeg), double(step.altitudeDeg), points);
    }
}

void SkyDrawing::drawHours(const SunSteps& sun, std::size_t day, const Zone& zone) {
    const SunDay& steps = sun.days[day];
    long before = -1;
    for (std::uint32_t i = steps.first; i < steps.first + steps.count; ++i) {
        const auto at = std::chrono::floor<std::chrono::seconds>(sun.steps[i].at);
        const auto clock = (at + zone.offsetAt(at)).time_since_epoch();
        const long hour = long(std::chrono::floor<std::chrono::hours>(clock).count());
        if (before >= 0 && hour != before) {
            const glm::dvec2 place =
                frame_.at(double(sun.steps[i].azimuthDeg), double(sun.steps[i].altitudeDeg));
            fmt::format_to(std::back_inserter(svg_),
                           "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"2\" fill=\"#5d4300\"/>"
                           "<text x=\"{0:.1f}\" y=\"{2:.1f}\" font-size=\"9\" text-anchor=\"middle\" "
                           "fill=\"#5d4300\">{3}</text>\n",
                           place.x, place.y, place.y - 4, (hour % 24 + 24) % 24);
        }
        before = hour;
    }
}

void SkyDrawing::drawLabel(double azimuthDeg, double altitudeDeg, const std::string& text,
                           const char* anchor) {
    const glm::dvec2 at = frame_.at(azimuthDeg, altitudeDeg);
    fmt::format_to(std::back_inserter(svg_),
                   "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"10\" text-anchor=\"{}\">{}</text>\n", at.x,
                   at.y, anchor, text);
}

namespace {

constexpr double cellWidthPx = 44, cellHeightPx = 20;
constexpr double minMinutes = 0.5;  // of a mean day; less is not written
constexpr int hours = 24, months = 12;

std::array<int, months> countDays(const SunSteps& sun) {
    std::array<int, months> days{};
    for (const SunDay& day : sun.days) ++days[unsigned(day.date.month()) - 1];
    return days;
}

// From white to a dark yellow.
std::string fillOf(double minutes) {
    const double part = std::min(1.0, minutes / 60);
    return fmt::format("#{:02x}{:02x}{:02x}", int(255 - 20 * part), int(255 - 75 * part),
                       int(255 - 215 * part));
}

void addFigure(std::string& svg, glm::dvec2 at, const char* fill, const std::string& text) {
    fmt::format_to(std::back_inserter(svg),
                   "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"9\" text-anchor=\"middle\" "
                   "fill=\"{}\">{}</text>\n",
                   at.x, at.y, fill, text);
}

void addCell(std::string& svg, glm::dvec2 corner, double before, double after) {
    fmt::format_to(std::back_inserter(svg),
                   "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" fill=\"{}\" "
                   "stroke=\"#dfe4ea\" stroke-width=\"0.5\"/>\n",
                   corner.x, corner.y, cellWidthPx, cellHeightPx, fillOf(after));
    const double change = after - before;
    const bool changes = std::abs(change) >= minMinutes;
    if (after < minMinutes && !changes) return;
    const double middle = corner.x + (changes ? cellWidthPx * 0.3 : cellWidthPx / 2);
    const double line = corner.y + cellHeightPx / 2 + 3;
    addFigure(svg, {middle, line}, "#1f2933", fmt::format("{:.0f}", after));
    if (changes)
        addFigure(svg, {corner.x + cellWidthPx * 0.72, line}, change < 0 ? "#c0141b" : "#1b7a3d",
                  fmt::format("{}{:.0f}", change < 0 ? "\u2212" : "+", std::abs(change)));
}

}  // namespace

const MonthHours& minutesOf(const PointView& view, TreeColumns trees) {
    if (!view.crowns || trees == TreeColumns::without) return view.minutes;
    return view.crowns->of(trees).minutes;
}

void drawSunCarpet(const PointStudy& study, TreeColumns trees, glm::dvec2 corner, std::string& svg) {
    constexpr std::array names{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                               "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
    const MonthHours& before = minutesOf(study.baseline, trees);
    const MonthHours& after = study.scenario ? minutesOf(*study.scenario, trees) : before;
    const std::array<int, months> days = countDays(study.sun);
    for (std::size_t hour = 0; hour < hours; ++hour)
        addFigure(svg, corner + glm::dvec2((double(hour) + 0.5) * cellWidthPx, -5), "#1f2933",
                  fmt::format("{}", hour));
    for (std::size_t month = 0; month < months; ++month) {
        const glm::dvec2 row = corner + glm::dvec2(0, double(month) * cellHeightPx);
        addFigure(svg, row + glm::dvec2(-20, cellHeightPx / 2 + 3), "#1f2933", names[month]);
        const double of = std::max(1, days[month]);
        for (std::size_t hour = 0; hour < hours; ++hour)
            addCell(svg, row + glm::dvec2(double(hour) * cellWidthPx, 0), before[month][hour] / of,
                    after[month][hour] / of);
    }
}

}  // namespace noonmark
