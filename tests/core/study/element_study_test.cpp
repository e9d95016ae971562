#include "core/study/elements/element_study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/city/trees/tree.h"
#include "core/io/read_city.h"
#include "core/study/elements/element_map.h"
#include "core/study/elements/element_tables.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/shared/shared_data.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;

// Two houses at the latitude of New York, named "Alma" and "Bert, junior".
City twoHouses() {
    City city = cityOf({{{0, 0, 0}, {12, 12, 9}}, {{20, 0, 0}, {32, 12, 30}}});
    city.frame = Frame({-73.98, 40.75});
    std::size_t index = 0;
    for (const char* name : {"Alma", "Bert, junior"}) {
        Building building = *city.buildings[index];
        building.name = name;
        building.sourceId = "way " + std::to_string(index + 1);
        city.buildings[index++] = std::make_shared<const Building>(building);
    }
    return city;
}

StudySettings ofOneDay(const Region& region) {
    StudySettings settings;
    settings.region = region;
    settings.period = {.start = std::chrono::year(2026) / 3 / 21,
                       .days = 1,
                       .stepMinutes = 1,
                       .window = SolarHours{},
                       .zone = "America/New_York"};
    return settings;
}

const Region aroundHouses = makeRegionFromLocalBox({{-50, -50}, {80, 60}});

Result<ElementStudy> measure(const City& city, const ElementSettings& elements,
                             const StudySettings& settings = ofOneDay(aroundHouses)) {
    NoProgress quiet;
    return runElementStudy(city, settings, elements, quiet, {});
}

// Alma behind a dense tree, 7 m in front of its southern wall, bare before June.
City behindATree() {
    City city = twoHouses();
    city.trees = std::make_shared<const Trees>(Trees{{{.sourceId = "plane",
                                                       .place = {6, -7},
                                                       .heightM = 12,
                                                       .crownBaseM = 1,
                                                       .crownDiameterM = 10,
                                                       .leafOnTransmissivity = 0.05F,
                                                       .leafOffTransmissivity = 0.7F}},
                                                     {152, 300}});
    return city;
}

TEST(ElementStudy, ATreeBeforeAWallTakesItsSun) {
    const ElementStudy study = measure(behindATree(), {.buildings = {"Alma"}}).value();
    const ElementMap map = makeElementMap(study);
    for (const MeasuredElement& element : map.elements) {
        ASSERT_EQ(element.withTrees.size(), 2U) << "evergreen and seasonal";
        const ShadedMinutes &green = element.withTrees[0], &season = element.withTrees[1];
        EXPECT_LE(green.sunlitMin, season.sunlitMin);
        EXPECT_LE(season.sunlitMin, element.sunlitMin);
        EXPECT_NEAR(green.grossMin, map.possibleMin - green.sunlitMin, 1e-6);
        EXPECT_NEAR(green.monthMin[2], green.sunlitMin, 1e-3) << "one day of March";
        if (element.normal.y > 0.9F) {
            EXPECT_EQ(green.sunlitMin, element.sunlitMin) << "of the north wall";
        }
        if (element.normal.y > -0.9F || element.floor != 0) continue;
        EXPECT_LT(green.sunlitMin, 0.9 * element.sunlitMin) << "of the south wall, " << element.id;
        EXPECT_LT(season.sunlitMin, element.sunlitMin);
    }
    EXPECT_THAT(study.warnings, testing::IsEmpty());
    const auto json = nlohmann::json::parse(elementStudyJson(study, {}));
    EXPECT_LT(json.at("mean_sunlit_min_evergreen"), json.at("mean_sunlit_min_seasonal"));
    EXPECT_LT(json.at("mean_sunlit_min_seasonal"), json.at("mean_sunlit_min"));
    EXPECT_EQ(json.at("trees").at("used"), 1);
    EXPECT_TRUE(json.at("definitions").contains("mean_gross_min_seasonal"));
    EXPECT_THAT(toCsv(makeElementTable(study)),
                HasSubstr(",sunlit_min_evergreen,sunlit_pct_evergreen,gross_min_evergreen,"
                          "continuous_min_evergreen,longest_sun_min_evergreen,sunlit_min_03_evergreen,"));

    const ElementMap seasonal = inColumn(map, TreeColumns::seasonal).value();
    EXPECT_EQ(seasonal.elements[0].sunlitMin, map.elements[0].withTrees[1].sunlitMin);
    EXPECT_EQ(seasonal.column, TreeColumns::seasonal);
    EXPECT_FALSE(inColumn(seasonal, TreeColumns::seasonal)) << "it is of that column alone";
    EXPECT_FALSE(inColumn(map, TreeColumns::without));

    StudySettings without = ofOneDay(aroundHouses);
    without.trees = TreeColumns::without;
    const ElementStudy bare = measure(behindATree(), {.buildings = {"Alma"}}, without).value();
    EXPECT_FALSE(bare.trees);
    EXPECT_EQ(bare.minutes.sunlitMin, study.minutes.sunlitMin);
}

TEST(ElementStudy, FacadesOfNamedBuildings) {
    // Alma: 4 walls, 4 bays, 3 storeys; Bert: 9 storeys.
    EXPECT_EQ(measure(twoHouses(), {})->receivers.size(), 48U + 144U);
    EXPECT_EQ(measure(twoHouses(), {.buildings = {"alma"}})->receivers.size(), 48U);
    EXPECT_EQ(measure(twoHouses(), {.buildings = {"Bert, junior"}})->receivers.size(), 144U);
    EXPECT_EQ(measure(twoHouses(), {.buildings = {"way 2,ALMA"}})->receivers.size(), 192U);
    const auto unknown = measure(twoHouses(), {.buildings = {"bert"}});
    ASSERT_FALSE(unknown);
    EXPECT_THAT(unknown.error().text(), HasSubstr("no building 'bert'"));
    EXPECT_THAT(unknown.error().advice, HasSubstr("Bert, junior"));
    EXPECT_FALSE(measure(twoHouses(), {.buildings = {""}}));
    EXPECT_FALSE(measure(twoHouses(), {}, ofOneDay(makeRegionFromLocalBox({{-50, -50}, {-40, -40}}))));
}

// On 21 March the sun is up for 12 h 10 min. A southern wall sees it nearly all day, a northern one almost
// never, and eastern and western ones half of it each; Alma's eastern wall loses the morning to Bert.
TEST(ElementStudy, WallsGetTheSunOfTheirSide) {
    const ElementStudy study = measure(twoHouses(), {}).value();
    const ElementTable table = makeElementTable(study);
    const auto column = [&](const char* name) {
        return std::size_t(std::ranges::find(table.columns, name, &ElementColumn::name) -
                           table.columns.begin());
    };
    const std::size_t azimuth = column("azimuth_deg"), sunlit = column("sunlit_min"),
                      building = column("building_name"), month = column("sunlit_min_03");
    ASSERT_LT(month, table.columns.size());
    EXPECT_EQ(column("sunlit_min_04"), table.columns.size());
    for (const auto& row : table.rows) {
        const double facing = std::get<double>(row[azimuth]), minutes = std::get<double>(row[sunlit]);
        const bool isAlma = std::get<std::string>(row[building]) == "Alma";
        const double open = std::abs(facing - 180) < 1                                ? 720
                            : std::abs(facing - 270) < 1 || std::abs(facing - 90) < 1 ? 365
                                                                                      : 5;
        // The houses shade the walls that face each other: Bert all of Alma's, Alma the lower part of Bert's.
        const bool isAlmasEast = isAlma && std::abs(facing - 90) < 1;
        const bool isBertsWest = !isAlma && std::abs(facing - 270) < 1;
        EXPECT_LT(minutes, isAlmasEast ? 330 : open + 20) << facing;
        if (!isAlmasEast && !isBertsWest) {
            EXPECT_GT(minutes, open - 25) << facing;
        }
        EXPECT_FLOAT_EQ(float(minutes), float(std::get<double>(row[month])));
    }
}

TEST(ElementStudy, RaysAndHorizonsAgree) {
    StudySettings rays = ofOneDay(aroundHouses);
    rays.engine = "ray";
    const ElementStudy traced = measure(twoHouses(), {}, rays).value();
    const ElementStudy swept = measure(twoHouses(), {}).value();
    EXPECT_EQ(traced.engineKey, "ray");
    EXPECT_FALSE(traced.error);
    ASSERT_TRUE(swept.error);
    EXPECT_EQ(swept.error->points, 192U);
    double maximum = 0;
    for (std::size_t i = 0; i < swept.receivers.size(); ++i)
        maximum = std::max(maximum, std::abs(swept.minutes.sunlitOf(i) - traced.minutes.sunlitOf(i)));
    EXPECT_NEAR(swept.error->gross.largestPct, 100 * maximum / swept.minutes.possibleMin, 1e-6);
    EXPECT_LT(maximum, 5);  // of some four edges a day, up to an eighth of a degree each
}

TEST(ElementStudy, PlanesAndRefusals) {
    const ElementStudy plane =
        measure(twoHouses(), {.places = ElementPlaces::plane, .planeHeightM = 4}).value();
    EXPECT_EQ(plane.receivers.size(), std::size_t(130 * 110 - 2 * 144));
    ASSERT_EQ(plane.warnings.size(), 1U);
    EXPECT_THAT(plane.warnings[0].where, HasSubstr("288 cells"));
    StudySettings settings = ofOneDay(aroundHouses);
    settings.engine = "sam";
    const auto refused = measure(twoHouses(), {}, settings);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::unsupported);
    settings = ofOneDay(aroundHouses);
    settings.period.days = 0;
    EXPECT_FALSE(measure(twoHouses(), {}, settings));
}

TEST(ElementStudy, WindowsOfAFile) {
    const TemporaryFolder folder;
    const City city = twoHouses();
    const LonLat at = city.frame.lonLatFromLocal({6, 0});
    const auto file = folder.file(
        "windows.geojson",
        R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"id":"=1+1"},"geometry":)"
        R"({"type":"Point","coordinates":[)" +
            std::to_string(at.lonDeg) + "," + std::to_string(at.latDeg) + ",4.5]}}]}");
    const ElementStudy study = measure(city, {.places = ElementPlaces::windows, .windows = file}).value();
    ASSERT_EQ(study.receivers.size(), 1U);
    EXPECT_NEAR(study.receivers.points.normals[0].y, -1, 1e-6);
    const std::string csv = toCsv(makeElementTable(study));
    EXPECT_THAT(csv, HasSubstr("\n'=1+1,window,way 1,Alma,1,180."));
    const auto json = nlohmann::json::parse(elementStudyJson(study, {}));
    EXPECT_EQ(json["receivers"], 1);
    EXPECT_EQ(json["elements"]["receivers_on"], "windows");
    EXPECT_GT(json["mean_sunlit_min"], 690);
}

TEST(ElementStudy, StatesTheErrorOfEachQuantity) {
    const ElementStudy study = measure(twoHouses(), {}).value();
    ASSERT_TRUE(study.error);
    const auto json = nlohmann::json::parse(elementStudyJson(study, {}));
    for (const char* quantity : {"gross", "continuous", "longest_sun"})
        for (const char* figure : {"mean_pct", "p99_pct", "max_pct"})
            EXPECT_TRUE(json["error"][quantity][figure].is_number()) << quantity << " " << figure;
    const double twoStepsPct = 200 / longestDayMinutes(study.sun);
    EXPECT_LE(study.error->continuous.largestPct, twoStepsPct + 1e-3);
    EXPECT_LE(study.error->longestSun->largestPct, twoStepsPct + 1e-3);
    EXPECT_THAT(describe(*study.error), HasSubstr("longest sun"));
}

// Facades of real buildings, every minute of a day, against rays: the errors that docs/user/limits.md states.
void expectNearRays(const char* data, float halfM, const char* zone) {
    const auto file = sharedData(data);
    if (!file) GTEST_SKIP() << "the shared data is missing";
    NoProgress quiet;
    const City city = readCity({*file}, {}, quiet, {}).value().city;
    const glm::vec2 middle = (bounds(city).low + bounds(city).high) / 2.0F;
    StudySettings settings = ofOneDay(makeRegionFromLocalBox({middle - halfM, middle + halfM}));
    settings.period.zone = zone;
    settings.errorSample.receivers = 2000;
    const auto study = measure(city, {.facades = {.bayM = 6, .storeyM = 6}}, settings);
    ASSERT_TRUE(study) << study.error().text();
    ASSERT_TRUE(study->error);
    EXPECT_GT(study->error->points, 500U);
    testing::Test::RecordProperty("points", int(study->error->points));
    testing::Test::RecordProperty("mean_ppm", int(1e4 * study->error->gross.meanPct));
    testing::Test::RecordProperty("largest_ppm", int(1e4 * study->error->gross.largestPct));
    testing::Test::RecordProperty("run_mean_ppm", int(1e4 * study->error->continuous.meanPct));
    testing::Test::RecordProperty("run_largest_ppm", int(1e4 * study->error->continuous.largestPct));
    EXPECT_LT(study->error->gross.meanPct, 0.1);
    EXPECT_LT(study->error->gross.largestPct, 1);
}

TEST(ElementStudy, FacadesOfMidtownAreNearRays) {
    expectNearRays("midtown_manhattan/midtown_manhattan.osm.pbf", 150, "America/New_York");
}

TEST(ElementStudy, FacadesOfDelfshavenAreNearRays) {
    expectNearRays("delfshaven/3-20-DELFSHAVEN.city.json", 200, "Europe/Amsterdam");
}

}  // namespace
}  // namespace noonmark
