#include "core/study/glazing/glazing_study.h"

#include <gmock/gmock.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/city/trees/tree.h"
#include "core/measures/places/place_run.h"
#include "core/review/library/rule_library.h"
#include "core/samples/sample_city.h"
#include "core/study/glazing/glazing_text.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using namespace tests;
using enum Verdict;

Rule glazingRule(const std::string& key, const RuleChoices& choices = {}) {
    return RuleLibrary::load().value().find(key, choices).value();
}

City named(std::vector<Box3> boxes, LonLat origin) {
    City city = cityOf(boxes);
    city.frame = Frame(origin);
    for (std::size_t i = 0; i < city.buildings.size(); ++i) {
        Building building = *city.buildings[i];
        building.sourceId = "house " + std::to_string(i);
        city.buildings[i] = std::make_shared<const Building>(building);
    }
    return city;
}

const Box3 house{{0, 0, 0}, {12, 12, 9}};

GlazingReviewSettings facadesOf(const std::string& name, const std::string& zone) {
    return {{.buildings = {name}, .facades = {.storeyM = 3}},
            makeRegionFromLocalBox({{-50, -50}, {80, 80}}),
            zone,
            2026};
}

GlazingStudy reviewed(const Rule& rule, const City& baseline, const City& scenario,
                      const GlazingReviewSettings& settings) {
    NoProgress quiet;
    auto study = runGlazingReview(rule, baseline, scenario, settings, quiet, {});
    if (!study) throw std::runtime_error(study.error().text());
    return *std::move(study);
}

// South of the building an endless wall, 20 m high, 30 m away. A window at height z that faces south sees the
// sun where the tangent of its altitude, seen square to the wall, is above (20 - z) / 30.
TEST(GlazingStudy, AnEndlessWallOppositeHidesTheLowSun) {
    const City city = named({house, {{-4000, -42, 0}, {4000, -30, 20}}}, {127, 37.5});
    const Rule rule = glazingRule("korea");
    const GlazingStudy study = reviewed(rule, city, city, facadesOf("house 0", "Asia/Seoul"));
    const auto sun = computeRuleSun(rule, {observerOfPlaces(city), "Asia/Seoul", 2026}).value().sun;
    int seen = 0;
    for (const GlazingReview& review : study.windows) {
        if (std::abs(*review.window.azimuthDeg - 180) > 1) continue;
        const double z = 3 * review.window.floor + 0.9 + 0.75;
        const double lit = double(std::ranges::count_if(sun.steps, [&](const SunStep& step) {
            return step.direction.y < 0 && double(step.direction.z / -step.direction.y) > (20 - z) / 30;
        }));
        EXPECT_NEAR(review.results[0].value->value, lit, 1) << review.window.id;
        ++seen;
    }
    EXPECT_EQ(seen, 4 * 3);
    // On 22 December that tangent is at most 0.557, at noon. Ground floor: (20 - 1.65) / 30 = 0.61, no sun at
    // all. First floor: 0.51, with the sun within 24 degrees of hour angle, 3 h 12 min. Second: 0.41, 5 h 33.
    for (const GlazingReview& review : study.windows)
        if (std::abs(*review.window.azimuthDeg - 180) < 1) {
            EXPECT_EQ(review.verdict, review.window.floor == 0 ? fail : pass) << review.window.id;
        }
}

TEST(GlazingStudy, AnOpenWallHasTheWholeSkyOfAWall) {
    const City city = named({house}, {-0.1, 51.5});
    const Rule rule = glazingRule("bre-209-windows");
    const GlazingStudy study = reviewed(rule, city, city, facadesOf("house 0", "Europe/London"));
    for (const GlazingReview& review : study.windows) {
        EXPECT_NEAR(review.results[0].value->value, 39.6, 0.1) << "vertical sky component";
        EXPECT_EQ(review.verdict, pass);
        EXPECT_EQ(review.formerVerdict, pass);
    }
    EXPECT_EQ(study.windowChanges.after.pass, 48);
    EXPECT_EQ(study.buildings.size(), 1);
}

TEST(GlazingStudy, ATowerTakesSunAndSky) {
    const City before = named({house}, {-0.1, 51.5});
    const City after = named({house, {{-30, -32, 0}, {42, -12, 60}}}, {-0.1, 51.5});
    const GlazingStudy study =
        reviewed(glazingRule("bre-209-windows"), before, after, facadesOf("house 0", "Europe/London"));
    EXPECT_EQ(study.windowChanges.before.pass, 48);
    for (const GlazingReview& review : study.windows) {
        const double azimuth = *review.window.azimuthDeg;
        if (std::abs(azimuth - 180) < 1) {
            EXPECT_EQ(review.verdict, fail) << review.window.id;
        }
        if (azimuth < 1 || azimuth > 359) {
            EXPECT_EQ(review.verdict, pass) << "the tower is behind";
        }
    }
    // The windows of the tower have no former sun.
    const GlazingStudy own =
        reviewed(glazingRule("korea"), before, after, facadesOf("house 1", "Europe/London"));
    EXPECT_EQ(own.windowChanges.before.notApplicable, own.windows.size());
    EXPECT_FALSE(own.windows[0].results[0].former);
}

class RoomGlazing : public testing::Test {
protected:
    // In the middle of the eastern and of the western wall.
    std::filesystem::path write(const std::string& room) {
        const auto feature = [&](const char* id, glm::dvec2 place) {
            const LonLat at = city_.frame.lonLatFromLocal(place);
            return fmt::format(R"({{"type":"Feature","properties":{{"id":"{}","room":"{}"}},"geometry":)"
                               R"({{"type":"Point","coordinates":[{:.9f},{:.9f},4]}}}})",
                               id, room, at.lonDeg, at.latDeg);
        };
        return folder_.file("windows.geojson", R"({"type":"FeatureCollection","features":[)" +
                                                   feature("east", {12, 6}) + "," + feature("west", {0, 6}) +
                                                   "]}");
    }
    GlazingStudy review(const std::string& room) {
        GlazingReviewSettings settings = facadesOf("", "Europe/Warsaw");
        settings.elements = {.places = ElementPlaces::windows, .windows = write(room)};
        Rule rule = glazingRule("poland");
        rule.days.fixed.resize(1);  // the worst days of both walls differ
        return reviewed(rule, city_, city_, settings);
    }
    City city_ = named({house}, {21, 52});
    TemporaryFolder folder_;
};

TEST_F(RoomGlazing, AddUpWhereTheyAreNotLitAtOnce) {
    const GlazingStudy single = review(""), room = review("parlour");
    ASSERT_EQ(single.windows.size(), 2);
    ASSERT_EQ(room.windows.size(), 1);
    EXPECT_EQ(room.windows[0].window.id, "house 0 parlour");
    EXPECT_EQ(room.windows[0].window.windows, 2);
    // Morning and afternoon: together the 10 h of the rule, of which the sun is up in all.
    const auto minutes = [](const GlazingReview& review) { return review.results[0].value->value; };
    EXPECT_NEAR(minutes(room.windows[0]), minutes(single.windows[0]) + minutes(single.windows[1]), 2);
    EXPECT_NEAR(minutes(room.windows[0]), 600, 2);
    EXPECT_EQ(room.warnings.back().what, "the size of the window is not stated; 1.5 x 1.5 m was taken");
    const auto table = makeGlazingTable(room, {"Existing", "Existing", {}});
    EXPECT_EQ(table.rows.size(), 1);
    EXPECT_EQ(table.rows[0].size(), table.columns.size());
}

TEST(GlazingStudy, VerdictsByHorizonsAreThoseOfRays) {
    GridSampleSettings sample;
    sample.buildings = 100;
    sample.seed = 7;
    const City after = makeGridSample(sample).value();
    City before = after;
    before.buildings.erase(before.buildings.begin() + 40);
    const glm::vec2 middle = bounds(*after.buildings[40]).low;
    GlazingReviewSettings settings{
        {}, makeRegionFromLocalBox({middle - 40.0F, middle + 40.0F}), "America/New_York", 2026};
    settings.elements.facades = {.bayM = 14, .storeyM = 17};
    std::size_t windows = 0, changed = 0;
    const RuleLibrary library = RuleLibrary::load().value();
    for (const Rule& rule : library.rules()) {
        if (rule.receivers.surface != RuleSurface::windows) continue;
        // Of rules about many days every ninth, so that rays take seconds.
        Rule few = rule;
        if (few.days.fixed.empty()) few.days.everyDays = 9;
        settings.by = ShadedStepFinder::By::horizons;
        const GlazingStudy swept = reviewed(few, before, after, settings);
        settings.by = ShadedStepFinder::By::rays;
        const GlazingStudy traced = reviewed(few, before, after, settings);
        ASSERT_EQ(swept.windows.size(), traced.windows.size());
        ASSERT_GT(swept.windows.size(), 20);
        for (std::size_t i = 0; i < swept.windows.size(); ++i) {
            EXPECT_EQ(swept.windows[i].verdict, traced.windows[i].verdict)
                << rule.key << ", " << swept.windows[i].window.id << ": "
                << describeReason(few, traced.windows[i]);
            EXPECT_EQ(swept.windows[i].formerVerdict, traced.windows[i].formerVerdict) << rule.key;
        }
        windows += swept.windows.size();
        changed += swept.windowChanges.worse;
    }
    EXPECT_GT(changed, 0) << "of " << windows;
}

TEST(GlazingStudy, RefusesRulesAboutPlaces) {
    NoProgress quiet;
    const City city = named({house}, {0, 50});
    const auto refused =
        runGlazingReview(glazingRule("own"), city, city, facadesOf("house 0", "UTC"), quiet, {});
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().text(), testing::HasSubstr("about places"));
    std::stop_source stopped;
    stopped.request_stop();
    EXPECT_EQ(runGlazingReview(glazingRule("korea"), city, city, facadesOf("house 0", "UTC"), quiet,
                               stopped.get_token())
                  .error()
                  .kind,
              ErrorKind::cancelled);
}

TEST(GlazingStudy, IsForecastWithTheWindowsAndStepsThatItMeasures) {
    const City city = named({house, {{20, 0, 0}, {30, 12, 30}}}, {127, 37.5});
    const GlazingReviewSettings settings = facadesOf("house 0", "Asia/Seoul");
    NoProgress quiet;
    const auto forecast = forecastGlazingReview(glazingRule("korea"), city, city, settings, quiet, {});
    ASSERT_TRUE(forecast);
    std::vector<GlazingForecast> announced;
    const auto study = runGlazingReview(glazingRule("korea"), city, city, settings, quiet, {},
                                        [&](const GlazingForecast& one) { announced.push_back(one); });
    ASSERT_TRUE(study);
    EXPECT_EQ(forecast->windows, study->windows.size());
    EXPECT_EQ(forecast->steps, study->steps);
    EXPECT_GT(forecast->seconds, 0);
    ASSERT_EQ(announced.size(), 1U);
    EXPECT_EQ(announced[0].windows, forecast->windows);
    EXPECT_FALSE(forecastGlazingReview(glazingRule("own"), city, city, settings, quiet, {})) << "of places";
}

// A house whose southern facade has twelve windows, an endless wall 30 m before it, and a round crown that
// lets nothing pass between them, above the wall as the windows see it.
class GlazingTrees : public testing::Test {
protected:
    static constexpr glm::dvec3 middle{6, -12, 15};
    static constexpr double radiusM = 4;
    static constexpr double wallM = 12;

    static City cityWith(const std::vector<Tree>& trees) {
        City city = cityOf({{{0, 0, 0}, {12, 12, 9}}, {{-4000, -42, 0}, {4000, -30, wallM}}});
        city.frame = Frame({-0.1, 51.5});
        Building house = *city.buildings[0];
        house.sourceId = "house";
        city.buildings[0] = std::make_shared<const Building>(house);
        if (!trees.empty()) city.trees = std::make_shared<const Trees>(Trees{trees, {106, 320}});
        return city;
    }
    static Tree round(bool evergreen, float bare) {
        return {.place = {middle.x, middle.y},
                .heightM = float(middle.z + radiusM),
                .crownBaseM = float(middle.z - radiusM),
                .crownDiameterM = float(2 * radiusM),
                .evergreen = evergreen,
                .leafOnTransmissivity = 1e-9F,
                .leafOffTransmissivity = bare};
    }

    static Rule ruleOf(const RuleChoices& choices) {
        return RuleLibrary::load().value().find("bre-209-windows", choices).value();
    }
    static GlazingStudy review(const City& baseline, const City& scenario, const RuleChoices& choices = {}) {
        NoProgress quiet;
        const GlazingReviewSettings settings{{.buildings = {"house"}, .facades = {.storeyM = 3}},
                                             makeRegionFromLocalBox({{-50, -50}, {80, 80}}),
                                             "Europe/London",
                                             2026};
        return runGlazingReview(ruleOf(choices), baseline, scenario, settings, quiet, {}).value();
    }
    static GlazingStudy review(const std::vector<Tree>& trees, const RuleChoices& choices = {}) {
        return review(cityWith(trees), cityWith(trees), choices);
    }
    static bool facesSouth(const GlazingReview& window) {
        return std::abs(*window.window.azimuthDeg - 180) < 1;
    }

    // Vertical sky component of a round patch of the sky of the angular radius r about the unit vector c,
    // which lies in the sky as a whole, of a wall that faces n, under (1 + 2 z)/3 of the zenith's brightness.
    // Over the patch the mean of w is pi sin^2 r c, that of w w^T is A (I - c c^T) + B c c^T.
    static double skyOfPatchPct(glm::dvec3 eye) {
        const glm::dvec3 towards = middle - eye, c = glm::normalize(towards), n{0, -1, 0}, z{0, 0, 1};
        const double cosine = std::sqrt(1 - std::pow(radiusM / glm::length(towards), 2));
        const double along = 2 * std::numbers::pi * (1 - cosine * cosine * cosine) / 3;
        const double across = (2 * std::numbers::pi * (1 - cosine) - along) / 2;
        const double plain = std::numbers::pi * (1 - cosine * cosine) * glm::dot(n, c);
        const double steep = (along - across) * glm::dot(z, c) * glm::dot(n, c);  // n and z are square
        return 100 * (plain + 2 * steep) / 3 / (7 * std::numbers::pi / 9);
    }
};

TEST_F(GlazingTrees, AnEvergreenTakesItsPatchOfTheSky) {
    const GlazingStudy without = review({}), with = review({round(true, 1e-9F)});
    EXPECT_EQ(with.trees, "Trees: evergreen trees only; 1 of the city's 1 tree count");
    int seen = 0;
    for (std::size_t i = 0; i < with.windows.size(); ++i) {
        const double sky = with.windows[i].results[0].value->value;
        const double open = without.windows[i].results[0].value->value;
        if (!facesSouth(with.windows[i])) continue;
        const double patch = skyOfPatchPct(glm::dvec3(with.panes[i].pane.middle));
        EXPECT_GT(patch, 3);
        EXPECT_NEAR(open - sky, patch, 0.03) << with.windows[i].window.id;
        EXPECT_NEAR(with.windows[i].results[0].former->value, sky, 1e-12) << "the tree stands in both";
        ++seen;
    }
    EXPECT_EQ(seen, 12);
}

TEST_F(GlazingTrees, AnEvergreenTakesTheSunBehindIt) {
    const GlazingStudy with = review({round(true, 1e-9F)});
    const City city = cityWith({});
    const auto days = computeRuleSun(ruleOf({}), {observerOfPlaces(city), "Europe/London", 2026}).value();
    for (std::size_t i = 0; i < with.windows.size(); ++i) {
        if (!facesSouth(with.windows[i])) continue;
        const glm::dvec3 eye(with.panes[i].pane.middle);
        double lit = 0;
        for (const SunStep& step : days.sun.steps) {
            const glm::dvec3 sun(step.direction);
            if (sun.y >= 0 || -sun.z / sun.y < (wallM - eye.z) / (eye.y + 30)) continue;
            const glm::dvec3 towards = middle - eye;
            const double along = glm::dot(towards, sun);
            if (glm::dot(towards, towards) - along * along > radiusM * radiusM) ++lit;
        }
        const double annual = 100 * lit / double(days.sun.steps.size());
        EXPECT_NEAR(with.windows[i].results[1].value->value, annual, 0.15) << with.windows[i].window.id;
    }
}

TEST_F(GlazingTrees, DeciduousTreesBeforeNeighboursAreLeftOut) {
    const GlazingStudy without = review({}), with = review({round(false, 1)});
    EXPECT_EQ(with.trees, "Trees: evergreen trees only; 0 of the city's 1 tree count");
    for (std::size_t i = 0; i < with.windows.size(); ++i)
        for (std::size_t k = 0; k < with.windows[i].results.size(); ++k)
            EXPECT_EQ(with.windows[i].results[k].value->value, without.windows[i].results[k].value->value);
}

// Of the year it has leaves on 214 days, and takes nothing without.
TEST_F(GlazingTrees, BeforeOnesOwnSchemeExistingTreesCountByTheirSeason) {
    const RuleChoices own{{"windows of", "own scheme"}};
    const GlazingStudy without = review({}), with = review({round(false, 1)}, own);
    // A tree that the scenario plants is no existing one.
    const GlazingStudy planted = review(cityWith({}), cityWith({round(false, 1)}), own);
    for (std::size_t i = 0; i < with.windows.size(); ++i) {
        if (!facesSouth(with.windows[i])) continue;
        const double patch = skyOfPatchPct(glm::dvec3(with.panes[i].pane.middle));
        EXPECT_NEAR(without.windows[i].results[0].value->value - with.windows[i].results[0].value->value,
                    patch * 214 / 365, 0.03);
        EXPECT_EQ(planted.windows[i].results[0].value->value, without.windows[i].results[0].value->value);
        EXPECT_LT(with.windows[i].results[1].value->value, without.windows[i].results[1].value->value)
            << "sun of the year";
    }
}

TEST_F(GlazingTrees, APlantedEvergreenIsALoss) {
    const GlazingStudy study = review(cityWith({}), cityWith({round(true, 1e-9F)}));
    const GlazingStudy without = review({});
    for (std::size_t i = 0; i < study.windows.size(); ++i) {
        if (!facesSouth(study.windows[i])) continue;
        EXPECT_NEAR(study.windows[i].results[0].former->value, without.windows[i].results[0].value->value,
                    1e-9);
        EXPECT_LT(study.windows[i].results[0].value->value, study.windows[i].results[0].former->value - 3);
    }
}

}  // namespace
}  // namespace noonmark
