#include "core/city/trees/tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "core/city/trees/tree_facts.h"

namespace noonmark {
namespace {

// Whether a point lies in a crown, by the definition of its shape.
bool isInCrown(const Crown& crown, glm::dvec3 point) {
    const double up = (point.z - crown.bottomM) / (crown.topM - crown.bottomM);
    const double aside = std::hypot(point.x - crown.x, point.y - crown.y) / crown.radiusM;
    if (up < 0 || up > 1) return false;
    if (crown.shape == CrownShape::cylinder) return aside <= 1;
    if (crown.shape == CrownShape::cone) return aside <= 1 - up;
    return aside * aside + (2 * up - 1) * (2 * up - 1) <= 1;
}

// Adds up short pieces of the ray.
double measureChord(const Crown& crown, glm::dvec3 origin, glm::dvec3 direction) {
    constexpr double piece = 0.002, farthest = 60;
    double length = 0;
    for (double at = piece / 2; at < farthest; at += piece)
        if (isInCrown(crown, origin + at * direction)) length += piece;
    return length;
}

Crown crownOf(CrownShape shape) {
    return {.x = 3, .y = -2, .bottomM = 4, .topM = 13, .radiusM = 3.5, .shape = shape};
}

TEST(LeafDays, OfATreeAreItsOwnWhereItStatesSome) {
    const LeafDays city{100, 300};
    Tree tree;
    EXPECT_EQ(leafDaysOf(tree, city), city);
    tree.leafOnDay = 120;
    EXPECT_EQ(leafDaysOf(tree, city), (LeafDays{120, 300}));
    LeafSeasons seasons(city);
    EXPECT_EQ(seasons.add(tree), 1U);
    EXPECT_EQ(seasons.add(Tree{}), 0U);
    EXPECT_EQ(seasons.add(tree), 1U);
    tree.evergreen = true;
    EXPECT_EQ(seasons.add(tree), 0U) << "evergreens have no days";
    EXPECT_EQ(seasons.days().size(), 2U);
}

TEST(LeafDays, AreWrittenAsMonthAndDay) {
    EXPECT_EQ(parseDayOfYear("04-15").value(), 105);
    EXPECT_EQ(formatDayOfYear(105), "04-15");
    EXPECT_EQ(parseDayOfYear("12-31").value(), 365);
    EXPECT_EQ(parseDayOfYear("03-01").value(), 60);
    EXPECT_FALSE(parseDayOfYear("02-29"));
    EXPECT_FALSE(parseDayOfYear("4"));
}

TEST(Crown, ChordsThroughTheMiddleAreItsMeasures) {
    const Crown round = crownOf(CrownShape::ellipsoid);
    EXPECT_NEAR(computeChord(round, {3, -2, 0}, {0, 0, 1}), 9, 1e-12);
    EXPECT_NEAR(computeChord(round, {-10, -2, 8.5}, {1, 0, 0}), 7, 1e-12);
    EXPECT_NEAR(computeChord(crownOf(CrownShape::cylinder), {-10, -2, 8.5}, {1, 0, 0}), 7, 1e-12);
    EXPECT_NEAR(computeChord(crownOf(CrownShape::cone), {-10, -2, 8.5}, {1, 0, 0}), 3.5, 1e-12);
    EXPECT_NEAR(computeChord(crownOf(CrownShape::cone), {3, -2, 0}, {0, 0, 1}), 9, 1e-12);
}

TEST(Crown, ARayFromInsideHasTheRestOfItsChord) {
    EXPECT_NEAR(computeChord(crownOf(CrownShape::ellipsoid), {3, -2, 8.5}, {0, 0, 1}), 4.5, 1e-12);
    EXPECT_NEAR(computeChord(crownOf(CrownShape::cylinder), {3, -2, 8.5}, {0, 0, 1}), 4.5, 1e-12);
    EXPECT_EQ(computeChord(crownOf(CrownShape::ellipsoid), {3, -2, 13.5}, {0, 0, 1}), 0);
    EXPECT_EQ(computeChord(crownOf(CrownShape::cylinder), {20, -2, 8.5}, {1, 0, 0}), 0);
}

TEST(Crown, ChordsOfAnyRayAreTheSumOfItsPieces) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-9, 9), turn(0, 6.283), up(0.01, 1.5);
    for (const CrownShape shape : {CrownShape::ellipsoid, CrownShape::cone, CrownShape::cylinder})
        for (int i = 0; i < 60; ++i) {
            const Crown crown = crownOf(shape);
            const glm::dvec3 target(3 + place(random) / 4, -2 + place(random) / 4, 8 + place(random) / 3);
            const double azimuth = turn(random), altitude = up(random);
            const glm::dvec3 direction(std::cos(altitude) * std::sin(azimuth),
                                       std::cos(altitude) * std::cos(azimuth), std::sin(altitude));
            const glm::dvec3 origin = target - direction * (i % 3 == 0 ? 0.5 : 20.0);
            EXPECT_NEAR(computeChord(crown, origin, direction), measureChord(crown, origin, direction), 0.01)
                << nameOf(shape) << " " << i;
        }
}

// Seen from the other end a line has the same part, and its own end before the first one's origin.
TEST(Crown, LinesOfAllDirectionsHaveTheSamePart) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-9, 9), turn(0, 6.283), up(-1.5, 1.5);
    int met = 0;
    for (const CrownShape shape : {CrownShape::ellipsoid, CrownShape::cone, CrownShape::cylinder})
        for (int i = 0; i < 200; ++i) {
            const Crown crown = crownOf(shape);
            const glm::dvec3 origin(3 + place(random) / 2, -2 + place(random) / 2, 8 + place(random));
            const double azimuth = turn(random), altitude = up(random);
            const glm::dvec3 direction(std::cos(altitude) * std::sin(azimuth),
                                       std::cos(altitude) * std::cos(azimuth), std::sin(altitude));
            const LinePart part = findLinePart(crown, origin, direction);
            const LinePart back = findLinePart(crown, origin, -direction);
            ASSERT_EQ(part.leave > part.enter, back.leave > back.enter) << nameOf(shape) << " " << i;
            if (!(part.leave > part.enter)) continue;
            ++met;
            EXPECT_NEAR(part.enter, -back.leave, 1e-9) << nameOf(shape) << " " << i;
            EXPECT_NEAR(part.leave, -back.enter, 1e-9) << nameOf(shape) << " " << i;
            // A ray enters against the normal of the surface and leaves along it.
            EXPECT_LT(glm::dot(normalAt(crown, origin + part.enter * direction), direction), 1e-9) << i;
            EXPECT_GT(glm::dot(normalAt(crown, origin + part.leave * direction), direction), -1e-9) << i;
        }
    EXPECT_GT(met, 100);
}

// The cone is 7 m wide and 9 m high: its side rises by 9 in 3.5.
TEST(Crown, NormalsStandOnItsSurface) {
    const auto normal = [](CrownShape shape, glm::dvec3 point) {
        return glm::normalize(normalAt(crownOf(shape), point));
    };
    EXPECT_NEAR(normal(CrownShape::ellipsoid, {3, -2, 13}).z, 1, 1e-12);
    EXPECT_NEAR(normal(CrownShape::ellipsoid, {6.5, -2, 8.5}).x, 1, 1e-12);
    EXPECT_NEAR(normal(CrownShape::cylinder, {4, -2, 13}).z, 1, 1e-12);
    EXPECT_NEAR(normal(CrownShape::cylinder, {4, -2, 4}).z, -1, 1e-12);
    EXPECT_NEAR(normal(CrownShape::cylinder, {3, 1.5, 8}).y, 1, 1e-12);
    EXPECT_NEAR(normal(CrownShape::cone, {4, -2, 4}).z, -1, 1e-12);
    const glm::dvec3 side = normal(CrownShape::cone, {3 + 1.75, -2, 8.5});
    EXPECT_NEAR(side.x / side.z, 9 / 3.5, 1e-9);
}

TEST(Crown, KeepsItsDigitsFarAway) {
    Crown far = crownOf(CrownShape::ellipsoid);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(1, 0, 0.01));
    const double near = computeChord(far, {-5, -1.5, 8.2}, direction);
    far.x += 60'000;
    EXPECT_NEAR(computeChord(far, {59'995, -1.5, 8.2}, direction), near, 1e-9);
    EXPECT_NEAR(computeChord(crownOf(CrownShape::ellipsoid), glm::dvec3(-5, -1.5, 8.2) - direction * 3000.0,
                             direction),
                near, 1e-9);
}

TEST(Crown, OnItsMeanChordLetsThroughWhatItsTreeStates) {
    EXPECT_NEAR(computeMeanChord(CrownShape::ellipsoid, 3, 6), 4, 1e-9);  // a sphere: 4/3 of the radius
    EXPECT_NEAR(computeMeanChord(CrownShape::cylinder, 2, 4), 4.0 * 16 / (8 + 16), 1e-9);
    const Tree tree{.heightM = 8,
                    .crownBaseM = 2,
                    .crownDiameterM = 6,
                    .leafOnTransmissivity = 0.1F,
                    .leafOffTransmissivity = 0.7F};
    const Crown crown = makeCrown(tree);
    EXPECT_NEAR(std::exp(-4 * crown.leafOnPerM), 0.1, 1e-6);
    EXPECT_NEAR(std::exp(-4 * crown.leafOffPerM), 0.7, 1e-6);
    EXPECT_EQ(crown.bottomM, 2);
    Tree dark = tree;
    dark.leafOnTransmissivity = 0;
    EXPECT_TRUE(std::isfinite(makeCrown(dark).leafOnPerM));
}

TEST(TreeDefaults, AGroupIsFoundByTheGenusInAnyCase) {
    ASSERT_NE(findTreeGroup("PLATANUS x hispanica"), nullptr);
    EXPECT_EQ(findTreeGroup("PLATANUS x hispanica")->key, "dense");
    EXPECT_EQ(findTreeGroup("Gleditsia triacanthos var. inermis")->key, "open");
    EXPECT_EQ(findTreeGroup("lamp post"), nullptr);
    EXPECT_EQ(findTreeGroup(""), nullptr);
}

TEST(TreeDefaults, LeavesComeLaterTowardsThePolesAndHalfAYearLaterInTheSouth) {
    const LeafDays newYork = assumeLeafDays(40.7), stockholm = assumeLeafDays(59.3),
                   sydney = assumeLeafDays(-40.7);
    EXPECT_GT(stockholm.on, newYork.on);
    EXPECT_LT(stockholm.off, newYork.off);
    EXPECT_TRUE(newYork.inLeafOn(180));
    EXPECT_FALSE(newYork.inLeafOn(20));
    EXPECT_TRUE(sydney.inLeafOn(20));
    EXPECT_FALSE(sydney.inLeafOn(200));
    EXPECT_TRUE(assumeLeafDays(1).inLeafOn(20));
    EXPECT_TRUE(assumeLeafDays(1).inLeafOn(200));
}

TEST(TreeFacts, AStemGivesCrownAndHeightThatAreMarkedAsEstimated) {
    const Tree tree = completeTree({.species = "Tilia cordata", .stemDiameterM = 0.4});
    EXPECT_NEAR(tree.crownDiameterM, 10.2, 1e-4);
    EXPECT_EQ(tree.crownSource, TreeSource::estimated);
    EXPECT_EQ(tree.heightSource, TreeSource::estimated);
    EXPECT_GT(tree.heightM, tree.crownBaseM);
    EXPECT_EQ(completeTree({.heightM = 20, .crownDiameterM = 8}).heightSource, TreeSource::measured);
    EXPECT_EQ(completeTree({}).heightSource, TreeSource::assumed);
}

TEST(TreeFacts, LeafCycleAndTypeCountWhereTheGenusIsUnknown) {
    EXPECT_EQ(completeTree({.needles = true}).shape, CrownShape::cone);
    EXPECT_TRUE(completeTree({.needles = true}).evergreen);
    EXPECT_FALSE(completeTree({.evergreen = false, .needles = true}).evergreen);
    const Tree bareMagnolia = completeTree({.species = "Magnolia x soulangeana", .evergreen = false});
    EXPECT_FALSE(bareMagnolia.evergreen);
    EXPECT_GT(bareMagnolia.leafOffTransmissivity, 0.5F);
}

// A stem grows by 8.5 mm a year (resources/trees/defaults.json): in 10 years a lime's crown by 25.5 x 85 mm,
// its height by 1.4 times that.
TEST(GrowTree, CrownAndHeightFollowTheStem) {
    const Tree young =
        completeTree({.species = "Tilia", .heightM = 6.0, .crownDiameterM = 4.0, .crownBaseM = 2.0});
    const Tree grown = growTree(young, 10);
    EXPECT_NEAR(grown.crownDiameterM, 4 + 25.5 * 0.085, 1e-5);
    EXPECT_NEAR(grown.heightM, 6 + 1.4 * 25.5 * 0.085, 1e-5);
    EXPECT_NEAR(grown.crownBaseM / grown.heightM, 2.0 / 6, 1e-6);
    EXPECT_EQ(grown.heightSource, TreeSource::estimated);
    EXPECT_EQ(growTree(young, 0), young);
}

TEST(GrowTree, EndsAtThirtyFiveMetres) {
    const Tree tall = completeTree({.species = "Platanus", .heightM = 34.0, .crownDiameterM = 20.0});
    const Tree grown = growTree(tall, 100);
    EXPECT_FLOAT_EQ(grown.heightM, 35);
    EXPECT_NEAR(grown.crownDiameterM, 20 + 1 / 1.4, 1e-5) << "the crown stops with the height";
    const Tree giant = completeTree({.species = "Sequoia", .heightM = 90.0, .crownDiameterM = 20.0});
    EXPECT_EQ(growTree(giant, 50), giant);
}

}  // namespace
}  // namespace noonmark
