#include "core/measures/shadow_outlines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/city/footprints/repair_footprint.h"
#include "core/engines/projected/projected_shadows.h"
#include "core/measures/places/place_receivers.h"
#include "core/receivers/rasterize.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/engines/terrain_scenes.h"

namespace noonmark {
namespace {

using namespace tests;

SunStep stepAt(double azimuthDeg, double altitudeDeg) {
    return oneDay({{azimuthDeg, altitudeDeg}}).steps.front();
}

// The sun in the south at 45 deg: shadows fall north, as long as their objects are high.
SunStep southSun() { return stepAt(180, 45); }

const Box2 wide{{-200, -200}, {300, 300}};

ShadowOutlines outlined(const City& baseline, const City* scenario, const SunStep& step,
                        const OutlineSettings& settings = {wide}) {
    NoProgress progress;
    return outlineShadows(baseline, scenario, step, settings, progress, {}).value();
}

double baselineArea(const City& city, const SunStep& step, const OutlineSettings& settings = {wide}) {
    return area(outlined(city, nullptr, step, settings).baseline);
}

std::shared_ptr<const Building> pyramid(float halfM, float heightM) {
    TriangleMesh mesh;
    mesh.vertices = {
        {-halfM, -halfM, 0}, {halfM, -halfM, 0}, {halfM, halfM, 0}, {-halfM, halfM, 0}, {0, 0, heightM}};
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    Part part{.footprint = {rectangle(-halfM, -halfM, halfM, halfM), {}}, .topM = heightM};
    part.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
    return std::make_shared<const Building>(Building{.parts = {std::move(part)}});
}

bool isValid(const Footprint& polygon) {
    std::vector<RawRing> rings{RawRing(polygon.outer.begin(), polygon.outer.end())};
    for (const Ring& hole : polygon.holes) rings.emplace_back(hole.begin(), hole.end());
    return repairFootprint(rings).what.empty();
}

TEST(ShadowOutlines, ABoxCastsItsHeightTimesItsWidth) {
    // 20 m wide, 30 m high: 20 x 30 m north of it.
    const ShadowOutlines outlines = outlined(cityOf({{{0, 0, 0}, {20, 10, 30}}}), nullptr, southSun());
    ASSERT_EQ(outlines.baseline.size(), 1U);
    EXPECT_NEAR(area(outlines.baseline), 600, 0.01);
    const Box2 box = bounds(outlines.baseline.front());
    EXPECT_NEAR(box.low.y, 10, 1e-3);
    EXPECT_NEAR(box.high.y, 40, 1e-3);
    EXPECT_EQ(outlines.cellM, 0);
    EXPECT_TRUE(outlines.incremental.empty());
}

TEST(ShadowOutlines, ADiagonalSunSweepsAHexagon) {
    // Offset of the top: 30 m x (-1, 1) / sqrt 2. Swept area without the base: both widths times the offset
    // across them, 20 x 21.213 + 10 x 21.213.
    EXPECT_NEAR(baselineArea(cityOf({{{0, 0, 0}, {20, 10, 30}}}), stepAt(135, 45)), 30 * 21.2132, 0.01);
}

TEST(ShadowOutlines, AnOverhangShadesBetweenItsBottomAndItsTop) {
    // From y = 0 + 12 to y = 10 + 30: 28 m x 20 m, and the ground below it is open.
    const ShadowOutlines outlines = outlined(cityOf({{{0, 0, 12}, {20, 10, 30}}}), nullptr, southSun());
    EXPECT_NEAR(area(outlines.baseline), 20 * 28, 0.01);
    EXPECT_NEAR(bounds(outlines.baseline.front()).low.y, 12, 1e-3);
}

TEST(ShadowOutlines, AConcaveOverhangWithAHoleShadesWhatIsBelowIt) {
    // With the sun in the zenith the shadow is the outline itself: 40 x 40 - 20 x 20 m.
    const Ring hole = rectangle(10, 10, 30, 30);
    City city;
    city.buildings.push_back(
        buildingOf({rectangle(0, 0, 40, 40), {Ring(hole.rbegin(), hole.rend())}}, 10, 15, true));
    EXPECT_NEAR(baselineArea(city, stepAt(0, 90)), 1200, 0.05);
    // At 45 deg it is swept from y + 10 to y + 15: the northern edges add 5 m, those of the hole take 5 m.
    EXPECT_NEAR(baselineArea(city, southSun()), 40.0 * 45 - 20 * 15, 0.05);
}

TEST(ShadowOutlines, ACourtyardIsShadedByItsSouthernWing) {
    // 60 x 60 m with a courtyard of 40 x 40 m, 10 m high: 40 x 10 m inside, 60 x 10 m outside.
    const Ring court = rectangle(10, 10, 50, 50);
    City city;
    city.buildings.push_back(
        buildingOf({rectangle(0, 0, 60, 60), {Ring(court.rbegin(), court.rend())}}, 0, 10));
    EXPECT_NEAR(baselineArea(city, southSun()), 400 + 600, 0.02);
}

TEST(ShadowOutlines, SharedWallsLeaveNoSlit) {
    City halves, whole = cityOf({{{0, 0, 0}, {40, 10, 30}}});
    for (int i = 0; i < 7; ++i)  // widths that are no round binary fractions
        halves.buildings.push_back(
            buildingOf({rectangle(float(i) * 40 / 7, 0, float(i + 1) * 40 / 7, 10), {}}, 0, 30));
    const SunStep sun = stepAt(201.3, 33.7);
    const ShadowOutlines outlines = outlined(halves, nullptr, sun);
    EXPECT_EQ(outlines.baseline.size(), 1U);
    EXPECT_TRUE(outlines.baseline.front().holes.empty());
    EXPECT_NEAR(area(outlines.baseline), baselineArea(whole, sun), 0.02);
}

TEST(ShadowOutlines, APyramidCastsATriangle) {
    // Base 20 x 20 m, 30 m high: the tip's shadow is at y = 30, the northern corners of the base at y = 10.
    City city;
    city.buildings.push_back(pyramid(10, 30));
    EXPECT_NEAR(baselineArea(city, southSun()), 20.0 * 20 / 2, 0.01);
}

TEST(ShadowOutlines, AMeshPartlyBelowTheGroundIsCutAtTheGround) {
    // The pyramid sunk by 15 m: above the ground, 10 x 10 m and 15 m high. Its ground contact is the whole
    // footprint of 20 x 20 m, whose edge is at y = 10; of the shadow's triangle, from (-5, 5) and (5, 5) to
    // (0, 15), the upper half of its height is outside: 5 m wide, 5 m high.
    Building sunk = *pyramid(10, 30);
    TriangleMesh mesh = *sunk.parts[0].mesh;
    for (glm::vec3& point : mesh.vertices) point.z -= 15;
    sunk.parts[0].mesh = std::make_shared<const TriangleMesh>(mesh);
    sunk.parts[0].topM = 15;
    sunk.parts[0].bottomM = -15;
    City city;
    city.buildings.push_back(std::make_shared<const Building>(sunk));
    EXPECT_NEAR(baselineArea(city, southSun()), 5.0 * 5 / 2, 0.01);
}

TEST(ShadowOutlines, AMovedBoxGivesIncrementalShadowAndGainedSun) {
    // 20 m wide, 10 m deep, 30 m high, moved 15 m to the east: shadows of 20 x 30 m overlap by 5 m of width.
    const City before = cityOf({{{0, 0, 0}, {20, 10, 30}}}), after = cityOf({{{15, 0, 0}, {35, 10, 30}}});
    const ShadowOutlines outlines = outlined(before, &after, southSun());
    EXPECT_NEAR(area(outlines.baseline), 600, 0.01);
    EXPECT_NEAR(area(outlines.incremental), 15 * 30, 0.01);
    EXPECT_NEAR(area(outlines.gained), 15 * 30, 0.01);
    EXPECT_NEAR(bounds(outlines.incremental.front()).low.x, 20, 1e-3);
    EXPECT_NEAR(bounds(outlines.gained.front()).high.x, 15, 1e-3);
}

TEST(ShadowOutlines, GroundThatTheProposalCoversIsLeftOutOfTheBaseline) {
    // A box of 20 m x 10 m stands in the shadow of another one: its footprint is not open ground.
    City before = cityOf({{{0, 0, 0}, {20, 10, 30}}}), after = before;
    after.buildings.push_back(buildingOf({{0, 15, 0}, {20, 25, 5}}));
    const ShadowOutlines outlines = outlined(before, &after, southSun());
    EXPECT_NEAR(area(outlines.baseline), 600 - 200, 0.01);
    EXPECT_TRUE(outlines.incremental.empty());
    EXPECT_TRUE(outlines.gained.empty());
}

TEST(ShadowOutlines, AnUnchangedScenarioChangesNothing) {
    const City city = cityOf(randomBoxes(3, 6));
    const City same = city;
    const ShadowOutlines outlines = outlined(city, &same, stepAt(150, 30));
    EXPECT_FALSE(outlines.baseline.empty());
    EXPECT_TRUE(outlines.incremental.empty() && outlines.gained.empty());
}

TEST(ShadowOutlines, AreCutAtTheAreasEdges) {
    // Of the shadow from y = 10 to 40 the part up to y = 25, and x from 5 to 20.
    const OutlineSettings settings{{{5, -50}, {100, 25}}};
    EXPECT_NEAR(baselineArea(cityOf({{{0, 0, 0}, {20, 10, 30}}}), southSun(), settings), 15 * 15, 0.01);
}

TEST(ShadowOutlines, ABuildingOutsideTheAreaShadesIt) {
    // 100 m high, 80 m south of the area: its shadow covers the area's first 20 m.
    const OutlineSettings settings{{{0, 80}, {10, 180}}};
    EXPECT_NEAR(baselineArea(cityOf({{{-5, -10, 0}, {15, 0, 100}}}), southSun(), settings), 10 * 20, 0.01);
}

TEST(ShadowOutlines, ALowSunCastsShadowsOfManyKilometres) {
    EXPECT_NEAR(baselineArea(cityOf({{{0, 0, 0}, {20, 10, 30}}}), stepAt(180, 0.01)), 20 * (300 - 10), 0.1);
}

City mixedCity(std::uint32_t seed) {
    City city = cityOf(randomBoxes(seed, 5));
    const Ring court = rectangle(150, 20, 170, 40);
    city.buildings.push_back(
        buildingOf({rectangle(140, 10, 185, 50), {Ring(court.rbegin(), court.rend())}}, 0, 14));
    city.buildings.push_back(buildingOf({{{150, 70}, {180, 73}, {178, 100}, {165, 80}, {152, 102}}, {}}, 8,
                                        20, true));  // a concave overhang
    city.buildings.push_back(gabledHouse(150, 120, 170, 132, 6, 11));
    return city;
}

double lengthOf(const std::vector<Footprint>& polygons) {
    double sum = 0;
    const auto add = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i)
            sum += glm::distance(glm::dvec2(ring[i]), glm::dvec2(ring[(i + 1) % ring.size()]));
    };
    for (const Footprint& polygon : polygons) {
        add(polygon.outer);
        std::ranges::for_each(polygon.holes, add);
    }
    return sum;
}

// Rays begin 1 mm above the ground, and a hair aside of the centre of the cell.
bool isBesideOutline(const std::vector<Footprint>& polygons, glm::dvec2 point) {
    const auto inside = [&](glm::dvec2 at) {
        return std::ranges::any_of(polygons, [&](const Footprint& polygon) { return contains(polygon, at); });
    };
    const double awayM = 0.02;
    return inside(point + awayM) != inside(point - awayM) ||
           inside(point + glm::dvec2(awayM, -awayM)) != inside(point + glm::dvec2(-awayM, awayM));
}

TEST(ShadowOutlines, AgreeWithProjectedShadowsOnCells) {
    const double cellM = 0.5;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> azimuth(0, 360), altitude(4, 80);
    for (std::uint32_t round = 0; round < 40; ++round) {
        const City before = mixedCity(round + 1);
        City after = before;
        after.buildings.erase(after.buildings.begin() + 3);
        after.buildings.push_back(buildingOf({{60.3, 60.7, 0}, {81.1, 77.9, 55}}));
        const SunStep step = stepAt(azimuth(random), altitude(random));
        const Box2 box{{-10, -10}, {200, 150}};
        const ShadowOutlines outlines = outlined(before, &after, step, {box});
        const City* const cities[]{&before, &after};
        const Place place{.name = "all", .polygons = makeRegionFromLocalBox(box).polygons};
        const auto cells = placeReceiversOnPlaces(cities, std::span(&place, 1), {cellM}).value();
        SunSteps sun;
        sun.steps = {step};
        sun.days = {{.first = 0, .count = 1}};
        std::vector<StepMasks> masks;
        NoProgress progress;
        const auto take = [&](std::size_t, std::span<StepMasks> day) -> Result<void> {
            masks.assign(day.begin(), day.end());
            return {};
        };
        ASSERT_TRUE(ProjectedShadows().shadeSteps(cities, cells.receivers, sun, take, progress, {}));
        const auto agrees = [&](const std::vector<Footprint>& polygons, const StepMasks& shaded,
                                const StepMasks* lit) {
            std::vector<std::uint8_t> inside(cells.receivers.grid.size());
            for (const Footprint& polygon : polygons) {
                forEachRun(polygon, cells.receivers.grid, [&](int row, int first, int end) {
                    for (int column = first; column < end; ++column)
                        inside[cells.receivers.grid.index(column, row)] = 1;
                });
                EXPECT_TRUE(isValid(polygon)) << round;
            }
            std::size_t dark = 0, different = 0;
            for (std::size_t i = 0; i < cells.receivers.cells.size(); ++i) {
                const std::uint32_t cell = cells.receivers.cells[i];
                const bool isDark = shaded.shaded(0, i) && !(lit != nullptr && lit->shaded(0, i));
                dark += isDark;
                different += isDark != (inside[cell] != 0) &&
                             !isBesideOutline(polygons, glm::dvec2(cells.receivers.position(cell)));
            }
            EXPECT_EQ(different, 0U) << round << " at " << step.azimuthDeg << ", " << step.altitudeDeg;
            // An outline along the cells' edges may be off by half a cell all along.
            EXPECT_NEAR(area(polygons), double(dark) * cellM * cellM, 1 + cellM / 2 * lengthOf(polygons));
        };
        agrees(outlines.baseline, masks[0], nullptr);
        agrees(outlines.incremental, masks[1], &masks[0]);
        agrees(outlines.gained, masks[0], &masks[1]);
    }
}

TEST(ShadowOutlines, DoNotOverlapEachOther) {
    const City before = mixedCity(11);
    City after = before;
    after.buildings.push_back(buildingOf({{60.3, 60.7, 0}, {81.1, 77.9, 95}}));
    const ShadowOutlines outlines = outlined(before, &after, stepAt(160, 25));
    const auto inside = [](const std::vector<Footprint>& polygons, glm::dvec2 point) {
        return std::ranges::count_if(polygons, [&](const Footprint& f) { return contains(f, point); });
    };
    std::mt19937 random(5);
    std::uniform_real_distribution<double> at(-50, 250);
    std::size_t incremental = 0;
    for (int i = 0; i < 20000; ++i) {
        const glm::dvec2 point(at(random), at(random));
        const auto dark = inside(outlines.baseline, point), more = inside(outlines.incremental, point);
        EXPECT_LE(dark + more, 1);
        incremental += std::size_t(more);
    }
    EXPECT_GT(incremental, 100U);
}

TEST(ShadowOutlines, FollowCellsOnTerrain) {
    // A plane that rises to the north by 1 in 2; a box of 20 m x 10 m whose top is at z = 40. The sun in the
    // south at 45 deg: above y = 10, ground and sunbeam meet where 0.5 y = 40 - (y - 10), at y = 33.33.
    City city = groundOf(41, [](glm::dvec2 place) { return place.y / 2; });
    city.buildings.push_back(buildingOf({rectangle(0, 0, 20, 10), {}}, -1, 40));
    const ShadowOutlines outlines = outlined(city, nullptr, southSun(), {{{-50, -50}, {100, 100}}, 0.5});
    EXPECT_EQ(outlines.cellM, 0.5);
    ASSERT_EQ(outlines.baseline.size(), 1U);
    EXPECT_NEAR(area(outlines.baseline), 20 * 23.333, 20 * 0.5);
    EXPECT_NEAR(bounds(outlines.baseline.front()).high.y, 33.333, 0.5);
    EXPECT_EQ(outlines.baseline.front().outer.size(), 4U);
}

TEST(ShadowOutlines, OnFlatTerrainTellIncrementalFromGained) {
    City before = groundOf(41, [](glm::dvec2) { return 0; }), after = before;
    before.buildings.push_back(buildingOf({{0, 0, 0}, {20, 10, 30}}));
    after.buildings.push_back(buildingOf({{15, 0, 0}, {35, 10, 30}}));
    const ShadowOutlines outlines = outlined(before, &after, southSun(), {{{-50, -50}, {100, 100}}, 1});
    EXPECT_NEAR(area(outlines.baseline), 600, 21);
    EXPECT_NEAR(area(outlines.incremental), 450, 16);
    EXPECT_NEAR(area(outlines.gained), 450, 16);
}

TEST(ShadowOutlines, OnAPlaneOnlyWhatStandsAboveItCasts) {
    // 20 m wide and 30 m high, on a plane 10 m up: 20 x 20 m north of it. A house of 8 m is below the plane.
    const std::vector<Box3> boxes{{{0, 0, 0}, {20, 10, 30}}, {{40, 0, 0}, {60, 10, 8}}};
    EXPECT_NEAR(baselineArea(cityOf(boxes), southSun(), {wide, 1, 10}), 400, 0.01);
    City level = groundOf(41, [](glm::dvec2) { return 0; });
    for (const Box3& box : boxes) level.buildings.push_back(buildingOf(box));
    const ShadowOutlines traced = outlined(level, nullptr, southSun(), {{{-50, -50}, {100, 100}}, 1, 10});
    EXPECT_EQ(traced.cellM, 1);
    EXPECT_NEAR(area(traced.baseline), 400, 21);
}

TEST(ShadowOutlines, OnAPlaneMeshesAreTraced) {
    // A pyramid 40 m wide and 30 m high. The plane 1 m up cuts it in a square that ends 19.33 m north of its
    // middle, and the tip falls 29 m north: a triangle 38.67 m wide. Of it, what lies beyond the footprint
    // (20 m) is 9 m high and 38.67 x 9 / 9.67 = 36 m wide: 162 m2. On a plane 15 m up it ends at 15 m.
    City city;
    city.buildings.push_back(pyramid(20, 30));
    const auto areaOn = [&](double planeM) {
        return baselineArea(city, southSun(), {{{-60, -60}, {60, 60}}, 0.5, planeM});
    };
    EXPECT_NEAR(areaOn(1), 162, 8);
    EXPECT_EQ(areaOn(15), 0);
}

TEST(ShadowOutlines, SeveralStepsGiveWhatEachGivesAlone) {
    const City city = mixedCity(2);
    const std::vector<SunStep> steps = oneDay({{100, 20}, {180, 50}, {250, 15}}).steps;
    NoProgress progress;
    const auto all = outlineShadows(city, nullptr, steps, {wide}, progress, {}).value();
    ASSERT_EQ(all.size(), steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i)
        EXPECT_EQ(area(all[i].baseline), baselineArea(city, steps[i])) << i;
}

TEST(ShadowOutlines, RefuseAnEmptyAreaAndStopWhenAsked) {
    const City city = cityOf({{{0, 0, 0}, {20, 10, 30}}});
    NoProgress progress;
    const auto empty = outlineShadows(city, nullptr, southSun(), {Box2{}}, progress, {});
    ASSERT_FALSE(empty);
    EXPECT_NE(empty.error().text().find("area"), std::string::npos);
    std::stop_source stop;
    stop.request_stop();
    const auto stopped = outlineShadows(city, nullptr, southSun(), {wide}, progress, stop.get_token());
    ASSERT_FALSE(stopped);
    EXPECT_TRUE(isCancelled(stopped.error()));
}

}  // namespace
}  // namespace noonmark
