#include "core/receivers/receivers.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/city/map_context.h"
#include "core/city/terrain/building_ground.h"
#include "core/describe/text.h"
#include "core/receivers/rasterize.h"

namespace noonmark {

namespace {
constexpr int pointsPerSide = 8;  // parallels are curves in the local plane

void addSide(Ring& ring, const Frame& frame, LonLat from, LonLat to) {
    for (int i = 0; i < pointsPerSide; ++i) {
        const double share = double(i) / pointsPerSide;
        const LonLat place{std::lerp(from.lonDeg, to.lonDeg, share),
                           std::lerp(from.latDeg, to.latDeg, share)};
        ring.emplace_back(frame.localFromLonLat(place));
    }
}
}  // namespace

Result<Region> makeRegionFromLonLatBox(const Frame& frame, double westDeg, double southDeg, double eastDeg,
                                       double northDeg) {
    const std::string box = fmt::format("region {},{},{},{}", westDeg, southDeg, eastDeg, northDeg);
    const bool inRange = std::abs(westDeg) <= 180 && std::abs(eastDeg) <= 180 && std::abs(southDeg) <= 90 &&
                         std::abs(northDeg) <= 90;
    if (!inRange)
        return failure(NM_TEXT("A corner is not on the globe"), box,
                       NM_TEXT("Give degrees: west,south,east,north"));
    // A box whose west is the larger number crosses the antimeridian; one that would span most of the globe
    // has its sides swapped.
    const double lastDeg = eastDeg < westDeg ? eastDeg + 360 : eastDeg;
    if (!(westDeg < lastDeg && lastDeg - westDeg <= 180) || !(southDeg < northDeg))
        return failure(
            NM_TEXT("The box is empty"), box,
            NM_TEXT("Give west < east (or west > east across the 180th meridian) and south < north"));
    Ring ring;
    addSide(ring, frame, {westDeg, southDeg}, {lastDeg, southDeg});
    addSide(ring, frame, {lastDeg, southDeg}, {lastDeg, northDeg});
    addSide(ring, frame, {lastDeg, northDeg}, {westDeg, northDeg});
    addSide(ring, frame, {westDeg, northDeg}, {westDeg, southDeg});
    return Region{"box", {Footprint{std::move(ring), {}}}};
}

Region makeRegionFromLocalBox(const Box2& box) {
    return {"box", {Footprint{{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}, {}}}};
}

Box2 bounds(const Region& region) {
    Box2 box;
    for (const Footprint& polygon : region.polygons) box.add(bounds(polygon));
    return box;
}

double area(const Region& region) { return area(region.polygons); }

namespace {

Grid gridOfBox(const Box2& box, double cellM) {
    Grid grid;
    grid.cellM = cellM;
    grid.westM = std::floor(double(box.low.x) / cellM) * cellM;
    grid.southM = std::floor(double(box.low.y) / cellM) * cellM;
    // At least one cell; the caller detects a count beyond int through size().
    grid.columns = int(std::clamp(std::ceil((double(box.high.x) - grid.westM) / cellM), 1.0, 1e9));
    grid.rows = int(std::clamp(std::ceil((double(box.high.y) - grid.southM) / cellM), 1.0, 1e9));
    return grid;
}

void mark(Receivers& receivers, const Footprint& footprint, CellKind from, CellKind to) {
    forEachRun(footprint, receivers.grid, [&](int row, int first, int end) {
        for (int column = first; column < end; ++column) {
            CellKind& kind = receivers.kind[receivers.grid.index(column, row)];
            if (kind == from) kind = to;
        }
    });
}

void markWater(Receivers& receivers, const City& city) {
    if (!city.context) return;
    for (const ContextArea& area : city.context->areas) {
        if (area.kind != ContextKind::water) continue;
        for (const Footprint& polygon : area.polygons)
            if (overlaps(bounds(polygon), receivers.grid))
                mark(receivers, polygon, CellKind::ground, CellKind::water);
    }
}

void markBuildings(Receivers& receivers, const City& city, const std::stop_token& stop) {
    for (const auto& building : city.buildings) {
        if (stop.stop_requested()) return;
        if (!overlaps(bounds(*building), receivers.grid)) continue;
        for (const Part& part : building->parts) {
            const glm::vec2 corner =
                part.footprint.outer.empty() ? glm::vec2(0) : part.footprint.outer.front();
            for (const Footprint& contact : findGroundContact(part, groundAt(city, glm::dvec2(corner))))
                mark(receivers, contact, CellKind::ground, CellKind::building);
        }
    }
}

void listGroundCells(Receivers& receivers) {
    for (std::size_t i = 0; i < receivers.kind.size(); ++i)
        if (receivers.kind[i] == CellKind::ground) receivers.cells.push_back(std::uint32_t(i));
}

void sampleGround(Receivers& receivers, const City& city, const std::stop_token& stop) {
    if (!city.terrain) return;
    const Grid& grid = receivers.grid;
    receivers.groundM.resize(grid.size());
    for (int row = 0; row < grid.rows && !stop.stop_requested(); ++row)
        for (int column = 0; column < grid.columns; ++column)
            receivers.groundM[grid.index(column, row)] = elevationAt(*city.terrain, grid.centre(column, row));
}

}  // namespace

Result<Grid> gridOver(const Region& region, const ReceiverSettings& settings) {
    const double cellM = settings.cellM;
    if (!(cellM >= ReceiverSettings::minCellM && cellM <= ReceiverSettings::maxCellM))
        return failure(fmt::format("A cell of {} m is out of range", cellM), "cell size",
                       NM_TEXT("Choose 0.25 to 10 m"));
    const Box2 box = bounds(region);
    if (box.empty())
        return failure(NM_TEXT("The region has no area"), region.name,
                       NM_TEXT("Draw a polygon with an interior"));
    const Grid grid = gridOfBox(box, cellM);
    if (grid.size() > std::size_t(std::numeric_limits<std::int32_t>::max()))
        return failure(fmt::format("The region has {:.1f} billion cells", double(grid.size()) * 1e-9),
                       region.name,
                       NM_TEXT("Choose larger cells or a smaller region; the limit is 2.1 billion cells"));
    return grid;
}

glm::vec3 Receivers::position(std::uint32_t cell) const {
    const int column = int(cell % std::uint32_t(grid.columns));
    const int row = int(cell / std::uint32_t(grid.columns));
    return {glm::vec2(grid.centre(column, row)), flat() ? 0.0F : groundM[cell]};
}

double lowestGroundM(const Receivers& receivers) {
    if (receivers.flat() || receivers.cells.empty()) return 0;
    double lowest = std::numeric_limits<double>::max();
    for (const std::uint32_t cell : receivers.cells)
        lowest = std::min(lowest, double(receivers.groundM[cell]));
    return lowest;
}

Result<Receivers> placeReceiversOnGround(const City& city, const Region& region,
                                         const ReceiverSettings& settings, const std::stop_token& stop) {
    return gridOver(region, settings).and_then([&](const Grid& grid) {
        return placeReceiversInPart(city, region, grid, stop);
    });
}

Result<Receivers> placeReceiversInPart(const City& city, const Region& region, const Grid& part,
                                       const std::stop_token& stop, WaterCells water) {
    Receivers receivers;
    receivers.grid = part;
    receivers.kind.assign(receivers.grid.size(), CellKind::outside);
    for (const Footprint& polygon : region.polygons)
        mark(receivers, polygon, CellKind::outside, CellKind::ground);
    markBuildings(receivers, city, stop);
    if (water == WaterCells::leftOut) markWater(receivers, city);
    sampleGround(receivers, city, stop);
    if (stop.stop_requested()) return cancelled();
    listGroundCells(receivers);
    return receivers;
}

}  // namespace noonmark
