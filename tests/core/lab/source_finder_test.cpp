#include "core/lab/inverse/sources/source_finder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/lab/inverse/sources/projected_source_finder.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

std::vector<std::uint32_t> listAllObstacles(const City& city) {
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < city.buildings.size(); ++i) indices.push_back(i);
    return indices;
}

/// Levels x cells of the grid: heights (0 where there is no source) and buildings.
struct Found {
    std::vector<float> heightM;
    std::vector<std::uint32_t> building;
};

/// Finds sources on lanes in `direction`.
Found found(const SourceFinder& finder, const Grid& grid, glm::vec3 sun, glm::dvec2 direction) {
    const Lanes lanes(grid, direction);
    const auto instant = finder.at(glm::dvec3(sun), lanes);
    LaneSources block;
    block.resize(finder.levels(), lanes.majors());
    Found found{std::vector<float>(std::size_t(finder.levels()) * grid.size(), -1), {}};
    found.building.resize(found.heightM.size());
    for (int lane = 0; lane < lanes.count(); ++lane) {
        if (lane % Lanes::perBlock == 0) instant->fill(lane / Lanes::perBlock, block, 0);
        for (int at = 0; at < lanes.majors() * finder.levels(); ++at) {
            const int major = at / finder.levels(), level = at % finder.levels();
            const std::size_t from = block.line(0, major, level);
            const float height = block.heightM[from].values[lane % Lanes::perBlock];
            const std::uint32_t building = block.building[from].values[lane % Lanes::perBlock];
            EXPECT_EQ(height == 0, building == LaneSources::nobody);
            if (const int minor = lanes.minor(lane, major); lanes.onGrid(minor)) {
                const std::size_t to = std::size_t(level) * grid.size() + lanes.cellAt(major, minor);
                found.heightM[to] = height;
                found.building[to] = building;
            } else
                EXPECT_EQ(height, 0) << "beyond the grid";
        }
    }
    return found;
}

bool insideABuilding(const City& city, glm::dvec2 point) {
    return std::ranges::any_of(city.buildings, [&](const auto& building) {
        return contains(building->parts.front().footprint, point);
    });
}

// Share of cell-levels at which rays and polygons do not find the same building at the same height. Inside a
// building, the exit through a party wall is the entry into the next building; either may come first.
double differing(const City& city, const Grid& grid, glm::vec3 sun, int levels, float nearestM) {
    const RaySourceFinder rays(RayScene::over(city).value(), grid, levels, nearestM);
    const ProjectedSourceFinder polygons(makeSurfaceFacets(city, listAllObstacles(city), grid, nearestM),
                                         levels, nearestM);
    // Lanes along x and along y, bent and straight, independent of the sun.
    const double angle = sun.x * 40;
    const glm::dvec2 direction(std::cos(angle), std::sin(angle));
    const Found expected = found(rays, grid, sun, {1, 0}), is = found(polygons, grid, sun, direction);
    std::size_t different = 0;
    for (std::size_t i = 0; i < expected.heightM.size(); ++i) {
        const int cell = int(i % grid.size());
        const bool sameHeight = std::abs(expected.heightM[i] - is.heightM[i]) <= 0.01F;
        const bool sameBuilding =
            expected.heightM[i] == 0 || expected.building[i] == is.building[i] ||
            insideABuilding(city, grid.centre(cell % grid.columns, cell / grid.columns));
        different += !sameHeight || !sameBuilding;
    }
    return double(different) / double(expected.heightM.size());
}

TEST(SourceFinder, PolygonsFindWhatRaysFindOnBoxes) {
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        const City city = cityOf(randomBoxes(seed, 8));
        for (const int levels : {1, 3, 8})
            for (const Sun sun : {Sun{100, 4}, Sun{151, 23}, Sun{203, 61}, Sun{290, 12}})
                EXPECT_LE(differing(city, {-20.3, -20.3, 1, 203, 187},
                                    towardsSun(sun.azimuthDeg, sun.altitudeDeg), levels, 1),
                          0.005)
                    << seed << ' ' << levels << ' ' << sun.azimuthDeg;
    }
}

TEST(SourceFinder, PolygonsFindWhatRaysFindOnCourtyardsAndConcaveParts) {
    City city;
    const Ring court = rectangle(10, 10, 20, 22);
    city.buildings.push_back(
        buildingOf({rectangle(0, 0, 30, 30), {Ring(court.rbegin(), court.rend())}}, 0, 12));
    city.buildings.push_back(
        buildingOf({{{50, 0}, {80, 0}, {80, 10}, {60, 10}, {60, 30}, {50, 30}}, {}}, 0, 25));
    city.buildings.push_back(buildingOf({{{0, 50}, {30, 53}, {28, 80}, {15, 60}, {2, 82}}, {}}, 8, 20,
                                        true));  // a concave overhang
    for (const Sun sun : {Sun{100, 14}, Sun{151, 33}, Sun{230, 51}})
        EXPECT_LE(
            differing(city, {-40.3, -40.3, 0.5, 340, 341}, towardsSun(sun.azimuthDeg, sun.altitudeDeg), 3, 1),
            0.001)
            << sun.azimuthDeg;
}

TEST(SourceFinder, PolygonsFindWhatRaysFindOnAMesh) {
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0},  {20, 0, 0},  {20, 12, 0}, {0, 12, 0}, {0, 0, 8},
                     {20, 0, 8}, {20, 12, 8}, {0, 12, 8},  {0, 6, 14}, {20, 6, 14}};
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {2, 3, 7}, {2, 7, 6}, {1, 2, 6}, {1, 6, 9},
                      {1, 9, 5}, {3, 0, 4}, {3, 4, 8}, {3, 8, 7}, {4, 5, 9}, {4, 9, 8}, {6, 7, 8}, {6, 8, 9}};
    Building building;
    building.parts.push_back({.footprint = {rectangle(0, 0, 20, 12), {}},
                              .topM = 14,
                              .mesh = std::make_shared<const TriangleMesh>(mesh)});
    City city;
    city.buildings.push_back(std::make_shared<const Building>(std::move(building)));
    for (const Sun sun : {Sun{100, 14}, Sun{151, 33}, Sun{230, 51}})
        EXPECT_LE(
            differing(city, {-40.3, -40.3, 0.5, 240, 241}, towardsSun(sun.azimuthDeg, sun.altitudeDeg), 2, 1),
            0.001)
            << sun.azimuthDeg;
}

TEST(SourceFinder, AnEmptyCityShadesNothing) {
    const Grid grid{0, 0, 1, 33, 17};
    const ProjectedSourceFinder finder(makeSurfaceFacets({}, {}, grid, 1), 3, 1);
    EXPECT_EQ(std::ranges::count(found(finder, grid, towardsSun(120, 30), {1, 0.4}).heightM, 0.0F),
              3 * 33 * 17);
}

}  // namespace
}  // namespace noonmark
