#include "core/io/terrain_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>

#include "core/city/fill_gaps.h"
#include "core/geo/earth_drop.h"
#include "core/receivers/rasterize.h"

namespace noonmark {

namespace {

constexpr double mostCells = 64e6;

bool isFinite(LonLat place) { return std::isfinite(place.lonDeg) && std::isfinite(place.latDeg); }

// The side of a square as large as the raster's middle pixel, metres.
double pixelM(const RasterPlace& raster, const CrsToLonLat& crs) {
    const glm::dvec2 points[] = {raster.middle, raster.nextColumn, raster.nextRow};
    const std::vector<LonLat> places = crs.lonLat(points);
    const Frame frame(places[0]);
    const glm::dvec2 a = frame.localFromLonLat(places[1]);
    const glm::dvec2 b = frame.localFromLonLat(places[2]);
    return std::sqrt(std::abs(a.x * b.y - a.y * b.x));
}

// The raster's box, cut to what is near the origin.
struct Extent {
    glm::dvec2 low{1e30};
    glm::dvec2 high{-1e30};
    bool cut = false;
    void add(glm::dvec2 point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void cutTo(double farAwayM) {
        cut = std::min(low.x, low.y) < -farAwayM || std::max(high.x, high.y) > farAwayM;
        low = glm::max(low, glm::dvec2(-farAwayM));
        high = glm::min(high, glm::dvec2(farAwayM));
    }
    [[nodiscard]] bool empty() const { return low.x >= high.x || low.y >= high.y; }
};

void chooseCells(const Extent& extent, double pixel, TerrainGrid& place, const std::string& file) {
    const glm::dvec2 size = extent.high - extent.low;
    const double bounded = std::clamp(pixel, 0.25, 1000.0);
    const double cell = std::max(bounded, std::sqrt(size.x * size.y / mostCells));
    place.grid = {extent.low.x, extent.low.y, cell, std::max(2, int(size.x / cell)),
                  std::max(2, int(size.y / cell))};
    place.coarser = cell > pixel * 1.01;
    if (cell > bounded)
        place.warnings.push_back({WarningKind::clipped,
                                  "terrain is too fine to keep whole; its cells were made larger",
                                  fmt::format("{} ({:.2f} m instead of {:.2f} m)", file, cell, bounded)});
}

// Cells whose centres lie in the raster.
std::vector<bool> cellsInside(const TerrainGrid& place) {
    std::vector<bool> inside(place.grid.size());
    forEachRun({place.border, {}}, place.grid, [&](int row, int first, int end) {
        for (int column = first; column < end; ++column) inside[place.grid.index(column, row)] = true;
    });
    return inside;
}

std::size_t forgetImpossible(std::vector<float>& elevations) {
    std::size_t impossible = 0;
    for (float& elevation : elevations) {
        if (std::isnan(elevation) || (elevation > -500 && elevation < 9000)) continue;
        elevation = std::numeric_limits<float>::quiet_NaN();
        ++impossible;
    }
    return impossible;
}

std::size_t gapsInside(const TerrainGrid& place, const std::vector<float>& elevations) {
    const std::vector<bool> inside = cellsInside(place);
    std::size_t gaps = 0;
    for (std::size_t i = 0; i < elevations.size(); ++i)
        gaps += inside[i] && std::isnan(elevations[i]) ? 1 : 0;
    return gaps;
}

float lowestOf(const std::vector<float>& elevations) {
    float lowest = std::numeric_limits<float>::infinity();
    for (const float elevation : elevations)
        if (elevation < lowest) lowest = elevation;
    return lowest;
}

}  // namespace

Result<TerrainGrid> terrainGrid(const RasterPlace& raster, const CrsToLonLat& crs,
                                const ReadSettings& settings, const std::string& file) {
    const glm::dvec2 middle[] = {raster.middle};
    const LonLat centre = crs.lonLat(middle)[0];
    const double pixel = isFinite(centre) ? pixelM(raster, crs) : 0;
    if (!isFinite(centre) || !crs.isPlausible(centre) || !(pixel > 0))
        return failure(fmt::format("The raster's coordinates cannot be of {}", crs.name()), file,
                       "Check which coordinate reference system it is in");
    TerrainGrid place{.frame = settings.frame.value_or(Frame(centre))};
    Extent extent;
    for (const LonLat corner : crs.lonLat(raster.border)) {
        if (!isFinite(corner)) continue;
        const glm::dvec2 local = place.frame.localFromLonLat(corner);
        extent.add(local);
        place.border.emplace_back(local);
    }
    extent.cutTo(settings.farAwayM);
    if (extent.empty() || place.border.size() < 3)
        return failure("The terrain does not lie where the city is", file, "Choose one of the same place");
    if (extent.cut)
        place.warnings.push_back({WarningKind::clipped, "terrain far from the city was left out", file});
    chooseCells(extent, pixel, place, file);
    return place;
}

Result<void> finishTerrain(const TerrainGrid& place, std::vector<float> elevations,
                           const ReadSettings& settings, const std::string& file, FilePiece& piece) {
    if (const std::size_t impossible = forgetImpossible(elevations); impossible > 0)
        piece.warnings.push_back({WarningKind::mended,
                                  "impossible elevations were filled from the nearest cell",
                                  fmt::format("{} ({} cells)", file, impossible)});
    if (const std::size_t gaps = gapsInside(place, elevations); gaps > 0)
        piece.warnings.push_back({WarningKind::mended,
                                  "cells without elevation were filled from the nearest one",
                                  fmt::format("{} ({} of {} cells)", file, gaps, elevations.size())});
    fillFromNearest(elevations, place.grid.columns, place.grid.rows);
    const float lowest = lowestOf(elevations);
    if (!std::isfinite(lowest))
        return failure("The terrain holds no elevation here", file, "Choose one that covers the city");
    const Frame frame = settings.frame.value_or(Frame(place.frame.origin(), double(lowest)));
    for (int row = 0; row < place.grid.rows; ++row)
        for (int column = 0; column < place.grid.columns; ++column) {
            float& elevation = elevations[place.grid.index(column, row)];
            elevation = float(double(elevation) - frame.originElevationM() -
                              earthDropM(place.grid.centre(column, row)));
        }
    if (!settings.frame) piece.frame = frame;
    piece.terrain = std::make_shared<const Terrain>(Terrain{place.grid, std::move(elevations)});
    piece.features = 1;
    return {};
}

}  // namespace noonmark
