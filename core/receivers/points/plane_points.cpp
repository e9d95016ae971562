#include "core/receivers/points/plane_points.h"

#include <fmt/format.h>

#include <algorithm>

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

}  // namespace noonmark
