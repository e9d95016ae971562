#include "core/study/review_study.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "core/city/trees/tree.h"
#include "core/engines/auto_engine.h"
#include "core/engines/projected/projected_shadows.h"
#include "core/engines/ray/ray_reference.h"
#include "core/review/criteria/worst_spots.h"
#include "core/review/library/rule_text.h"
#include "core/study/prepare_review.h"
#include "core/study/shadow_drawings.h"
#include "core/study/text/review_text.h"
#include "tests/core/engines/terrain_scenes.h"
#include "tests/core/review/paper_days.h"

namespace noonmark {

namespace {

using tests::Box3;

struct Quiet final : Progress {
    void report(double, std::string_view) override {}
};

City cityAt(LonLat origin, const std::vector<Box3>& boxes) {
    City city = tests::cityOf(boxes);
    city.frame = Frame(origin);
    return city;
}

Place placeOf(const std::string& name, float west, float south, float east, float north) {
    return {name, PlaceKind::park, {{tests::rectangle(west, south, east, north), {}}}, "test"};
}

ReviewStudy reviewed(const Rule& rule, const City& before, const City& after,
                     const std::vector<Place>& places, const std::string& zone,
                     const Engine& engine = AutoEngine(), double cellM = 2) {
    Quiet quiet;
    auto study = runReview(rule, before, after, places, {cellM, zone, 2026}, engine, quiet, {});
    if (!study) throw std::runtime_error(study.error().text());
    return *std::move(study);
}

const LonLat melbourne{144.96, -37.81};

TEST(ReviewStudy, MelbournesParkIsInReachOfTheTallTowerOnly) {
    // 21 June: declination d = 23.4 deg, latitude p = -37.8 deg. The shadow of a height h reaches southward
    // by h (cos p sin d - sin p cos d cos H) / (sin p sin d + cos p cos d cos H). Solar time is clock time
    // less 22 min, so H is 0 at noon: 1.82 h, and 39.5 deg at 15:00: (0.314 + 0.434) / (-0.243 + 0.560)
    // = 2.36 h, the most in the window. The park begins 60 m south of the tower: one of 20 m reaches 47 m,
    // one of 60 m 141 m.
    const Rule rule = shippedRule("melbourne-c278");
    const std::vector<Place> parks{placeOf("Green", -100, -120, 100, -60)};
    const City none = cityAt(melbourne, {});
    const auto verdict = [&](double heightM) {
        const City tower = cityAt(melbourne, {{{-10, 0, 0}, {10, 20, heightM}}});
        return reviewed(rule, none, tower, parks, "Australia/Melbourne").places.at(0).verdict;
    };
    EXPECT_EQ(verdict(20), Verdict::pass);
    EXPECT_EQ(verdict(60), Verdict::fail);
}

// The park's edge is a spot between the centres of its cells: its shadow comes earlier and leaves later.
TEST(ReviewStudy, TheTimelineOfADayHasTheTimesOfItsRow) {
    const Rule rule = shippedRule("melbourne-c278");
    const std::vector<Place> parks{placeOf("Green", -7, -63, 33, -57)};
    const City none = cityAt(melbourne, {}), tower = cityAt(melbourne, {{{-10, 0, 0}, {10, 20, 60}}});
    const ReviewSettings settings{6, "Australia/Melbourne", 2026};
    const ReviewStudy study = reviewed(rule, none, tower, parks, "Australia/Melbourne", AutoEngine(), 6);
    Quiet quiet;
    const RuleTimelines timelines =
        computeRuleTimelines(rule, none, tower, parks, settings, AutoEngine(), quiet, {}).value();
    const ReviewRow& row = study.places.at(0).rows.at(0);
    const ShadowOnPlace& shown = timelines.days.at(0).at(0).incremental;
    ASSERT_TRUE(row.exits);
    EXPECT_EQ(shown.enters(), row.enters);
    EXPECT_EQ(shown.exits(), row.exits);
    ReviewSettings coarse = settings;
    coarse.refinesSpots = false;
    const ShadowOnPlace cells =
        computeRuleTimelines(rule, none, tower, parks, coarse, AutoEngine(), quiet, {})
            .value()
            .days.at(0)
            .at(0)
            .incremental;
    EXPECT_GT(shown.minutes, cells.minutes);
}

TEST(ReviewStudy, TheForecastCountsTreesWhereTheRuleDoes) {
    Rule rule = shippedRule("melbourne-c278");
    const std::vector<Place> parks{placeOf("Green", -100, -120, 100, -60)};
    City none = cityAt(melbourne, {}), tower = cityAt(melbourne, {{{-10, 0, 0}, {10, 20, 60}}});
    Trees trees{.trees = {}, .leafDays = {1, 1}};
    for (int i = 0; i < 400; ++i)
        trees.trees.push_back({.place = {-100.0 + 10 * (i % 20), -120.0 + 3 * (i / 20.0)},
                               .heightM = 12,
                               .crownBaseM = 3,
                               .crownDiameterM = 8,
                               .leafOnTransmissivity = 0.1F,
                               .leafOffTransmissivity = 0.7F});
    none.trees = tower.trees = std::make_shared<const Trees>(std::move(trees));
    const auto seconds = [&] {
        return estimateReviewSeconds(rule, none, tower, parks, {2, "Australia/Melbourne", 2026}, {}).value();
    };
    rule.occluders.trees = RuleTrees::without;
    const double without = seconds();
    rule.occluders.trees = RuleTrees::seasonal;
    EXPECT_GT(seconds(), 1.5 * without);
}

// What the forecast assumes of its largest part, held against what a run looks at: twenty small places
// between blocks, ten of them north of a tower whose shadow falls south of it (Melbourne) and away from them.
TEST(ReviewStudy, TheForecastCountsThePointsThatSpotsAreLookedForAt) {
    const Rule rule = shippedRule("four-days");
    std::vector<Box3> boxes;
    std::vector<Place> places;
    for (int i = 0; i < 10; ++i) {
        const double x = 30.0 * i;
        boxes.push_back({{x, 0, 0}, {x + 12, 12, 15}});
        places.push_back(placeOf("South " + std::to_string(i), float(x), -12, float(x + 4 + i), -4));
        places.push_back(placeOf("North " + std::to_string(i), float(x), 304, float(x + 4 + i), 312));
        boxes.push_back({{x, 315, 0}, {x + 12, 327, 15}});
    }
    const City before = cityAt(melbourne, boxes);
    City after = before;
    after.buildings.push_back(cityAt(melbourne, {{{100, 20, 0}, {130, 40, 60}}}).buildings.front());
    const auto points = [&](const City& scenario) {
        const auto prepared =
            prepareReview(rule, before, scenario, places, {1, "Australia/Melbourne", 2026}, {}).value();
        const RuleScene& scene = prepared.scene;
        const std::array<const City*, 2> cities{&scene.before, &scene.after};
        const auto spots = PlacePoints::over(cities, prepared.measured.places, scene.receivers, scene.planeZ,
                                             prepared.days.sun, {})
                               .value();
        std::size_t looked = 0;
        const auto take = [&](std::size_t, std::span<const PlaceShadow> shadows) -> Result<void> {
            for (std::size_t i = 0; i < shadows.size(); ++i)
                for (const PlaceShadow& near : refineWorstSpots(i, shadows[i], spots, listSpotSearches(rule)))
                    looked += near.baseline.receivers;
            return {};
        };
        Quiet quiet;
        EXPECT_TRUE(shadeScene(AutoEngine(), prepared, take, quiet, {}));
        return std::pair(expectSpotPoints(rule, prepared), looked / prepared.days.sun.days.size());
    };
    const auto [expectedBefore, lookedBefore] = points(before);
    EXPECT_LT(expectedBefore, 3 * lookedBefore);
    EXPECT_GT(3 * expectedBefore, lookedBefore);
    const auto [expectedAfter, lookedAfter] = points(after);
    EXPECT_LT(expectedAfter, 3 * lookedAfter);
    EXPECT_GT(3 * expectedAfter, lookedAfter);
    EXPECT_GT(expectedAfter, expectedBefore) << "new shadow is looked for where the tower shades";
    const std::size_t searches = listSpotSearches(rule).size();
    std::size_t all = 0;
    for (int i = 0; i < 10; ++i) all += 2 * expectPoints(std::size_t(8 * (4 + i)), searches);
    EXPECT_LT(expectedAfter, all) << "and not where it cannot";
}

TEST(ReviewStudy, SaysThatTheGroundIsFlatAndThatNothingChanges) {
    const City tower = cityAt(melbourne, {{{-10, 0, 0}, {10, 20, 60}}});
    const std::vector<Place> parks{placeOf("Green", -100, -120, 100, -60)};
    const Rule rule = shippedRule("melbourne-c278");
    const ReviewStudy same = reviewed(rule, tower, tower, parks, "Australia/Melbourne");
    EXPECT_THAT(same.notChecked, testing::Contains(testing::HasSubstr("the ground is taken as flat")));
    const auto saysSame = [](const ReviewStudy& study) {
        return std::ranges::any_of(study.warnings, [](const Warning& warning) {
            return warning.what.starts_with("the scenario changes nothing");
        });
    };
    EXPECT_TRUE(saysSame(same));
    EXPECT_FALSE(saysSame(reviewed(rule, cityAt(melbourne, {}), tower, parks, "Australia/Melbourne")));
}

TEST(ReviewStudy, SaysThatARuleCountsNoTrees) {
    City before = cityAt(melbourne, {}), after = cityAt(melbourne, {{{-10, 0, 0}, {10, 20, 60}}});
    const std::vector<Place> parks{placeOf("Green", -100, -120, 100, -60)};
    const Rule rule = shippedRule("melbourne-c278");
    const ReviewStudy bare = reviewed(rule, before, after, parks, "Australia/Melbourne");
    EXPECT_EQ(bare.trees, "Trees: none counted; the city has no trees");
    const auto trees = std::make_shared<const Trees>(Trees{
        {{.sourceId = "elm", .place = {0, -90}, .heightM = 15, .crownBaseM = 4, .crownDiameterM = 12}}, {}});
    before.trees = after.trees = trees;
    const ReviewStudy planted = reviewed(rule, before, after, parks, "Australia/Melbourne");
    EXPECT_EQ(planted.trees, "Trees: none counted; the city has 1 tree");
    EXPECT_EQ(planted.places.at(0).totals.incrementalM2h, bare.places.at(0).totals.incrementalM2h);
    const auto json = reviewJson(planted, {"A", "B", {}});
    EXPECT_EQ(json.at("trees"), "without");
    EXPECT_EQ(json.at("trees_counted"), planted.trees);
    EXPECT_THAT(describeRule(rule), testing::HasSubstr("trees        none counted"));
}

// Opaque cylinders from the ground up, in a row along y = -10.
class AmenityTrees : public testing::Test {
protected:
    static constexpr float radiusM = 4, heightM = 12;
    static constexpr LonLat london{-0.1, 51.5};

    static City planted(std::size_t count, bool evergreen) {
        City city = cityAt(london, {});
        Trees trees{.leafDays = {106, 320}};
        for (std::size_t i = 0; i < count; ++i)
            trees.trees.push_back({.place = {-20 + 8 * double(i), -10},
                                   .heightM = heightM,
                                   .crownDiameterM = 2 * radiusM,
                                   .shape = CrownShape::cylinder,
                                   .evergreen = evergreen,
                                   .leafOnTransmissivity = 1e-9F,
                                   .leafOffTransmissivity = evergreen ? 1e-9F : 0.9F});
        city.trees = std::make_shared<const Trees>(std::move(trees));
        return city;
    }

    // The same as buildings of as many sides as a circle needs.
    static City built(std::size_t count) {
        City city = cityAt(london, {});
        for (std::size_t i = 0; i < count; ++i) {
            Ring ring;
            for (int corner = 0; corner < 48; ++corner) {
                const double angle = corner * std::numbers::pi / 24;
                ring.push_back({float(-20 + 8 * double(i) + radiusM * std::cos(angle)),
                                float(-10 + radiusM * std::sin(angle))});
            }
            city.buildings.push_back(tests::buildingOf({ring, {}}, 0, heightM));
        }
        return city;
    }

    // 0 to 1: of the garden, which begins 2 m north of the trees.
    static double shareWith(double hours, const City& city, const char* key = "bre-209-amenity") {
        Rule rule = shippedRule(key);
        rule.criteria.at(0).spot.minutes = 60 * hours;
        return reviewed(rule, cityAt(london, {}), city, {placeOf("Garden", -24, -4, 24, 16)}, "Europe/London",
                        AutoEngine(), 1)
            .places.at(0)
            .results.at(0)
            .value->value;
    }
};

// On 21 March at noon the sun stands 38.5 deg high, and 12 m throw a shadow of 15 m.
TEST_F(AmenityTrees, ABeltOfEvergreensShadesAsAWallOfItsShape) {
    for (const double hours : {4.0, 8.0, 11.0}) {
        const double asWall = shareWith(hours, built(6));
        EXPECT_NEAR(shareWith(hours, planted(6, true)), asWall, 0.01) << hours << " h";
        if (hours == 8) {
            EXPECT_LT(asWall, 0.8);
        }
    }
}

TEST_F(AmenityTrees, NeitherSingleNorDeciduousTreesCount) {
    const double open = shareWith(11, cityAt(london, {}));
    EXPECT_EQ(open, 1);
    EXPECT_EQ(shareWith(11, planted(2, true)), open) << "two trees are no belt";
    EXPECT_EQ(shareWith(11, planted(6, false)), open);
    EXPECT_LT(shareWith(11, planted(6, true)), 0.9);
}

TEST_F(AmenityTrees, ATreeOfBothCitiesIsNoNewShadow) {
    const City belt = planted(6, true);
    City house = belt;
    house.buildings.push_back(tests::buildingOf(Box3{{-60, -20, 0}, {-50, -10, 12}}));
    const std::vector<Place> garden{placeOf("Garden", -24, -4, 24, 16)};
    const Rule rule = shippedRule("bre-209-amenity");
    const ReviewStudy felled = reviewed(rule, belt, cityAt(london, {}), garden, "Europe/London");
    EXPECT_EQ(felled.places.at(0).totals.incrementalM2h, 0);
    EXPECT_GT(felled.places.at(0).totals.gainedM2h, 100);
    EXPECT_EQ(felled.trees, "Trees: dense belts of evergreen trees only; the city has no trees");
    const ReviewStudy planting = reviewed(rule, cityAt(london, {}), belt, garden, "Europe/London");
    EXPECT_DOUBLE_EQ(planting.places.at(0).totals.incrementalM2h, felled.places.at(0).totals.gainedM2h);
    EXPECT_EQ(planting.trees, "Trees: dense belts of evergreen trees only; 6 of the city's 6 trees count");
    const ReviewStudy both = reviewed(rule, belt, house, garden, "Europe/London");
    EXPECT_LT(both.places.at(0).totals.incrementalM2h, 0.5 * planting.places.at(0).totals.incrementalM2h);
    EXPECT_NEAR(both.places.at(0).totals.baselineM2h, planting.places.at(0).totals.incrementalM2h, 1e-6);
}

Tree evergreenAt(double x, double y = 0, float crownM = 6, float transmissivity = 0.1F) {
    return {.place = {x, y},
            .heightM = 10,
            .crownBaseM = 2,
            .crownDiameterM = crownM,
            .evergreen = true,
            .leafOnTransmissivity = transmissivity,
            .leafOffTransmissivity = transmissivity};
}

Tree deciduousAt(double x) {
    Tree tree = evergreenAt(x);
    tree.evergreen = false;
    tree.leafOffTransmissivity = 0.7F;
    return tree;
}

City cityOfTrees(std::vector<Tree> trees) {
    City city;
    city.trees = std::make_shared<const Trees>(Trees{std::move(trees), {106, 320}});
    return city;
}

std::vector<double> countedPlaces(RuleTrees counted, const City& city, const City& existing) {
    std::vector<double> places;
    const City kept = keepCountedTrees(counted, city, existing);
    if (!kept.trees) return places;
    EXPECT_TRUE(kept.trees->weighed);
    for (const Tree& tree : kept.trees->trees) places.push_back(tree.place.x);
    return places;
}

// Crowns of 6 m, 7 m apart: gaps of 1 m.
TEST(EvergreenBelts, AreRowsOfDenseCrownsThatNearlyTouch) {
    const auto isInBelt = [](std::vector<Tree> trees) { return findEvergreenBelts(trees); };
    using testing::ElementsAre;
    EXPECT_THAT(isInBelt({evergreenAt(14), evergreenAt(0), evergreenAt(7)}), ElementsAre(1, 1, 1));
    EXPECT_THAT(isInBelt({evergreenAt(0), evergreenAt(7)}), ElementsAre(0, 0));
    EXPECT_THAT(isInBelt({evergreenAt(0), evergreenAt(7), evergreenAt(14.1)}), ElementsAre(0, 0, 0));
    EXPECT_THAT(isInBelt({evergreenAt(0), deciduousAt(7), evergreenAt(14)}), ElementsAre(0, 0, 0));
    EXPECT_THAT(isInBelt({evergreenAt(0), evergreenAt(7), evergreenAt(14, 0, 6, 0.3F)}), ElementsAre(0, 0, 0))
        << "an open crown";
    EXPECT_THAT(isInBelt({evergreenAt(0, 0, 20), evergreenAt(13), evergreenAt(40), evergreenAt(0, 13.5)}),
                ElementsAre(1, 1, 0, 1));
    EXPECT_TRUE(isInBelt({}).empty());
}

TEST(RuleTreesCounted, AreThoseThatTheRuleNames) {
    using testing::ElementsAre;
    const City before = cityOfTrees({deciduousAt(0), evergreenAt(30)});
    const City after = cityOfTrees({deciduousAt(0), evergreenAt(30), deciduousAt(60), evergreenAt(90)});
    const auto counted = [&](RuleTrees trees) { return countedPlaces(trees, after, before); };
    EXPECT_THAT(counted(RuleTrees::without), ElementsAre());
    EXPECT_THAT(counted(RuleTrees::evergreens), ElementsAre(30, 90));
    EXPECT_THAT(counted(RuleTrees::evergreenBelts), ElementsAre());
    EXPECT_THAT(counted(RuleTrees::seasonal), ElementsAre(0, 30, 60, 90));
    EXPECT_THAT(counted(RuleTrees::asEvergreens), ElementsAre(0, 30, 60, 90));
    EXPECT_THAT(counted(RuleTrees::existingAndEvergreens), ElementsAre(0, 30, 90));
    EXPECT_TRUE(keepCountedTrees(RuleTrees::asEvergreens, after, before).trees->leafDays.inLeafOn(1));
    EXPECT_FALSE(keepCountedTrees(RuleTrees::seasonal, after, before).trees->leafDays.inLeafOn(1));
    EXPECT_EQ(describeCountedTrees(RuleTrees::existingAndEvergreens, after, before),
              "Trees: existing trees with their seasons, and new evergreens; 3 of the city's 4 trees count");
    EXPECT_EQ(describeCountedTrees(RuleTrees::seasonal, City{}, before),
              "Trees: all, with their seasons; the city has no trees");
}

TEST(ReviewStudy, EnginesAgreeToTheStep) {
    const City before = cityAt({-73.98, 40.75}, {{{-60, -40, 0}, {-30, -20, 25}}});
    City after = before;
    after.buildings.push_back(tests::buildingOf(Box3{{10, -60, 0}, {30, -40, 80}}));
    const std::vector<Place> places{placeOf("A", -50, 0, 50, 60), placeOf("B", 80, 20, 120, 60)};
    const Rule rule = shippedRule("ceqr");
    const ReviewStudy fast = reviewed(rule, before, after, places, "America/New_York");
    const ReviewStudy rays = reviewed(rule, before, after, places, "America/New_York", RayReference());
    ASSERT_EQ(fast.places.size(), 2);
    EXPECT_EQ(fast.clock, "America/New_York, standard time");
    EXPECT_EQ(fast.engine, ProjectedShadows().name());
    for (std::size_t i = 0; i < 2; ++i) {
        ASSERT_EQ(fast.places[i].rows.size(), 4);
        EXPECT_EQ(fast.places[i].verdict, rays.places[i].verdict);
        for (std::size_t day = 0; day < 4; ++day) {
            const ReviewRow &a = fast.places[i].rows[day], &b = rays.places[i].rows[day];
            EXPECT_EQ(a.entersText, b.entersText);
            EXPECT_EQ(a.exitsText, b.exitsText);
            EXPECT_NEAR(a.maxAreaM2, b.maxAreaM2, 4);
            EXPECT_NEAR(a.incrementalM2h, b.incrementalM2h, 0.001 * b.incrementalM2h + 0.1);
        }
    }
}

TEST(ReviewStudy, ContributionsAreSole) {
    // Two towers 400 m apart: their shadows meet on no part of the park, so that the contributions are all of
    // the incremental shadow. Of two equal towers at the same place each leaves nothing to the other.
    const City before = cityAt({-73.98, 40.75}, {{{-60, -40, 0}, {-30, -20, 25}}});
    const auto with = [&](const Box3& one, const Box3& two) {
        City after = before;
        after.buildings.push_back(tests::buildingOf(one));
        after.buildings.push_back(tests::buildingOf(two));
        Quiet quiet;
        ReviewSettings settings{2, "America/New_York", 2026};
        settings.contributions = true;
        return runReview(shippedRule("ceqr"), before, after,
                         {placeOf("A", -50, 0, 50, 60), placeOf("B", 380, 0, 480, 60)}, settings,
                         AutoEngine(), quiet, {})
            .value();
    };
    const Box3 near{{10, -40, 0}, {30, -20, 30}}, far{{410, -40, 0}, {430, -20, 30}};
    const ReviewStudy apart = with(near, far), same = with(near, near);
    ASSERT_EQ(apart.contributions.size(), 2);
    for (std::size_t place = 0; place < 2; ++place) {
        const double all = apart.places[place].totals.incrementalM2h;
        EXPECT_GT(all, 100);
        EXPECT_DOUBLE_EQ(apart.contributions[place].incrementalM2h[place], all);
        EXPECT_EQ(apart.contributions[1 - place].incrementalM2h[place], 0);
    }
    ASSERT_EQ(same.contributions.size(), 2);
    EXPECT_GT(same.places[0].totals.incrementalM2h, 100);
    EXPECT_EQ(same.contributions[0].incrementalM2h[0], 0);
    EXPECT_EQ(same.contributions[1].incrementalM2h[0], 0);
    EXPECT_TRUE(
        reviewed(shippedRule("ceqr"), before, before, {placeOf("A", -50, 0, 50, 60)}, "America/New_York")
            .contributions.empty());
}

TEST(ReviewStudy, ContributionsLeaveOutWhatTheFormerBuildingShaded) {
    // On the lot a house of 30 m gives way to one of 20 m inside its outline: all shadow of the new one lies
    // where the old one cast some at the same minute. A second new house stands alone, 400 m away.
    const City before = cityAt({-73.98, 40.75}, {{{10, -40, 0}, {30, -20, 30}}});
    const City after =
        cityAt({-73.98, 40.75}, {{{12, -38, 0}, {28, -22, 20}}, {{410, -40, 0}, {430, -20, 30}}});
    Quiet quiet;
    ReviewSettings settings{2, "America/New_York", 2026};
    settings.contributions = true;
    const ReviewStudy study = runReview(shippedRule("ceqr"), before, after,
                                        {placeOf("A", -50, 0, 50, 60), placeOf("B", 380, 0, 480, 60)},
                                        settings, AutoEngine(), quiet, {})
                                  .value();
    ASSERT_EQ(study.contributions.size(), 2);
    EXPECT_GT(study.places[0].totals.scenarioM2h, 100);
    EXPECT_EQ(study.places[0].totals.incrementalM2h, 0);
    EXPECT_EQ(study.contributions[0].incrementalM2h[0], 0);
    EXPECT_GT(study.contributions[1].incrementalM2h[1], 100);
    EXPECT_DOUBLE_EQ(study.contributions[1].incrementalM2h[1], study.places[1].totals.incrementalM2h);
}

TEST(ReviewStudy, SaysTheSameOfAllRulesWhereTheSunNeverRises) {
    // Svalbard, 21 December.
    const City city = cityAt({15.6, 78.2}, {{{0, 0, 0}, {10, 10, 10}}});
    for (const char* key : {"japan", "own"}) {
        Rule rule = shippedRule(key);
        rule.days.fixed = {RuleDay{std::chrono::December / 21, {}, {}, {}}};
        const ReviewStudy study =
            reviewed(rule, city, city, {placeOf("A", 20, 20, 60, 60)}, "Arctic/Longyearbyen");
        for (const PlaceReview& place : study.places) {
            EXPECT_EQ(place.verdict, Verdict::notChecked) << key;
            EXPECT_EQ(place.reasonNotJudged, "No sun in these hours") << key;
        }
        EXPECT_FALSE(reviewJson(study, {"Existing", "Existing", {}})["places"].empty());
    }
}

TEST(ReviewStudy, TheShadowOfTheHillIsNotTheTowers) {
    // A hill of 100 m, 120 m south of the homes and 400 m wide, shades them most of a winter day: from them
    // its top is 40 deg high, the sun at noon 28 deg. The tower stands north of them and shades none.
    City ground = tests::groundOf(41, [](glm::dvec2 at) { return at.y < -100 ? 100.0 : 0.0; });
    ground.frame = Frame({8.54, 47.37});
    City tower = ground;
    tower.buildings.push_back(tests::buildingOf(Box3{{20, 100, 0}, {40, 120, 60}}));
    const std::vector<Place> homes{placeOf("Homes", 20, 20, 60, 60)};
    const Rule rule = shippedRule("zurich");
    const ReviewStudy study = reviewed(rule, ground, tower, homes, "Europe/Zurich");
    EXPECT_EQ(study.places.at(0).verdict, Verdict::pass);
    EXPECT_EQ(study.places[0].totals.scenarioM2h, 0);
    EXPECT_EQ(study.places[0].rows.at(0).totalMaxPointMin, 0);
    Rule all = rule;
    all.occluders.casters = RuleCasters::everything;
    EXPECT_GT(reviewed(all, ground, tower, homes, "Europe/Zurich").places[0].rows.at(0).totalMaxPointMin,
              240);
}

TEST(ReviewStudy, SanFranciscosYearIsKnownWithinABoundThatAReaderCanUse) {
    // New shadow that lasts an hour or two, sampled every 15 min, held against steps of 3 min.
    const City before = cityAt({-122.42, 37.78}, {{{-60, -40, 0}, {-30, -20, 25}}});
    City after = before;
    after.buildings.push_back(tests::buildingOf(Box3{{61.3, -52.4, 0}, {75.1, -31.7, 47}}));
    const std::vector<Place> park{placeOf("Park", 3.4F, 2.7F, 61.2F, 41.6F)};
    Rule rule = shippedRule("san-francisco-295"), fine = rule;
    fine.sampling.stepMinutes = 3;
    const auto newShadow = [&](const Rule& of) {
        return *reviewed(of, before, after, park, "America/Los_Angeles").places.at(0).results.at(0).value;
    };
    const Measured coarse = newShadow(rule);
    const double truth = newShadow(fine).value;
    EXPECT_GT(truth, 1000);
    EXPECT_GT(coarse.high, truth);
    EXPECT_LT(coarse.low, truth);
    EXPECT_LT(coarse.high - coarse.value, 0.05 * coarse.value);
    EXPECT_NEAR(coarse.value, truth, 0.02 * truth);
}

TEST(ReviewStudy, OnlyTheProposalCastsWhereTheRuleSaysSo) {
    const City before = cityAt({139.7, 35.7}, {{{-60, -40, 0}, {-30, -20, 25}}});
    City after = before;
    after.buildings.push_back(tests::buildingOf(Box3{{10, -60, 0}, {30, -40, 80}}));
    EXPECT_EQ(keepOwnBuildings(after, before).buildings.size(), 1);
    EXPECT_EQ(keepOwnBuildings(before, after).buildings.size(), 0);
    City copied = before;  // equal, but not shared
    copied.buildings[0] = std::make_shared<const Building>(*before.buildings[0]);
    EXPECT_EQ(keepOwnBuildings(copied, before).buildings.size(), 0);
}

TEST(ReviewStudy, JapansBeltsFollowTheHeightOfTheBuilding) {
    // Tokyo, winter solstice: the noon sun is 90 - 35.7 - 23.4 = 30.9 deg high, and the plane is 4 m above
    // the ground: a building of 10 m reaches 6 / tan(30.9 deg) = 10.0 m north at noon. Its parcel has 5 m
    // around it, so at noon it does not reach the 10 m line (15 m from the building), and elsewhere shadow
    // moves on. One of 60 m reaches 93.6 m; 20 m wide, its shadow stays for hours near its north side.
    const City none = cityAt({139.7, 35.7}, {});
    const std::vector<Place> parcel{
        {"Lot", PlaceKind::other, {{tests::rectangle(-15, -15, 15, 15), {}}}, "lot"}};
    const auto verdicts = [&](double heightM) {
        const City city = cityAt({139.7, 35.7}, {{{-10, -10, 0}, {10, 10, heightM}}});
        const ReviewStudy study = reviewed(shippedRule("japan"), none, city, parcel, "Asia/Tokyo");
        return std::pair{study.places.at(0).verdict, study.places.at(1).verdict};
    };
    EXPECT_EQ(verdicts(7), (std::pair{Verdict::pass, Verdict::pass}));
    EXPECT_EQ(verdicts(60), (std::pair{Verdict::fail, Verdict::fail}));
}

TEST(ReviewStudy, JapansLinesMoveOutAlongWideRoads) {
    // 24 m high, 20 m above the plane. Without roads a point 26 m west and 20 m north of the building's
    // middle is in shadow from 8 h until after 10 h. Roads of 40 m move the lines 35 m out, to 55 m and 60 m
    // from the middle, on all sides where shadow falls in winter: there the building spans less than 25
    // degrees, and its shadow passes in less than two hours.
    const City none = cityAt({139.7, 35.7}, {}),
               city = cityAt({139.7, 35.7}, {{{-10, -10, 0}, {10, 10, 24}}});
    const Rule rule = shippedRule("japan");
    ASSERT_TRUE(rule.receivers.roads);
    const Footprint lot{tests::rectangle(-15, -15, 15, 15), {}};
    const auto verdicts = [&](const std::vector<RoadFront>& roads) {
        const auto polygons = moveLineOut(lot, roads, *rule.receivers.roads).value();
        const ReviewStudy study =
            reviewed(rule, none, city, {{"Lot", PlaceKind::other, polygons, "lot"}}, "Asia/Tokyo");
        return std::pair{study.places.at(0).verdict, study.places.at(1).verdict};
    };
    EXPECT_EQ(verdicts({}), (std::pair{Verdict::fail, Verdict::fail}));
    EXPECT_EQ(verdicts({{ParcelSide::west, 40}, {ParcelSide::north, 40}, {ParcelSide::east, 40}}),
              (std::pair{Verdict::pass, Verdict::pass}));
}

TEST(ReviewStudy, JapansShadowsAreDrawnOnThePlaneAsFarAsTheyReach) {
    // 20 m wide and 24 m high, on a plane 4 m up: at noon the shadow reaches 20 / tan(altitude) = 33 m north
    // of the building, far beyond the parcel, which ends 5 m from it.
    const City none = cityAt({139.7, 35.7}, {}),
               city = cityAt({139.7, 35.7}, {{{-10, -10, 0}, {10, 10, 24}}});
    const std::vector<Place> parcel{
        {"Lot", PlaceKind::other, {{tests::rectangle(-15, -15, 15, 15), {}}}, "lot"}};
    const ReviewStudy study = reviewed(shippedRule("japan"), none, city, parcel, "Asia/Tokyo");
    Quiet quiet;
    const auto drawing = drawReviewShadows(study, none, city, parcel, quiet, {});
    ASSERT_TRUE(drawing) << drawing.error().text();
    const auto noon = std::ranges::find_if(
        drawing->moments, [](const DrawnMoment& moment) { return moment.time.name == "2026-12-21_1200"; });
    ASSERT_NE(noon, drawing->moments.end());
    const double altitude = double(noon->time.sun.altitudeDeg) * std::numbers::pi / 180;
    EXPECT_NEAR(area(noon->outlines.incremental), 20 * 20 / std::tan(altitude), 2);
    EXPECT_THAT(drawing->notes, testing::Contains(testing::HasSubstr("plane 4 m above the mean ground")));
    EXPECT_EQ(drawing->places.size(), 1U);
    ASSERT_EQ(drawing->isochrones.size(), 1U);
    EXPECT_FALSE(drawing->isochrones.front().lines.empty());
}

TEST(ReviewStudy, TheDemolishedBuildingIsNotHeldAgainstJapansProposal) {
    // The proposal stands inside the outline of a higher building that it replaces.
    const City former = cityAt({139.7, 35.7}, {{{-12, -12, 0}, {12, 12, 60}}}),
               city = cityAt({139.7, 35.7}, {{{-10, -10, 0}, {10, 10, 24}}}),
               none = cityAt({139.7, 35.7}, {});
    const std::vector<Place> parcel{
        {"Lot", PlaceKind::other, {{tests::rectangle(-15, -15, 15, 15), {}}}, "lot"}};
    const ReviewStudy study = reviewed(shippedRule("japan"), former, city, parcel, "Asia/Tokyo");
    const ReviewStudy onEmptyLand = reviewed(shippedRule("japan"), none, city, parcel, "Asia/Tokyo");
    EXPECT_GT(study.places.at(0).totals.incrementalM2h, 0);
    EXPECT_EQ(study.places.at(0).totals.incrementalM2h, onEmptyLand.places.at(0).totals.incrementalM2h);
    EXPECT_EQ(study.places.at(0).totals.gainedM2h, 0);
    Quiet quiet;
    const auto drawing = drawReviewShadows(study, former, city, parcel, quiet, {});
    ASSERT_TRUE(drawing) << drawing.error().text();
    for (const DrawnMoment& moment : drawing->moments) {
        EXPECT_TRUE(moment.outlines.baseline.empty());
        EXPECT_TRUE(moment.outlines.gained.empty());
    }
    std::vector<BuildingState> states;
    for (const DrawnPart& part : drawing->buildings) states.push_back(part.state);
    EXPECT_THAT(states, testing::UnorderedElementsAre(BuildingState::proposed, BuildingState::removed));
}

TEST(ReviewStudy, StatesItsKeysInJsonAndCsv) {
    const City none = cityAt(melbourne, {});
    const City tower = cityAt(melbourne, {{{-10, 0, 0}, {10, 20, 60}}});
    const std::vector<Place> parks{placeOf("Green, \"old\"", -100, -120, 100, -60)};
    const ReviewStudy study =
        reviewed(shippedRule("melbourne-c278"), none, tower, parks, "Australia/Melbourne");
    const ReviewLabels labels{"Existing", "Tower", {}};
    const auto json = reviewJson(study, labels);
    EXPECT_EQ(json["rule"], "melbourne-c278");
    EXPECT_EQ(json["from"], "Existing");
    EXPECT_EQ(json["to"], "Tower");
    const auto& place = json["places"][0];
    EXPECT_EQ(place["kind"], "park");
    EXPECT_EQ(place["verdict"], "fail");
    for (const char* key :
         {"day", "enters", "exits", "duration_min", "max_area_m2", "max_point_min", "full_cover_min"})
        EXPECT_TRUE(place["rows"][0].contains(key)) << key;
    EXPECT_EQ(place["rows"][0]["day"], "2026-06-21");
    EXPECT_GT(place["rows"][0]["max_area_m2"].get<double>(), 0);
    EXPECT_FALSE(json["not_checked"].empty());
    const std::string csv = reviewCsv(study, labels);
    EXPECT_THAT(
        csv, testing::StartsWith("rule,from,to,place,kind,verdict,day,enters,exits,duration_min,max_area_m2,"
                                 "max_point_min,full_cover_min,"));
    EXPECT_THAT(csv, testing::HasSubstr("\"Green, \"\"old\"\"\""));
}

}  // namespace

}  // namespace noonmark
