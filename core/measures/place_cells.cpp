#include "core/measures/place_cells.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/city/footprints/plan_overlay.h"
#include "core/city/footprints/shared_area.h"
#include "core/city/terrain/ground_contact.h"
#include "core/receivers/rasterize.h"

namespace noonmark {

namespace {

void addContacts(const City& city, const Building& building, std::vector<Footprint>& built) {
    for (const Part& part : building.parts) {
        const glm::vec2 corner = part.footprint.outer.empty() ? glm::vec2(0) : part.footprint.outer.front();
        for (Footprint& contact : findGroundContact(part, groundAt(city, glm::dvec2(corner))))
            built.push_back(std::move(contact));
    }
}

Box2 boxAround(const Place& place) {
    Box2 box;
    for (const Footprint& polygon : place.polygons) box.add(bounds(polygon));
    return box;
}

/// Calls `take(cell)` for the cells that an edge passes through.
void walkEdge(glm::vec2 from, glm::vec2 to, const Grid& grid, const auto& take) {
    const glm::dvec2 origin(grid.westM, grid.southM);
    glm::dvec2 a = (glm::dvec2(from) - origin) / grid.cellM, b = (glm::dvec2(to) - origin) / grid.cellM;
    if (a.y > b.y) std::swap(a, b);
    const auto xAt = [&](double y) {
        const double along = b.y > a.y ? std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0) : 0;
        return a.x + along * (b.x - a.x);
    };
    const auto cellOf = [](double at, int count) {
        return int(std::clamp(std::floor(at), 0.0, count - 1.0));
    };
    for (int row = cellOf(a.y, grid.rows); row <= cellOf(b.y, grid.rows); ++row) {
        const bool level = a.y == b.y;
        const double x = level ? a.x : xAt(row), y = level ? b.x : xAt(row + 1);
        const int first = cellOf(std::min(x, y), grid.columns), last = cellOf(std::max(x, y), grid.columns);
        for (int column = first; column <= last; ++column) take(std::uint32_t(grid.index(column, row)));
    }
}

void sortEachOnce(std::vector<std::uint32_t>& cells) {
    std::ranges::sort(cells);
    const auto again = std::ranges::unique(cells);
    cells.erase(again.begin(), again.end());
}

std::vector<std::uint32_t> collectCrossed(const std::vector<Footprint>& polygons, const Grid& grid) {
    std::vector<std::uint32_t> cells;
    const auto walk = [&](const Ring& ring) {
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
            walkEdge(ring[j], ring[i], grid, [&](std::uint32_t cell) { cells.push_back(cell); });
    };
    for (const Footprint& polygon : polygons) {
        walk(polygon.outer);
        for (const Ring& hole : polygon.holes) walk(hole);
    }
    sortEachOnce(cells);
    return cells;
}

Footprint squareOf(const Grid& grid, std::uint32_t cell) {
    const double west = grid.westM + double(cell % std::uint32_t(grid.columns)) * grid.cellM,
                 south = grid.southM + double(cell / std::uint32_t(grid.columns)) * grid.cellM;
    const auto x0 = float(west), y0 = float(south), x1 = float(west + grid.cellM),
               y1 = float(south + grid.cellM);
    return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

double shareOf(const std::vector<Footprint>& polygons, const Grid& grid, std::uint32_t cell) {
    const Footprint square = squareOf(grid, cell);
    double shared = 0;
    for (const Footprint& polygon : polygons) shared += computeSharedArea(square, polygon);
    return std::min(1.0, shared / area(square));
}

double sumAreas(const std::vector<Footprint>& polygons) {
    double sum = 0;
    for (const Footprint& polygon : polygons) sum += area(polygon);
    return sum;
}

}  // namespace

std::vector<std::vector<Footprint>> findBuiltGround(std::span<const City* const> cities,
                                                    std::span<const Place> places) {
    std::vector<Box2> ofPlaces;
    for (const Place& place : places) ofPlaces.push_back(boxAround(place));
    std::vector<std::vector<Footprint>> built(places.size());
    for (const City* city : cities) {
        std::vector<Box2> ofBuildings;
        for (const auto& building : city->buildings) ofBuildings.push_back(bounds(*building));
        for (const auto& [place, building] : findMeetingBoxes(ofPlaces, ofBuildings))
            addContacts(*city, *city->buildings[building], built[place]);
    }
    return built;
}

std::vector<Footprint> findOpenGround(const Place& place, const std::vector<Footprint>& built) {
    constexpr LeastPiece any{1e-6, 0};
    if (built.empty()) return place.polygons;
    auto open = cutPiecesOutside(place.polygons, built, any);
    // Nothing also where the overlay fails: then cells under buildings are left out by their centres alone.
    return open.empty() && sumAreas(built) < sumAreas(place.polygons) ? place.polygons : open;
}

std::vector<CellPart> listCellParts(const std::vector<Footprint>& polygons, const Grid& grid,
                                    const std::stop_token& stop) {
    constexpr double leastShare = 1e-6;  // what rounding leaves of a cell that an edge only touches
    const std::vector<std::uint32_t> crossed = collectCrossed(polygons, grid),
                                     centred = collectCells(polygons, grid);
    std::vector<std::uint32_t> whole;
    std::ranges::set_difference(centred, crossed, std::back_inserter(whole));
    std::vector<CellPart> parts;
    for (const std::uint32_t cell : whole) parts.push_back({cell, 1});
    for (const std::uint32_t cell : crossed) {
        if (stop.stop_requested()) return parts;
        const double share = shareOf(polygons, grid, cell);
        if (share > leastShare) parts.push_back({cell, share});
    }
    std::ranges::sort(parts, {}, &CellPart::cell);
    return parts;
}

}  // namespace noonmark
