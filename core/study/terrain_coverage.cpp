#include "core/study/terrain_coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/engines/common/shadow_reach.h"
#include "core/receivers/rasterize.h"

namespace noonmark {

namespace {

// Whether every cell of a grid's outline lies on the terrain; then the cells inside do too.
bool coversAll(const Terrain& terrain, const Grid& cells) {
    const auto off = [&](int column, int row) {
        return beyondM(terrain.grid, cells.centre(column, row)) > 0;
    };
    for (int column = 0; column < cells.columns; ++column)
        if (off(column, 0) || off(column, cells.rows - 1)) return false;
    for (int row = 0; row < cells.rows; ++row)
        if (off(0, row) || off(cells.columns - 1, row)) return false;
    return true;
}

Box2 computeBox(const Grid& cells) {
    return {{float(cells.westM), float(cells.southM)}, {float(cells.eastM()), float(cells.northM())}};
}

// Counts points into a share.
class Counter {
public:
    Counter(const Terrain& terrain, TerrainCoverage::Share& share) : posts_(terrain.grid), share_(share) {
        const Box2 box = bounds(posts_);
        farM_ = double(std::min(box.high.x - box.low.x, box.high.y - box.low.y));
    }
    void add(glm::dvec2 place) {
        const double beyond = beyondM(posts_, place);
        ++share_.all;
        share_.off += beyond > 0 ? 1 : 0;
        share_.farOff += beyond > farM_ ? 1 : 0;
        share_.farthestM = std::max(share_.farthestM, beyond);
    }

private:
    const PostGrid& posts_;
    TerrainCoverage::Share& share_;
    double farM_ = 0;
};

TerrainCoverage::Share placeCasters(const City& city, const Grid& cells, const SunSteps& sun) {
    TerrainCoverage::Share share;
    Counter counter(*city.terrain, share);
    const ShadowReach reach(sun);
    const float lowest = *std::ranges::min_element(city.terrain->elevationM);
    for (const auto& building : city.buildings) {
        const Box2 box = bounds(*building);
        if (reach.touches(box, double(topM(*building) - lowest), computeBox(cells)))
            counter.add(glm::dvec2(box.low + box.high) / 2.0);
    }
    return share;
}

}  // namespace

TerrainCoverage computeTerrainCoverage(const City& city, const Receivers& receivers, const SunSteps& sun) {
    if (!city.terrain) return {};
    TerrainCoverage coverage{.casters = placeCasters(city, receivers.grid, sun)};
    if (coversAll(*city.terrain, receivers.grid)) {
        coverage.receivers.all = receivers.cells.size();
        return coverage;
    }
    Counter counter(*city.terrain, coverage.receivers);
    for (const std::uint32_t cell : receivers.cells) counter.add(glm::dvec2(receivers.position(cell)));
    return coverage;
}

TerrainCoverage computeTerrainCoverage(const City& city, const Region& region, const Grid& cells,
                                       const SunSteps& sun) {
    if (!city.terrain) return {};
    TerrainCoverage coverage{.casters = placeCasters(city, cells, sun)};
    Counter counter(*city.terrain, coverage.receivers);
    constexpr double maxCells = 1e6;
    const int step = std::max(1, int(std::ceil(std::sqrt(double(cells.size()) / maxCells))));
    for (const Footprint& polygon : region.polygons)
        forEachRun(polygon, cells, [&](int row, int first, int end) {
            if (row % step != 0) return;
            for (int column = first; column < end; ++column)
                if (column % step == 0) counter.add(cells.centre(column, row));
        });
    return coverage;
}

Result<void> checkCoverage(const TerrainCoverage& coverage, const std::string& region) {
    const auto refused = [&](const char* what, std::size_t count, const TerrainCoverage::Share& share) {
        return failure(
            fmt::format("Most {} the terrain: {} of {}, up to {:.0f} m from it", what, count, share.all,
                        share.farthestM),
            region,
            "Choose a terrain that covers the region and the buildings that shade it, or omit the terrain");
    };
    const auto& [receivers, casters] = coverage;
    if (receivers.off * 2 > receivers.all) return refused("receivers lie beyond", receivers.off, receivers);
    if (casters.farOff * 2 > casters.all)
        return refused("buildings whose shadow can reach the region lie far from", casters.farOff, casters);
    return {};
}

Warnings makeWarnings(const TerrainCoverage& coverage) {
    Warnings warnings;
    const auto add = [&](const char* what, const TerrainCoverage::Share& share) {
        if (share.off > 0)
            warnings.push_back(
                {WarningKind::assumed, what,
                 fmt::format("{} of {} ({:.1f} %), up to {:.0f} m from it", share.off, share.all,
                             100.0 * double(share.off) / double(share.all), share.farthestM)});
    };
    add("receivers beyond the terrain are at its nearest elevation", coverage.receivers);
    add("buildings beyond the terrain whose shadow can reach the region stand on its nearest elevation",
        coverage.casters);
    return warnings;
}

}  // namespace noonmark
