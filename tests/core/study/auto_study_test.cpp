// `auto` does not end on an engine whose own sample is off by more than it aims at.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/review/library/rule_library.h"
#include "core/study/elements/element_study.h"
#include "core/study/elements/element_tables.h"
#include "core/study/glazing/glazing_study.h"
#include "core/study/study.h"
#include "core/study/tiles/tiled_study.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;
using testing::Not;

// A roof 12 m above the ground which is not known to be an overhang: horizons take it to stand on the ground.
City cityWithHiddenOverhang() {
    City city;
    city.frame = Frame({-73.98, 40.75});
    Building house = *buildingOf({rectangle(40, 0, 52, 12), {}}, 0, 9),
             roof = *buildingOf({rectangle(0, 0, 20, 20), {}}, 12, 13);
    house.sourceId = "house";
    roof.sourceId = "roof";
    city.buildings = {std::make_shared<const Building>(house), std::make_shared<const Building>(roof)};
    return city;
}

// A strip of many rows and few receivers east of the roof, in winter: long by polygons, short by rays.
StudySettings winterOf(const std::string& engine) {
    StudySettings settings;
    settings.region = makeRegionFromLocalBox({{30, -200}, {32, 200}});
    settings.period = {
        .start = std::chrono::year(2026) / 1 / 1, .days = 150, .hours = 8, .zone = "America/New_York"};
    settings.engine = engine;
    return settings;
}

Study studied(const StudySettings& settings) {
    NoProgress progress;
    return runStudy(cityWithHiddenOverhang(), settings, progress, {}).value();
}

TEST(AutoStudy, GoesOnToRaysWhereItsSampleIsOffAndSaysSo) {
    const Study study = studied(winterOf("auto"));
    EXPECT_EQ(study.field.engineKey, "ray");
    EXPECT_THAT(study.field.engine, HasSubstr("chosen: rays, since a sample of the horizon sweep is off by"));
    EXPECT_FALSE(study.error) << "that of the sweep is no error of the rays";
    const Study rays = studied(winterOf("ray"));
    for (const std::uint32_t cell : rays.receivers.cells)
        ASSERT_EQ(study.field.grossMin[cell], rays.field.grossMin[cell]);
    const auto json = nlohmann::json::parse(studyJson(study));
    EXPECT_EQ(json["engine_used"], "ray");
    EXPECT_THAT(json["engine_settings"].get<std::string>(), HasSubstr("more than the 0.05 % aimed at"));
}

TEST(AutoStudy, AnEngineThatWasAskedForStands) {
    const Study study = studied(winterOf("horizon"));
    EXPECT_EQ(study.field.engineKey, "horizon");
    EXPECT_GT(study.error->grossOff().meanPct, 0.5);
}

TEST(AutoStudy, MonthsAreThoseOfTheRays) {
    StudySettings settings = winterOf("auto");
    settings.byMonth = true;
    const Study study = studied(settings);
    ASSERT_EQ(study.field.engineKey, "ray");
    ASSERT_EQ(study.breakdown->minutes.size(), 5U);
    for (const std::uint32_t cell : study.receivers.cells) {
        double sum = 0;
        for (const std::vector<float>& month : study.breakdown->minutes) sum += double(month[cell]);
        ASSERT_NEAR(sum, double(study.field.grossMin[cell]) * study.field.days, 0.1);
    }
}

TEST(AutoStudy, ContributionsThatAreLessCloseAreMarked) {
    StudySettings settings = winterOf("auto");
    settings.contributions = true;
    const Study study = studied(settings);
    ASSERT_EQ(study.field.engineKey, "ray");
    EXPECT_TRUE(std::ranges::any_of(study.warnings, [](const Warning& warning) {
        return warning.what.find("contributions are those of the horizon sweep") != std::string::npos;
    }));
}

TEST(AutoStudy, TilesGoOnOneByOne) {
    const TemporaryFolder folder;
    NoProgress progress;
    TiledStudySettings settings{.study = winterOf("auto"), .tileCells = 256};
    const auto tiled =
        runTiledStudy(cityWithHiddenOverhang(), settings, folder.path("shadow.tif"), progress, {});
    ASSERT_TRUE(tiled) << tiled.error().text();
    ASSERT_TRUE(tiled->tilesByEngine.contains("ray"));
    EXPECT_TRUE(tiled->tilesByEngine.contains("projected") || tiled->tilesByEngine.contains("horizon"))
        << "tiles out of the roof's shadow have no reason to";
}

// In April the sun sets behind the roof as seen from the building, and shines below it.
StudySettings atPoints(const std::string& engine) {
    StudySettings settings = winterOf(engine);
    settings.region = makeRegionFromLocalBox({{-50, -50}, {80, 60}});
    settings.period.start = std::chrono::year(2026) / 4 / 10;
    settings.period.days = 10;
    settings.period.window = SolarHours{};
    return settings;
}

ElementStudy measuredAt(const std::string& engine) {
    NoProgress progress;
    return runElementStudy(cityWithHiddenOverhang(), atPoints(engine), {.buildings = {"house"}}, progress, {})
        .value();
}

TEST(AutoStudy, PointsGoOnToRaysAndSaySo) {
    const ElementStudy study = measuredAt("auto"), rays = measuredAt("ray"), horizons = measuredAt("horizon");
    EXPECT_EQ(study.engineKey, "ray");
    EXPECT_TRUE(study.minutes.sunlitMin == rays.minutes.sunlitMin);
    EXPECT_FALSE(study.error);
    EXPECT_THAT(describeEngine(study), HasSubstr("rays, since a sample of the points by horizons is off by"));
    EXPECT_EQ(nlohmann::json::parse(elementStudyJson(study, {}))["engine_settings"], describeEngine(study));
    EXPECT_EQ(describeEngine(rays), "rays");
    EXPECT_EQ(horizons.engineKey, "horizon");
    EXPECT_GT(horizons.error->gross.meanPct, pointErrorTargetPct);
}

GlazingStudy reviewedBy(const City& city, std::optional<ShadedStepFinder::By> by) {
    const Rule rule = RuleLibrary::load().value().find("bre-209-windows", {}).value();
    NoProgress progress;
    const GlazingReviewSettings settings{{.buildings = {"house"}},
                                         makeRegionFromLocalBox({{-50, -50}, {80, 60}}),
                                         "America/New_York",
                                         2026,
                                         by};
    return runGlazingReview(rule, city, city, settings, progress, {}).value();
}

TEST(AutoStudy, ReviewsOfWindowsGoOnToRaysAndSaySo) {
    const City city = cityWithHiddenOverhang();
    const GlazingStudy study = reviewedBy(city, {});
    ASSERT_GT(study.steps, maxTracedSteps);
    EXPECT_THAT(study.engine, HasSubstr("rays, since horizons of 48 windows are off by"));
    const GlazingStudy rays = reviewedBy(city, ShadedStepFinder::By::rays);
    ASSERT_EQ(study.windows.size(), rays.windows.size());
    for (std::size_t i = 0; i < rays.windows.size(); ++i)
        EXPECT_EQ(study.windows[i].results.back().value->value, rays.windows[i].results.back().value->value);
    City open = city;
    open.buildings.pop_back();
    EXPECT_EQ(reviewedBy(open, {}).engine, "horizons with ends by rays");
}

}  // namespace
}  // namespace noonmark
