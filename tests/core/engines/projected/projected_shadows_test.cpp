#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

#include "core/engines/projected/filling/step_filler.h"
#include "core/engines/projected/projected_shadows.h"
#include "core/engines/ray/ray_scene.h"
#include "core/receivers/rasterize.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {

namespace {

using namespace tests;

ShadowField projected(const City& city, const Receivers& receivers, const SunSteps& sun) {
    NoProgress progress;
    return ProjectedShadows().accumulate(city, receivers, sun, progress, {}).value();
}

// Two days; hours of 15 steps that repeat every day.
SunSteps twoDays() {
    SunSteps sun;
    addDay(sun, arc(50, 45));
    addDay(sun, arc(61, 30));
    return sun;
}
StepSets hours(const SunSteps& sun) {
    StepSets sets{{"first", "second", "third", "never", "rest"}, {}};
    for (const SunDay& day : sun.days)
        for (std::uint32_t i = 0; i < day.count; ++i)
            sets.ofStep.push_back(i < 45 ? std::uint16_t(i / 15) : 4);
    return sets;
}

TEST(ProjectedBreakdown, EachSetIsARunOverItsOwnSteps) {
    const City city = cityOf(randomBoxes(5, 5));
    const Receivers receivers = receiversOver(city, -20, -20, 120, 120, 2);
    const SunSteps sun = twoDays();
    const StepSets sets = hours(sun);
    NoProgress progress;
    const ShadowBreakdown made = computeProjectedBreakdown(city, receivers, sun, sets, progress, {}).value();
    ASSERT_EQ(made.minutes.size(), sets.names.size());
    EXPECT_EQ(made.sunlitMinutes, (std::vector<double>{30, 30, 30, 0, 21}));
    for (std::size_t set = 0; set < sets.names.size(); ++set) {
        SunSteps own = sets.stepsOf(set, sun);
        EXPECT_EQ(double(own.steps.size()), made.sunlitMinutes[set]);
        own.days = {{.first = 0, .count = std::uint32_t(own.steps.size())}};
        const ShadowField alone = projected(city, receivers, own);
        const std::vector<float> minutes = spreadOverGrid(made, set);
        for (std::size_t cell = 0; cell < receivers.kind.size(); ++cell)
            ASSERT_TRUE(minutes[cell] == alone.grossMin[cell] ||
                        (std::isnan(minutes[cell]) && std::isnan(alone.grossMin[cell])));
    }
}

TEST(ProjectedBreakdown, SetsAddUpToTheField) {
    const City city = cityOf(randomBoxes(6, 5));
    const Receivers receivers = receiversOver(city, -20, -20, 120, 120, 2);
    const SunSteps sun = twoDays();
    const ShadowField field = projected(city, receivers, sun);
    NoProgress progress;
    const ShadowBreakdown made =
        computeProjectedBreakdown(city, receivers, sun, hours(sun), progress, {}).value();
    for (std::size_t i = 0; i < receivers.cells.size(); ++i) {
        double minutes = 0;
        for (const auto& set : made.minutes) minutes += double(set[i]);
        ASSERT_EQ(float(minutes / 2), field.grossMin[receivers.cells[i]]);
    }
}

TEST(ProjectedBreakdown, RefusesTerrainAndStops) {
    City city = cityOf({{{0, 0, 0}, {10, 10, 10}}});
    const Receivers receivers = receiversOver(city, -20, -20, 20, 20);
    const SunSteps sun = twoDays();
    NoProgress progress;
    std::stop_source source;
    source.request_stop();
    EXPECT_TRUE(isCancelled(
        computeProjectedBreakdown(city, receivers, sun, hours(sun), progress, source.get_token()).error()));
    city.terrain = std::make_shared<const Terrain>(Terrain{{-50, -50, 50, 2, 2}, {0, 1, 2, 3}});
    const auto refused = ProjectedShadows().breakDown(city, receivers, sun, hours(sun), false, progress, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::unsupported);
}

// Share of cell-steps on which the two engines differ.
double differing(const City& city, const Receivers& receivers, const SunSteps& sun) {
    const auto rasters = computeShadowRasters(city, receivers, sun).value();
    const auto scene = RayScene::over(city).value();
    const BitLayout layout(receivers.grid);
    std::size_t different = 0;
    for (std::size_t step = 0; step < sun.steps.size(); ++step)
        for (const std::uint32_t cell : receivers.cells) {
            const int column = int(cell) % layout.columns, row = int(cell) / layout.columns;
            const bool shaded = layout.at(std::span(rasters).subspan(step * layout.words()), column, row);
            different +=
                shaded != scene.occluded(placeRayOrigin(receivers.position(cell)), sun.steps[step].direction);
        }
    return double(different) / double(std::max<std::size_t>(1, sun.steps.size() * receivers.cells.size()));
}

// Fills a polygon as the shadow of a slab on the ground.
void fillPolygon(std::span<const glm::dvec2> polygon, const BitLayout& layout,
                 std::span<std::uint64_t> rasters) {
    ShadowCasters casters;
    casters.points.assign(polygon.begin(), polygon.end());
    for (std::size_t i = 0; i < polygon.size(); ++i)
        casters.edges.emplace_back(polygon[i], polygon[(i + 1) % polygon.size()]);
    casters.casters.push_back(
        {.kind = ShadowCaster::Kind::flat, .pointCount = std::uint32_t(polygon.size())});
    const std::uint32_t only = 0;
    CasterFill(casters).fill({&only, 1}, {}, layout, {0, layout.rows}, rasters);
}

TEST(CasterFill, FillsWhatTheRasteriserFills) {
    const Grid grid{0, 0, 1, 130, 140};
    const BitLayout layout(grid);
    std::mt19937 random(9);
    std::uniform_real_distribution<float> x(-40, 170), y(-20, 160);
    for (int round = 0; round < 500; ++round) {
        Ring ring{{x(random), y(random)}, {x(random), y(random)}, {x(random), y(random)}};
        if (round % 5 == 0)
            ring[1].y = ring[0].y = float(int(ring[0].y)) + 0.5F;  // an edge along a row of cell centres
        if (signedArea(ring) < 0) std::swap(ring[1], ring[2]);
        std::vector<glm::dvec2> cells;
        for (const glm::vec2 point : ring) cells.push_back(glm::dvec2(point) - 0.5);
        std::vector<StepWords> steps(layout.words());
        std::vector<std::uint64_t> raster, expected(layout.words());
        fillPolygon(cells, layout, {steps.data()->words, steps.size() * stepsTogether});
        for (const StepWords& eight : steps)
            raster.push_back(eight.words[std::size_t(round) % stepsTogether]);
        forEachRun({ring, {}}, grid, [&](int row, int first, int end) {
            for (int column = first; column < end; ++column) layout.set(expected, column, row);
        });
        ASSERT_EQ(raster, expected) << round;
    }
}

TEST(ProjectedShadows, AgreesWithRaysOnRandomBoxes) {
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        const City city = cityOf(randomBoxes(seed, 6));
        const Receivers receivers = receiversOver(city, -20.3F, -20.3F, 140.7F, 140.7F);
        EXPECT_LE(differing(city, receivers, oneDay(arc(48, 55, seed % 2 == 0))), 1e-5) << seed;
    }
}

TEST(ProjectedShadows, AgreesWithRaysOnCourtyardsAndConcaveParts) {
    City city;
    const Ring court = rectangle(10, 10, 20, 22);
    city.buildings.push_back(
        buildingOf({rectangle(0, 0, 30, 30), {Ring(court.rbegin(), court.rend())}}, 0, 12));
    city.buildings.push_back(
        buildingOf({{{50, 0}, {80, 0}, {80, 10}, {60, 10}, {60, 30}, {50, 30}}, {}}, 0, 25));
    city.buildings.push_back(buildingOf({{{0, 50}, {30, 53}, {28, 80}, {15, 60}, {2, 82}}, {}}, 8, 20,
                                        true));  // a concave overhang
    const Receivers receivers = receiversOver(city, -40.3F, -40.3F, 130.7F, 130.7F);
    EXPECT_LE(differing(city, receivers, oneDay(arc(60, 50))), 1e-5);
}

TEST(ProjectedShadows, AgreesWithRaysOnAMeshWithASlopedRoof) {
    Part part;
    TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0},  {20, 0, 0},  {20, 12, 0}, {0, 12, 0}, {0, 0, 8},
                     {20, 0, 8}, {20, 12, 8}, {0, 12, 8},  {0, 6, 14}, {20, 6, 14}};
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {2, 3, 7}, {2, 7, 6}, {1, 2, 6}, {1, 6, 9},
                      {1, 9, 5}, {3, 0, 4}, {3, 4, 8}, {3, 8, 7}, {4, 5, 9}, {4, 9, 8}, {6, 7, 8}, {6, 8, 9}};
    part.footprint.outer = rectangle(0, 0, 20, 12);
    part.topM = 14;
    part.mesh = std::make_shared<const TriangleMesh>(mesh);
    City city;
    city.buildings.push_back(std::make_shared<const Building>(Building{.parts = {part}}));
    const Receivers receivers = receiversOver(city, -40.3F, -40.3F, 60.7F, 60.7F);
    EXPECT_LE(differing(city, receivers, oneDay(arc(60, 50))), 1e-5);
}

TEST(ProjectedShadows, MinutesAndRunsAreThoseOfTheRayReference) {
    const City city = cityOf(randomBoxes(8, 5));
    const Receivers receivers = receiversOver(city, -20.3F, -20.3F, 120.7F, 120.7F);
    SunSteps sun = oneDay(arc(90, 40));
    addDay(sun, arc(77, 60));
    for (std::size_t k = 120; k < sun.steps.size(); ++k) sun.steps[k].slot += 5;  // a gap in the second day
    const ShadowField field = projected(city, receivers, sun), truth = traced(city, receivers, sun);
    std::size_t different = 0;
    for (const std::uint32_t cell : receivers.cells)
        different += field.grossMin[cell] != truth.grossMin[cell] ||
                     field.continuousMin[cell] != truth.continuousMin[cell];
    EXPECT_LE(different, receivers.cells.size() / 500);
    for (std::size_t cell = 0; cell < receivers.kind.size(); ++cell)
        EXPECT_EQ(std::isnan(field.grossMin[cell]), receivers.kind[cell] != CellKind::ground);
}

TEST(ProjectedShadows, PartyWallsLetNoLightThrough) {
    // Two halves of a block cast the same shadow as the whole block.
    const City whole = cityOf({{{0, 0, 0}, {40, 20, 30}}});
    const City halves = cityOf({{{0, 0, 0}, {17, 20, 30}}, {{17, 0, 0}, {40, 20, 30}}});
    const Receivers receivers = receiversOver(whole, -60, -60, 100, 100);
    const SunSteps sun = oneDay(arc(180, 50));
    EXPECT_EQ(computeShadowRasters(whole, receivers, sun).value().size(),
              computeShadowRasters(halves, receivers, sun).value().size());
    const ShadowField one = projected(whole, receivers, sun), two = projected(halves, receivers, sun);
    for (const std::uint32_t cell : receivers.cells)
        EXPECT_EQ(one.grossMin[cell], two.grossMin[cell]) << cell;
}

// Rays begin slightly north-east of a receiver: here the receiver is just outside a wall, and its rays begin
// inside.
TEST(ProjectedShadows, AReceiverAtAWallWhoseRaysBeginInsideIsDarkWithTheSunBehind) {
    const float line = 0.5F + RayScene::wallOffsetM / 2;
    const Ring box = rectangle(line, line, 12, 12);
    const Ring angle{{line, line}, {12, line}, {12, 6}, {6, 6}, {6, 12}, {line, 12}};
    for (const Ring& ring : {box, angle}) {
        City city;
        city.buildings.push_back(buildingOf({ring, {}}, 0, 9));
        const Receivers receivers = receiversOver(city, -20, -20, 40, 40);
        ASSERT_EQ(receivers.kind[receivers.grid.index(20, 25)], CellKind::ground);
        EXPECT_EQ(differing(city, receivers, oneDay({{30, 30}, {45, 40}, {60, 20}, {75, 50}})), 0);
    }
}

TEST(ProjectedShadows, AMeshThatIsNotClosedShadesFromBothSides) {
    for (const glm::uvec3 triangle : {glm::uvec3(0, 1, 2), glm::uvec3(0, 2, 1)}) {
        const TriangleMesh sail{{{0, 0, 8}, {20, 0, 8}, {0, 20, 14}}, {triangle}};
        Building building;
        building.parts.push_back({.footprint = {{{0, 0}, {20, 0}, {0, 20}}, {}},
                                  .bottomM = 8,
                                  .topM = 14,
                                  .isOverhanging = true,
                                  .mesh = std::make_shared<const TriangleMesh>(sail)});
        City city;
        city.buildings.push_back(std::make_shared<const Building>(std::move(building)));
        const Receivers receivers = receiversOver(city, -40, -40, 60, 60);
        const SunSteps sun = oneDay(arc(20, 50));
        EXPECT_LE(differing(city, receivers, sun), 0.0001);
        const ShadowField field = projected(city, receivers, sun);
        EXPECT_GT(std::ranges::count_if(field.grossMin, [](float minutes) { return minutes > 0; }), 200);
    }
}

TEST(ProjectedShadows, NoSunAndNoCityGiveZeros) {
    const City city = cityOf({{{0, 0, 0}, {10, 10, 10}}});
    const Receivers receivers = receiversOver(city, -20, -20, 20, 20);
    SunSteps night;
    night.days.push_back({});
    const ShadowField dark = projected(city, receivers, night),
                      empty = projected({}, receivers, oneDay(arc(10, 40)));
    for (const std::uint32_t cell : receivers.cells) {
        EXPECT_EQ(dark.grossMin[cell], 0);
        EXPECT_EQ(empty.grossMin[cell], 0);
    }
}

// Some columns in the west and some in the east of some rows.
Receivers scattered(Receivers receivers) {
    const auto columns = std::uint32_t(receivers.grid.columns);
    std::erase_if(receivers.cells, [&](std::uint32_t cell) {
        const std::uint32_t column = cell % columns, row = cell / columns;
        return row < 150 || row >= 260 || (column >= 70 && column < 500) || column >= 540;
    });
    std::ranges::replace(receivers.kind, CellKind::ground, CellKind::outside);
    for (const std::uint32_t cell : receivers.cells) receivers.kind[cell] = CellKind::ground;
    return receivers;
}

TEST(ProjectedShadows, ReceiversFarApartHaveTheMinutesThatTheyHaveAmongAllOthers) {
    const City city = cityOf(randomBoxes(7, 12));
    const Receivers all = receiversOver(city, -20, -20, 120, 120, 0.25), some = scattered(all);
    std::size_t words = 0;
    for (const FillWindow& window : windowsOf(some)) words += window.layout().words();
    EXPECT_LT(words, BitLayout(some.grid).words() / 3) << "rasters of the columns that hold receivers only";
    const SunSteps sun = oneDay(arc(45, 60));
    const ShadowField whole = projected(city, all, sun), part = projected(city, some, sun);
    ASSERT_FALSE(some.cells.empty());
    for (const std::uint32_t cell : some.cells) {
        ASSERT_EQ(part.grossMin[cell], whole.grossMin[cell]);
        ASSERT_EQ(part.continuousMin[cell], whole.continuousMin[cell]);
    }
}

TEST(ProjectedShadows, RefusesTerrain) {
    City city = cityOf({{{0, 0, 0}, {10, 10, 10}}});
    city.terrain = std::make_shared<const Terrain>(Terrain{{-50, -50, 50, 2, 2}, {0, 1, 2, 3}});
    NoProgress progress;
    EXPECT_FALSE(
        ProjectedShadows()
            .accumulate(city, receiversOver(city, -20, -20, 20, 20), oneDay(arc(10, 40)), progress, {})
            .has_value());
}

}  // namespace

}  // namespace noonmark
