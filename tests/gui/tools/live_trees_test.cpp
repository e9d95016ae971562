#include "app/gui/tools/live/live_trees.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <cmath>

#include "core/city/trees/tree_facts.h"
#include "core/engines/api/tree_shade.h"
#include "tests/gui/live_scene.h"
#include "tests/gui/wait_for.h"

namespace noonmark::test {
namespace {

Tree planeAt(glm::dvec2 place, const char* id) {
    Tree tree = completeTree({.sourceId = id, .species = "Platanus", .heightM = 14, .crownDiameterM = 10});
    tree.place = place;
    return tree;
}

City cityWithTrees(glm::dvec2 dragged) {
    City city = smallCity();
    Trees trees{.trees = {planeAt(dragged, "dragged"), planeAt({-30, 25}, "a"), planeAt({-22, 25}, "b")},
                .leafDays = {100, 300}};
    city.trees = std::make_shared<const Trees>(std::move(trees));
    return city;
}

StudySettings settingsOf(const Period& period) {
    StudySettings settings;
    settings.region = makeRegionFromLocalBox({{-60, -60}, {60, 60}});
    settings.receivers.cellM = 2;
    settings.period = period;
    settings.engine = "ray";
    settings.errorSample.receivers = 0;
    return settings;
}

std::shared_ptr<const Study> studyOf(const City& city, const StudySettings& settings) {
    NoProgress quiet;
    return std::make_shared<const Study>(runStudy(city, settings, quiet, {}).value());
}

HandledTrees dragged(const char* id) { return {.moved = {id}, .planted = {}}; }

HandledPlaces movedBy(glm::dvec2 byM) { return {.byM = byM, .planted = {}}; }

struct Off {
    double mean = 0, max = 0;
};

Off compare(const ShadowField& a, const ShadowField& b, const Receivers& receivers) {
    Off off;
    for (const std::uint32_t cell : receivers.cells) {
        const double difference = std::abs(double(a.grossMin[cell]) - double(b.grossMin[cell]));
        off.mean += difference / double(receivers.cells.size());
        off.max = std::max(off.max, difference);
    }
    return off;
}

TEST(WeightedSuns, CountTheMinutesOfThePeriodInFewPatches) {
    const SunSteps sun = computeSunSteps(spring(365, 10), sunOf(spring(365, 10)).observer).value();
    const LeafDays leaves{100, 300};
    const auto patches = findSuns(sun, &leaves, 300);
    EXPECT_LE(patches.size(), 300U);
    double minutes = 0, leafy = 0;
    for (const WeightedSun& patch : patches) {
        minutes += patch.minutesPerDay;
        if (patch.inLeaf) leafy += patch.minutesPerDay;
        EXPECT_NEAR(glm::length(patch.direction), 1, 1e-9);
    }
    EXPECT_NEAR(minutes, sun.sunlitMinutes() / 365, 1e-6);
    EXPECT_GT(leafy, 0.4 * minutes);
    EXPECT_LT(leafy, 0.7 * minutes);
}

TEST(LiveTreeShade, IsThatOfAStudyOfTheMovedTree) {
    const StudySettings settings = settingsOf(spring(1, 4));
    const auto study = studyOf(cityWithTrees({-40, -20}), settings);
    ASSERT_TRUE(study->field.trees && study->field.trees->seasonal);
    const auto live = LiveTreeShade::of(study, dragged("dragged"), {});
    ASSERT_TRUE(live) << live.error().text();
    EXPECT_EQ(compare((*live)->with({}), *study->field.trees->seasonal, study->receivers).max, 0);
    // In the shade of the two others, and in that of the buildings.
    for (const glm::dvec2 byM : {glm::dvec2(16, 40), glm::dvec2(45, 20)}) {
        const auto moved = studyOf(cityWithTrees(glm::dvec2(-40, -20) + byM), settings);
        const Off off = compare((*live)->with(movedBy(byM)), *moved->field.trees->seasonal, study->receivers);
        EXPECT_GT(compare(*study->field.trees->seasonal, *moved->field.trees->seasonal, study->receivers).max,
                  10);
        EXPECT_LT(off.mean, 0.05) << "minutes";
        EXPECT_LT(off.max, 4.5) << "a step at the edge of a crown";
    }
}

TEST(LiveTreeShade, OfAYearIsNearThatOfItsSteps) {
    const StudySettings settings = settingsOf(spring(365, 20));
    const auto study = studyOf(cityWithTrees({-40, -20}), settings);
    const auto live = LiveTreeShade::of(study, dragged("dragged"), {});
    ASSERT_TRUE(live) << live.error().text();
    EXPECT_LE((*live)->patches(), LiveTreeShade::maxPatches);
    const auto moved = studyOf(cityWithTrees({-24, 0}), settings);
    const Off off =
        compare((*live)->with(movedBy({16, 20})), *moved->field.trees->seasonal, study->receivers);
    EXPECT_LT(off.mean, 0.5) << "minutes";
    EXPECT_LT(off.max, 12);
}

TEST(LiveTreeShade, FollowsAnAvenue) {
    const auto avenueAt = [](glm::dvec2 byM) {
        City city = smallCity();
        Trees trees{.trees = {planeAt({-22, 25}, "other")}, .leafDays = {100, 300}};
        for (int i = 0; i < 40; ++i)
            trees.trees.push_back(
                planeAt(glm::dvec2(-50 + 2.5 * i, -30) + byM, ("row " + std::to_string(i)).c_str()));
        city.trees = std::make_shared<const Trees>(std::move(trees));
        return city;
    };
    std::set<std::string> row;
    for (int i = 0; i < 40; ++i) row.insert("row " + std::to_string(i));
    const StudySettings settings = settingsOf(spring(1, 4));
    const auto study = studyOf(avenueAt({0, 0}), settings);
    const auto live = LiveTreeShade::of(study, {.moved = row, .planted = {}}, {});
    ASSERT_TRUE(live) << live.error().text();
    const auto moved = studyOf(avenueAt({0, 8}), settings);
    const Off off = compare((*live)->with(movedBy({0, 8})), *moved->field.trees->seasonal, study->receivers);
    EXPECT_GT(compare(*study->field.trees->seasonal, *moved->field.trees->seasonal, study->receivers).max,
              10);
    EXPECT_LT(off.mean, 0.1) << "minutes";
    EXPECT_LT(off.max, 4.5) << "a step at the edge of a crown";
}

// Into a city with trees, and into one without any.
TEST(LiveTreeShade, OfPlantedTreesIsThatOfAStudyOfThem) {
    const StudySettings settings = settingsOf(spring(1, 4));
    const glm::dvec2 place(-40, -20), other(-25, -20);
    City before = cityWithTrees(place), bare = smallCity(), after = before;
    Trees trees = *before.trees;
    std::erase_if(trees.trees, [](const Tree& tree) { return tree.sourceId == "dragged"; });
    before.trees = std::make_shared<const Trees>(trees);
    trees.trees.push_back(planeAt(place, "planted 1"));
    trees.trees.push_back(planeAt(other, "planted 2"));
    after.trees = std::make_shared<const Trees>(trees);
    const HandledTrees planted{.moved = {}, .planted = planeAt({}, "")};
    const auto measured = studyOf(after, settings);
    const auto study = studyOf(before, settings);
    const auto live = LiveTreeShade::of(study, planted, {});
    ASSERT_TRUE(live) << live.error().text();
    const Off off = compare((*live)->with({.byM = {}, .planted = {place, other}}),
                            *measured->field.trees->seasonal, study->receivers);
    EXPECT_LT(off.mean, 0.05) << "minutes";
    EXPECT_LT(off.max, 4.5) << "a step at the edge of a crown";

    std::erase_if(trees.trees, [](const Tree& tree) { return !tree.sourceId.starts_with("planted"); });
    trees.leafDays = assumeLeafDays(bare.frame.origin().latDeg);
    const auto without = studyOf(bare, settings);
    bare.trees = std::make_shared<const Trees>(trees);
    const auto with = studyOf(bare, settings);
    ASSERT_FALSE(without->field.trees);
    const auto first = LiveTreeShade::of(without, planted, {});
    ASSERT_TRUE(first) << first.error().text();
    const Off ofFirst = compare((*first)->with({.byM = {}, .planted = {place, other}}),
                                *with->field.trees->seasonal, without->receivers);
    EXPECT_LT(ofFirst.mean, 0.05) << "minutes";
    EXPECT_LT(ofFirst.max, 4.5);
}

// Two cells of three receive a tree's shade: the region's mean is that of its three cells.
TEST(LivePlaceShades, AreMeansOverTheirCellsThoseThatChangeMostFirst) {
    Receivers receivers;
    receivers.grid = {0, 0, 1, 3, 1};
    receivers.kind.assign(3, CellKind::ground);
    receivers.cells = {0, 1, 2};
    ShadowField before, now;
    before.grid = now.grid = receivers.grid;
    before.grossMin = {60, 120, 180};
    now.grossMin = {60, 126, 189};
    const std::vector<GridPlace> places{{"Street", {0, 1}, true}, {"Lawn", {2}, false}};
    const auto shades = comparePlaces(receivers, places, before, now);
    ASSERT_EQ(shades.size(), 3U);
    EXPECT_TRUE(shades[0].name.empty()) << "the whole region";
    EXPECT_NEAR(shades[0].beforeMin, 120, 1e-9);
    EXPECT_NEAR(shades[0].nowMin, 125, 1e-9);
    EXPECT_EQ(shades[1].name, "Lawn");
    EXPECT_NEAR(shades[1].nowMin - shades[1].beforeMin, 9, 1e-9);
    EXPECT_FALSE(shades[1].whole);
    EXPECT_NEAR(shades[2].nowMin, 93, 1e-9);
}

TEST(LiveTreeShade, SaysWhyNothingFollows) {
    const auto study = studyOf(cityWithTrees({-40, -20}), settingsOf(spring(1, 20)));
    EXPECT_FALSE(LiveTreeShade::of(study, dragged("another"), {}));
    StudySettings without = settingsOf(spring(1, 20));
    without.trees = TreeColumns::without;
    EXPECT_FALSE(LiveTreeShade::of(studyOf(cityWithTrees({-40, -20}), without), dragged("dragged"), {}));
}

TEST(LiveTrees, FollowTheNewestPlace) {
    const StudySettings settings = settingsOf(spring(1, 10));
    const auto study = studyOf(cityWithTrees({-40, -20}), settings);
    LiveTrees live;
    const Place yard{"Yard", PlaceKind::park, {square({-45, -25}, 20)}, {}};
    live.begin(study, dragged("dragged"), {yard});
    for (int step = 1; step <= 20; ++step) live.follow(movedBy({step, 0}));
    const auto expected = LiveTreeShade::of(study, dragged("dragged"), {}).value()->with(movedBy({20, 0}));
    ASSERT_TRUE(waitFor([&] {
        return live.field() && !live.working().busy() &&
               compare(*live.field(), expected, study->receivers).max == 0;
    }));
    ASSERT_EQ(live.figures().size(), 2U);
    EXPECT_EQ(live.figures()[1].name, "Yard");
    EXPECT_GT(std::abs(live.figures()[1].nowMin - live.figures()[1].beforeMin), 0.5) << "beside the tree";
    live.end();
    EXPECT_FALSE(live.field());
}

}  // namespace
}  // namespace noonmark::test
