#include "core/study/study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/city/map_context.h"
#include "core/lab/lab_engines.h"
#include "core/study/text/error_text.h"

namespace noonmark {
namespace {

using testing::HasSubstr;

Ring squareRing(float x, float y, float side) {
    return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

// One tower of 30 m and, 5 km to the north, one that cannot affect the result.
City towers() {
    City city{.frame = Frame({-73.98, 40.75})};
    Building near{.sourceId = "near"};
    near.parts.push_back({.footprint = {squareRing(0, 0, 10), {}}, .topM = 30});
    Building far{.sourceId = "far"};
    far.parts.push_back({.footprint = {squareRing(0, 5000, 10), {}}, .topM = 30});
    city.buildings = {std::make_shared<const Building>(near), std::make_shared<const Building>(far)};
    return city;
}

StudySettings aroundTheTower() {
    StudySettings settings;
    settings.region = makeRegionFromLocalBox({{-50, -50}, {60, 60}});
    settings.receivers.cellM = 2;
    settings.engine = "ray";
    settings.period.zone = "America/New_York";
    settings.period.stepMinutes = 10;
    return settings;
}

Result<Study> run(const StudySettings& settings) {
    NoProgress progress;
    return runStudy(towers(), settings, progress, {}, coreAndLabEngines());
}

std::string errorOf(const Result<Study>& study) { return study ? "no error" : study.error().text(); }

TEST(RunStudy, FillsEveryPart) {
    const auto study = run(aroundTheTower());
    ASSERT_TRUE(study) << errorOf(study);
    EXPECT_EQ(study->receivers.cells.size(), 55U * 55U - 25U);
    EXPECT_EQ(study->statistics.receivers, study->receivers.cells.size());
    EXPECT_EQ(study->sun.steps.size(), 36U);
    EXPECT_EQ(study->field.cost.buildingsUsed, 1U);
    EXPECT_GT(study->statistics.shadowAreaM2, 0);
    EXPECT_LE(study->statistics.maxContinuousMin, study->statistics.maxGrossMin);
    for (const char* stage : {"receivers", "sun", "accumulate", "total"})
        EXPECT_TRUE(study->seconds.contains(stage)) << stage;
}

// A canal of 20 m along the east of the region, 110 m long.
TEST(RunStudy, LeavesWaterOutAndSaysHowMuch) {
    MapContext map;
    map.areas = {{ContextKind::water, "Canal", {{{{40, -100}, {60, -100}, {60, 100}, {40, 100}}, {}}}}};
    City city = towers();
    city.context = std::make_shared<const MapContext>(map);
    for (const char* engine : {"ray", "projected", "horizon", "auto"}) {
        StudySettings settings = aroundTheTower();
        settings.engine = engine;
        NoProgress progress;
        const auto dry = run(settings);
        const auto study = runStudy(city, settings, progress, {});
        ASSERT_TRUE(study) << errorOf(study);
        EXPECT_EQ(study->statistics.waterM2, 20 * 110) << engine;
        EXPECT_EQ(study->statistics.receiverAreaM2, dry->statistics.receiverAreaM2 - 20 * 110) << engine;
        for (const std::uint32_t cell : study->receivers.cells)
            EXPECT_NEAR(study->field.grossMin[cell], dry->field.grossMin[cell], 1e-3) << engine;
        EXPECT_EQ(nlohmann::json::parse(studyJson(*study))["water_m2"], 2200);
        EXPECT_EQ(nlohmann::json::parse(studyJson(*dry))["water_m2"], 0);
    }
}

TEST(RunStudy, PicksAnEngineByItself) {
    StudySettings settings = aroundTheTower();
    settings.engine = StudySettings().engine;
    auto study = run(settings);
    ASSERT_TRUE(study) << errorOf(study);
    study->provenance.inputs = {{"city.gpkg", 7, "abc"}};
    EXPECT_EQ(study->field.engineKey, "projected");
    EXPECT_TRUE(study->error);
    const auto json = nlohmann::json::parse(studyJson(*study));
    EXPECT_EQ(json["engine"], "auto");
    EXPECT_EQ(json["engine_used"], "projected");
    EXPECT_THAT(json["engine_settings"].get<std::string>(), HasSubstr("chosen: projected shadows"));
    EXPECT_THAT(json["repeat"].get<std::string>(), HasSubstr("--engine projected"));
}

TEST(RunStudy, TheSunIsSeenFromTheMiddleOfTheRegion) {
    StudySettings settings = aroundTheTower();
    settings.region = makeRegionFromLocalBox({{20000, 0}, {20100, 100}});
    const Observer observer = makeObserver({.city = towers(), .settings = settings});
    const glm::dvec2 local = Frame({-73.98, 40.75}).localFromLonLat(observer.place);
    EXPECT_NEAR(local.x, 20050, 0.1);
    EXPECT_NEAR(local.y, 50, 0.1);
}

TEST(RunStudy, StatesHowTheSunLiesInTheFrame) {
    City city = towers();
    Building farOff{.sourceId = "far off"};
    farOff.parts.push_back({.footprint = {squareRing(20000, 10, 20), {}}, .topM = 40});
    city.buildings = {std::make_shared<const Building>(farOff)};
    StudySettings settings = aroundTheTower();
    settings.region = makeRegionFromLocalBox({{19970, 0}, {20050, 60}});
    NoProgress progress;
    const auto study = runStudy(city, settings, progress, {});
    ASSERT_TRUE(study) << study.error().text();
    const auto json = nlohmann::json::parse(studyJson(*study))["sun_frame"];
    // East of the origin, north turns to the west by d_lon sin(lat): 20.01 km at 40.75 deg north.
    const double convergence = 20010 / (6378137 * std::cos(40.75 / 57.29578)) * std::sin(40.75 / 57.29578);
    EXPECT_NEAR(json["north_turned_deg"], -convergence * 57.29578, 0.001);
    EXPECT_EQ(json["vertical_turned_deg"], 0);
    EXPECT_NEAR(json["farthest_from_observer_m"], 50, 0.1);
    EXPECT_NEAR(json["vertical_error_deg"], 50.0 / 6371009 * 57.29578, 1e-6);
    EXPECT_EQ(json["steps_levelled"], 0);
}

TEST(RunStudy, SaysWhatIsWrongWithTheSettings) {
    StudySettings settings = aroundTheTower();
    settings.engine = "magic";
    EXPECT_THAT(errorOf(run(settings)), HasSubstr("magic"));
    settings = aroundTheTower();
    settings.period.days = 0;
    EXPECT_FALSE(run(settings));
    settings = aroundTheTower();
    settings.period.zone = "Mars/Olympus";
    EXPECT_THAT(errorOf(run(settings)), HasSubstr("Mars/Olympus"));
    settings = aroundTheTower();
    settings.receivers.cellM = 50;
    EXPECT_THAT(errorOf(run(settings)), HasSubstr("0.25 to 10"));
}

TEST(RunStudy, RefusesWhatHasNoAnswer) {
    StudySettings settings = aroundTheTower();
    settings.region = makeRegionFromLocalBox({{2, 2}, {8, 8}});
    EXPECT_THAT(errorOf(run(settings)), HasSubstr("open ground"));
    settings = aroundTheTower();
    settings.period.from = std::chrono::hours(0);
    settings.period.hours = 3;
    EXPECT_THAT(errorOf(run(settings)), HasSubstr("below the horizon"));
}

TEST(RunStudy, RefusesWhatDoesNotFit) {
    StudySettings settings = aroundTheTower();
    settings.memoryLimit = 1000;
    EXPECT_THAT(errorOf(run(settings)), HasSubstr("would need"));
}

TEST(RunStudy, StopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    NoProgress progress;
    const auto study = runStudy(towers(), aroundTheTower(), progress, stop.get_token());
    ASSERT_FALSE(study);
    EXPECT_TRUE(isCancelled(study.error()));
}

TEST(StudyJson, HasTheKeysThatScriptsRelyOn) {
    auto study = run(aroundTheTower());
    ASSERT_TRUE(study) << errorOf(study);
    study->provenance.inputs = {{"city.gpkg", 7, "abc"}, {"sample:grid", 0, ""}};
    study->warnings = {{WarningKind::dropped, "no area", "way 5"}};
    const auto json = nlohmann::json::parse(studyJson(*study));
    EXPECT_EQ(json["engine"], "ray");
    EXPECT_EQ(json["steps"], 36);
    EXPECT_EQ(json["receivers"], study->statistics.receivers);
    EXPECT_EQ(json["buildings_used"], 1);
    ASSERT_TRUE(json["buildings_skipped"].is_object());
    EXPECT_EQ(json["buildings_skipped"].begin().value(), 1);
    EXPECT_TRUE(json["seconds"]["total"].is_number());
    EXPECT_TRUE(json["seconds"]["accumulate"].is_number());
    EXPECT_EQ(json["shadow_area_m2"], study->statistics.shadowAreaM2);
    EXPECT_EQ(json["mean_gross_min"], study->statistics.meanGrossMin);
    EXPECT_EQ(json["mean_continuous_min"], study->statistics.meanContinuousMin);
    EXPECT_EQ(json["max_continuous_min"], study->statistics.maxContinuousMin);
    EXPECT_EQ(json["warnings"][0]["where"][0], "way 5");
    EXPECT_EQ(json["period"]["zone"], "America/New_York");
    EXPECT_EQ(json["cells"]["under_buildings"], 25);
    EXPECT_EQ(json["cells"]["crs"], study->city.frame.projString());
    EXPECT_EQ(json["inputs"][0]["sha256"], "abc");
    EXPECT_TRUE(json["inputs"][1]["sha256"].is_null());
    EXPECT_THAT(json["definitions"]["fraction_of_time"].get<std::string>(), HasSubstr("above the horizon"));
}

TEST(RunStudy, MeasuresTheErrorOfEveryEngineButTheReference) {
    StudySettings settings = aroundTheTower();
    EXPECT_FALSE(run(settings)->error);
    settings.engine = "iam";
    const auto study = run(settings);
    ASSERT_TRUE(study) << errorOf(study);
    ASSERT_TRUE(study->error);
    EXPECT_EQ(study->error->receivers, 300U);
    EXPECT_EQ(study->error->ofReceivers, study->receivers.cells.size());
    EXPECT_EQ(study->error->rays, 300U * 36U);
    EXPECT_TRUE(study->seconds.contains("error_sample"));
    EXPECT_GE(study->seconds.at("total"),
              study->seconds.at("accumulate") + study->seconds.at("error_sample"));
    settings.errorSample.receivers = 0;
    EXPECT_FALSE(run(settings)->error);
}

TEST(RunStudy, MonthsHaveAnErrorOfTheirOwn) {
    StudySettings settings = aroundTheTower();
    settings.engine = "horizon";
    EXPECT_FALSE(run(settings)->monthError);
    settings.byMonth = true;
    const auto study = run(settings);
    ASSERT_TRUE(study) << errorOf(study);
    ASSERT_TRUE(study->monthError);
    EXPECT_GE(study->monthError->largest, study->monthError->mean);
    EXPECT_LE(study->monthError->largest, 60);
    std::vector<std::string> quantities;
    const auto json = nlohmann::json::parse(studyJson(*study));
    for (const auto& error : json["errors"]) quantities.push_back(error["quantity"]);
    EXPECT_EQ(quantities, (std::vector<std::string>{"cell_gross", "cell_continuous", "cell_month"}));
    settings.errorSample.receivers = 0;
    EXPECT_FALSE(run(settings)->monthError);
}

TEST(StudyJson, TheErrorsKeysAreThereMeasuredOrNot) {
    StudySettings settings = aroundTheTower();
    settings.engine = "projected";
    const auto measured = nlohmann::json::parse(studyJson(*run(settings)))["error"];
    EXPECT_EQ(measured["sample_receivers"], 300);
    EXPECT_EQ(measured["gross"]["whole_min"], 360);
    EXPECT_LE(measured["gross"]["mean_pct"], measured["gross"]["max_pct"]);
    EXPECT_TRUE(measured["continuous"]["worst_lonlat"].is_array());
    EXPECT_TRUE(measured["seconds"].is_number());
    EXPECT_TRUE(measured["why_not"].is_null());
    settings.errorSample.receivers = 0;
    const auto left = nlohmann::json::parse(studyJson(*run(settings)))["error"];
    ASSERT_EQ(left.size(), measured.size());
    for (const auto& [key, value] : measured.items()) EXPECT_TRUE(left.contains(key)) << key;
    EXPECT_TRUE(left["area_pct"].is_null());
    EXPECT_THAT(left["why_not"].get<std::string>(), HasSubstr("switched off"));
}

TEST(ErrorLines, SayWhatWasMeasuredOrWhyNot) {
    StudySettings settings = aroundTheTower();
    EXPECT_THAT(makeErrorLines(*run(settings)).front().value, HasSubstr("reference itself"));
    settings.engine = "projected";
    const auto lines = makeErrorLines(*run(settings));
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[0].name, "area error");
    EXPECT_THAT(lines[3].value, HasSubstr("300 of 3,000 receivers"));
}

TEST(StudyJson, ASolarWindowReplacesTheHours) {
    StudySettings settings = aroundTheTower();
    settings.period.window = SolarHours{std::chrono::minutes(90), std::chrono::minutes(60)};
    const auto study = run(settings);
    ASSERT_TRUE(study) << errorOf(study);
    const auto period = nlohmann::json::parse(studyJson(*study))["period"];
    EXPECT_TRUE(period["from"].is_null());
    EXPECT_TRUE(period["hours"].is_null());
    EXPECT_EQ(period["window"]["after_sunrise_min"], 90);
    EXPECT_EQ(period["window"]["before_sunset_min"], 60);
}

}  // namespace
}  // namespace noonmark
