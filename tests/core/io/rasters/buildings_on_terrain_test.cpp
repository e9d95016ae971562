#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <cmath>

#include "core/city/city.h"
#include "core/geo/frame.h"
#include "core/io/read_city.h"
#include "core/io/terrain/buildings_on_terrain.h"
#include "core/sun/sun_steps.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/io/cityjson_fixtures.h"

namespace noonmark {

namespace {

// A slope that rises by one metre in ten towards the east, with a pit in the middle of the map.
Terrain slope() {
    Terrain terrain{{-100, -100, 2, 100, 100}, {}};
    for (int row = 0; row < 100; ++row)
        for (int column = 0; column < 100; ++column) {
            const glm::dvec2 centre = terrain.grid.centre(column, row);
            const bool pit = std::abs(centre.x) < 3 && std::abs(centre.y) < 3;
            terrain.elevationM.push_back(pit ? -20.0F : float(centre.x / 10));
        }
    return terrain;
}

Building tower(float west, float bottom, float top) {
    Building building;
    building.parts.push_back({.footprint = {{{west, -10}, {west + 20, -10}, {west + 20, 10}, {west, 10}}, {}},
                              .bottomM = bottom,
                              .topM = top});
    return building;
}

TEST(StandOnTerrain, LiftsByTheLowestGround) {
    const Terrain terrain = slope();
    const Building placed = standOnTerrain(tower(40, 0, 30), std::nullopt, &terrain);
    EXPECT_NEAR(placed.parts[0].bottomM, 4, 1e-3);
    EXPECT_NEAR(placed.parts[0].topM, 34, 1e-3);
}

TEST(StandOnTerrain, FindsThePitInsideTheOutline) {
    const Terrain terrain = slope();
    EXPECT_FLOAT_EQ(findLowestGround(tower(-10, 0, 30), terrain), -20);
}

TEST(StandOnTerrain, AGroundOfItsOwnStaysAndWallsGoDown) {
    const Terrain terrain = slope();
    const Building placed = standOnTerrain(tower(40, 7, 37), 7.0F, &terrain);
    EXPECT_NEAR(placed.parts[0].bottomM, 4, 1e-3);
    EXPECT_NEAR(placed.parts[0].topM, 37, 1e-3);  // minus a little for the earth's curvature
    Building overhanging = tower(40, 12, 37);
    overhanging.parts[0].isOverhanging = true;
    EXPECT_NEAR(standOnTerrain(overhanging, 7.0F, &terrain).parts[0].bottomM, 12, 1e-3);
}

TEST(StandOnTerrain, WithoutTerrainTheGroundIsFlat) {
    const Building placed = standOnTerrain(tower(40, 7, 37), 7.0F, nullptr);
    EXPECT_FLOAT_EQ(placed.parts[0].bottomM, 0);
    EXPECT_FLOAT_EQ(placed.parts[0].topM, 30);
    EXPECT_FLOAT_EQ(standOnTerrain(tower(40, 0, 30), std::nullopt, nullptr).parts[0].topM, 30);
}

TEST(StandOnTerrain, ABuildingSmallerThanACellStandsToo) {
    const Terrain terrain = slope();
    Building shed;
    shed.parts.push_back(
        {.footprint = {{{50, 50}, {50.1F, 50}, {50.1F, 50.1F}}, {}}, .bottomM = 0, .topM = 3});
    EXPECT_NEAR(standOnTerrain(shed, std::nullopt, &terrain).parts[0].bottomM, 5, 0.01);
}

TEST(StandOnTerrain, AMeshMovesWithItsPart) {
    Building building = tower(40, 7, 37);
    building.parts[0].mesh = std::make_shared<const TriangleMesh>(meshOf(building.parts[0]));
    const Terrain terrain = slope();
    const Part onFlat = standOnTerrain(building, 7.0F, nullptr).parts[0];
    EXPECT_FLOAT_EQ(onFlat.bottomM, 0);
    for (const glm::vec3 vertex : onFlat.mesh->vertices)
        EXPECT_TRUE(vertex.z == 0 || vertex.z == 30) << vertex.z;
    // On terrain it keeps its own elevations: the walls of a mesh cannot be extended.
    const Part onTerrain = standOnTerrain(building, 7.0F, &terrain).parts[0];
    EXPECT_NEAR(onTerrain.bottomM, 7, 1e-3);
    for (const glm::vec3 vertex : onTerrain.mesh->vertices)
        EXPECT_TRUE(std::abs(vertex.z - 7) < 1e-3F || std::abs(vertex.z - 37) < 1e-3F) << vertex.z;
}

}  // namespace

}  // namespace noonmark

namespace noonmark::tests {

namespace {

using testing::HasSubstr;

constexpr int side = 12;
constexpr double spacingM = 30, houseM = 12;

// The ground of the town: it rises by 1 in 8 to the east and falls by 1 in 20 to the north.
double hillside(double x, double y) { return 400 + x / 8 - y / 20; }

// Houses in rows, 9 m high, each on a flat base at the height of the ground under its middle.
Json town(double (*ground)(double, double)) {
    CityJsonMaker maker;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const glm::dvec2 low(column * spacingM, row * spacingM), high = low + houseM;
            const double base = ground(low.x + houseM / 2, low.y + houseM / 2);
            maker.addBuilding(fmt::format("{}-{}", column, row),
                              maker.boxSolid({low.x, low.y, base}, {high.x, high.y, base + 9}));
        }
    return maker.document();
}

CityRead readTown(double (*ground)(double, double), TerrainFromBases wanted = TerrainFromBases::automatic) {
    const TemporaryFolder folder;
    NoProgress progress;
    return readCity({folder.file("town.city.json", town(ground).dump())}, {.terrainFromBases = wanted},
                    progress, {})
        .value();
}

bool warns(const CityRead& read, std::string_view what) {
    return std::ranges::any_of(
        read.warnings, [&](const Warning& warning) { return warning.what.find(what) != std::string::npos; });
}

const Building& buildingOf(const CityRead& read, const std::string& id) {
    return **std::ranges::find_if(read.city.buildings, [&](const auto& one) { return one->sourceId == id; });
}

// Halfway between a house and its eastern neighbour, the ground's height is the mean of their bases.
TEST(TerrainFromBases, AHillTownGetsItsGround) {
    const CityRead read = readTown(hillside);
    ASSERT_TRUE(read.city.terrain);
    EXPECT_EQ(read.city.terrain->source.method, TerrainMethod::fromBases);
    EXPECT_EQ(read.city.terrain->source.sourcePoints, std::size_t(4 * side * side));
    EXPECT_TRUE(warns(read, "interpolated from their bases"));
    EXPECT_FALSE(warns(read, "the ground is flat"));
    for (int row = 0; row < side; ++row)
        for (int column = 0; column + 1 < side; ++column) {
            const Building& here = buildingOf(read, fmt::format("{}-{}", column, row));
            const Building& east = buildingOf(read, fmt::format("{}-{}", column + 1, row));
            const double base = double(here.parts[0].bottomM), next = double(east.parts[0].bottomM);
            EXPECT_NEAR(next - base, spacingM / 8, 0.01);
            const Box2 a = bounds(here), b = bounds(east);
            const glm::dvec2 between = glm::dvec2(a.low + a.high + b.low + b.high) / 4.0,
                             inside = glm::dvec2(a.low + a.high) / 2.0;
            EXPECT_NEAR(elevationAt(*read.city.terrain, between), (base + next) / 2, 0.35)
                << column << ' ' << row;
            EXPECT_NEAR(elevationAt(*read.city.terrain, inside), base, 0.15);
        }
}

TEST(TerrainFromBases, TheUserMayWantItFlat) {
    const CityRead read = readTown(hillside, TerrainFromBases::never);
    EXPECT_FALSE(read.city.terrain);
    EXPECT_TRUE(warns(read, "the ground is flat"));
    for (const auto& building : read.city.buildings) EXPECT_EQ(building->parts[0].bottomM, 0);
}

// Bases that differ by half a metre, as surveyed kerbs do.
double nearlyFlat(double x, double y) { return 400 + 0.25 * (std::sin(x) + std::cos(y)); }

TEST(TerrainFromBases, AFlatTownStaysFlatUnlessAskedFor) {
    EXPECT_FALSE(readTown(nearlyFlat).city.terrain);
    const CityRead asked = readTown(nearlyFlat, TerrainFromBases::always);
    ASSERT_TRUE(asked.city.terrain);
    EXPECT_TRUE(warns(asked, "interpolated from their bases"));
}

TEST(TerrainFromBases, ReliefIsThatOfNeighbours) {
    std::vector<std::shared_ptr<const Building>> houses;
    std::vector<BasedBuilding> based;
    // Two rows of five, 60 m apart; the last column 3 m higher, and one separate house 500 m away, 50 m
    // higher.
    const auto add = [&](float x, float y, float groundM) {
        houses.push_back(tests::buildingOf({rectangle(x, y, x + 10, y + 10), {}}, groundM, groundM + 8));
        based.push_back({houses.back().get(), groundM});
    };
    for (int column = 0; column < 5; ++column)
        for (int row = 0; row < 2; ++row)
            add(float(column) * 60, float(row) * 60 + float(column % 2) * 0.01F, column == 4 ? 3 : 0);
    add(2000, 0, 50);
    const BaseRelief relief = measureRelief(based);
    // Across the rows, along the rows, and one diagonal per square
    EXPECT_EQ(relief.pairs, 5U + 2U * 4U + 4U);
    EXPECT_EQ(relief.uneven, 3U);
    EXPECT_DOUBLE_EQ(relief.maxM, 3);
    EXPECT_TRUE(relief.matters());
    EXPECT_FALSE(measureRelief({}).matters());
    EXPECT_FALSE(interpolateBases({}));
}

// Compared with the hillside itself: the streets of a flat town have other shadows.
TEST(TerrainFromBases, TheTownsShadowsAreThoseOfTheHillside) {
    const CityRead made = readTown(hillside), flat = readTown(hillside, TerrainFromBases::never);
    ASSERT_TRUE(made.city.terrain);
    City truth = made.city;
    Terrain ground{PostGrid(-400, -400, 4, 200, 200), {}};
    const Building& corner = buildingOf(made, "0-0");
    const glm::dvec2 middle = glm::dvec2(bounds(corner).low + bounds(corner).high) / 2.0;
    for (int row = 0; row < 200; ++row)
        for (int column = 0; column < 200; ++column) {
            const glm::dvec2 at = ground.grid.centre(column, row), way = at - middle;
            ground.elevationM.push_back(float(double(corner.parts[0].bottomM) + way.x / 8 - way.y / 20));
        }
    truth.terrain = std::make_shared<const Terrain>(std::move(ground));
    Period period;
    period.start = {std::chrono::year{2026}, std::chrono::March, std::chrono::day{21}};
    period.from = std::chrono::hours(6);
    period.hours = 12;
    period.stepMinutes = 5;
    const SunSteps sun = computeSunSteps(period, {truth.frame.origin(), 0, 1010, 10}, {}).value();
    const Receivers onTruth = receiversOver(truth, -100, -100, 100, 100, 3),
                    onMade = receiversOver(made.city, -100, -100, 100, 100, 3),
                    onFlat = receiversOver(flat.city, -100, -100, 100, 100, 3);
    const ShadowField a = traced(truth, onTruth, sun), b = traced(made.city, onMade, sun),
                      c = traced(flat.city, onFlat, sun);
    double madeOff = 0, flatOff = 0, cells = 0;
    for (std::size_t i = 0; i < onTruth.kind.size(); ++i) {
        if (onTruth.kind[i] != CellKind::ground || onMade.kind[i] != CellKind::ground ||
            onFlat.kind[i] != CellKind::ground)
            continue;
        madeOff += std::abs(double(b.grossMin[i] - a.grossMin[i]));
        flatOff += std::abs(double(c.grossMin[i] - a.grossMin[i]));
        ++cells;
    }
    std::printf("minutes a day off the hillside's, %.0f cells: flattened %.2f, terrain from bases %.2f\n",
                cells, flatOff / cells, madeOff / cells);
    EXPECT_GT(cells, 2000);
    EXPECT_GT(flatOff / cells, 5);
    EXPECT_LT(madeOff / cells, flatOff / cells / 4);
}

}  // namespace

}  // namespace noonmark::tests
