#include "core/engines/shade_trees.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "core/city/trees/tree.h"
#include "core/engines/horizon/horizon_sweep.h"
#include "core/engines/horizon/trees/crown_sweep.h"
#include "core/engines/points/point_sunlight.h"
#include "core/engines/ray/tree_rays.h"
#include "tests/core/engines/sweep_scenes.h"

namespace noonmark {
namespace {

using namespace tests;

Tree treeAt(double x, double y, double heightM = 10, double crownM = 6) {
    return {.place = {x, y},
            .heightM = float(heightM),
            .crownBaseM = float(heightM) / 4,
            .crownDiameterM = float(crownM),
            .leafOnTransmissivity = 0.1F,
            .leafOffTransmissivity = 0.7F};
}

std::shared_ptr<const Trees> plant(std::vector<Tree> trees, LeafDays leaf = {100, 300}) {
    return std::make_shared<const Trees>(Trees{std::move(trees), leaf, true});
}

/// Days of a year with these dates.
void setDates(SunSteps& sun, std::vector<std::chrono::month_day> dates) {
    for (std::size_t i = 0; i < dates.size(); ++i)
        sun.days[i].date = std::chrono::year(2026) / dates[i].month() / dates[i].day();
}

// Whether a point lies in the ellipsoid of a tree on flat ground.
bool isInTree(const Tree& tree, glm::dvec3 point) {
    const double middle = (double(tree.heightM) + double(tree.crownBaseM)) / 2;
    const double up = (point.z - middle) / (double(tree.heightM) - middle);
    const double aside =
        std::hypot(point.x - tree.place.x, point.y - tree.place.y) / (double(tree.crownDiameterM) / 2);
    return up * up + aside * aside <= 1;
}

// What a tree lets through, by adding up short pieces of the ray; its mean chord is that of a spheroid, by
// rotation of an ellipse (numerically).
double passes(const Tree& tree, glm::dvec3 origin, glm::dvec3 direction, bool inLeaf) {
    constexpr double piece = 0.01;
    double chord = 0;
    for (double at = piece / 2; at < 120; at += piece)
        if (isInTree(tree, origin + at * direction)) chord += piece;
    const double a = double(tree.crownDiameterM) / 2,
                 c = (double(tree.heightM) - double(tree.crownBaseM)) / 2;
    double surface = 0;
    constexpr int rings = 2000;
    for (int i = 0; i < rings; ++i) {
        const double t = (i + 0.5) / rings * std::numbers::pi;
        surface += 2 * std::numbers::pi * a * std::sin(t) * std::hypot(a * std::cos(t), c * std::sin(t)) *
                   std::numbers::pi / rings;
    }
    const double mean = 4 * (4.0 / 3 * std::numbers::pi * a * a * c) / surface;
    const float share = inLeaf || tree.evergreen ? tree.leafOnTransmissivity : tree.leafOffTransmissivity;
    return std::pow(double(share), chord / mean);
}

TEST(TreeShade, OfOneCrownAndOneSunFollowsThePathThroughIt) {
    City city;
    city.trees = plant({treeAt(0, 0)});
    SunSteps sun = oneDay({{180, 45}});
    setDates(sun, {std::chrono::July / 1});
    const Receivers receivers = receiversOver(city, -12, -12, 12, 24, 1);
    const ShadowField field = traced(city, receivers, sun);
    ASSERT_TRUE(field.trees);
    const glm::dvec3 direction(towardsSun(180, 45));
    double maximum = 0;
    for (const std::uint32_t cell : receivers.cells) {
        const double expected =
            1 - passes(city.trees->trees[0], glm::dvec3(receivers.position(cell)), direction, true);
        EXPECT_NEAR(field.trees->evergreen->grossMin[cell], expected, 0.01);
        EXPECT_EQ(field.trees->evergreen->grossMin[cell], field.trees->seasonal->grossMin[cell]);
        EXPECT_EQ(field.trees->evergreen->continuousMin[cell] > 0,
                  field.trees->evergreen->grossMin[cell] >= 0.5F);
        EXPECT_EQ(field.grossMin[cell], 0);
        maximum = std::max(maximum, expected);
    }
    EXPECT_GT(maximum, 0.9);
}

TEST(TreeShade, IsThatOfBareCrownsOutOfSeason) {
    City city;
    city.trees = plant({treeAt(0, 0), treeAt(10, 0)});
    auto trees = *city.trees;
    trees.trees[1].evergreen = true;
    city.trees = std::make_shared<const Trees>(trees);
    SunSteps sun = oneDay({{180, 45}});
    setDates(sun, {std::chrono::January / 10});
    const Receivers receivers = receiversOver(city, -5, -5, 15, 15);
    const ShadowField field = traced(city, receivers, sun);
    const std::size_t bare = cellAt(receivers.grid, 0.5, 6.5), green = cellAt(receivers.grid, 10.5, 6.5);
    EXPECT_LT(field.trees->seasonal->grossMin[bare], 0.5F);
    EXPECT_GT(field.trees->evergreen->grossMin[bare], 0.7F);
    EXPECT_EQ(field.trees->seasonal->continuousMin[bare], 0);
    EXPECT_EQ(field.trees->seasonal->grossMin[green], field.trees->evergreen->grossMin[green]);
}

TEST(TreeShade, ReceiversInsideACrownAreInItsShade) {
    City city = cityOf({{{-1, -1, 0}, {1, 1, 6}}});  // a roof in the middle of the crown
    city.trees = plant({treeAt(0, 0)});
    SunSteps sun = oneDay({{180, 60}});
    setDates(sun, {std::chrono::July / 1});
    Receivers receivers = receiversOver(city, -3, -3, 3, 3);
    receivers.groundM.assign(receivers.grid.size(), 6);
    const ShadowField field = traced(city, receivers, sun);
    const std::size_t cell = cellAt(receivers.grid, 1.5, 0.5);
    const glm::dvec3 origin(receivers.position(std::uint32_t(cell)));
    ASSERT_TRUE(isInTree(city.trees->trees[0], origin));
    const double expected = 1 - passes(city.trees->trees[0], origin, glm::dvec3(towardsSun(180, 60)), true);
    EXPECT_GT(expected, 0.1);
    EXPECT_NEAR(field.trees->evergreen->grossMin[cell], expected, 0.01);
}

TEST(TreeShade, AddsUpAlongARowAndLeavesWhatBuildingsTake) {
    City city = cityOf({{{-6, -12, 0}, {2, -10, 25}}});
    city.trees = plant({treeAt(0, 0, 8, 4), treeAt(0, 4, 8, 4), treeAt(0, 8, 8, 4)});
    SunSteps sun;
    addDay(sun, arc(120, 50));
    setDates(sun, {std::chrono::July / 1});
    const Receivers receivers = receiversOver(city, -3, -8, 4, 16, 2);
    const ShadowField field = traced(city, receivers, sun);
    const std::vector<Box3> boxes{{{-6, -12, 0}, {2, -10, 25}}};
    for (std::size_t i = 0; i < receivers.cells.size(); i += 5) {
        const glm::dvec3 origin(receivers.position(receivers.cells[i]));
        double expected = 0;
        for (const SunStep& step : sun.steps) {
            double through = inShadow(boxes, origin, glm::dvec3(step.direction)) ? 0 : 1;
            for (const Tree& tree : city.trees->trees)
                if (through > 0) through *= passes(tree, origin, glm::dvec3(step.direction), true);
            expected += 1 - through;
        }
        EXPECT_NEAR(field.trees->evergreen->grossMin[receivers.cells[i]], expected, 1.5);
    }
}

City townWithTrees(std::size_t count, std::uint32_t seed) {
    City city = cityOf(randomBoxes(seed, 5));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(0, 100), height(5, 18);
    std::vector<Tree> trees;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = place(random), y = place(random), high = height(random);
        trees.push_back(treeAt(x, y, high, high / 1.5));
        trees.back().shape = CrownShape(i % 3);
        trees.back().evergreen = i % 4 == 0;
    }
    city.trees = plant(std::move(trees));
    return city;
}

TEST(TreeShade, OfTheSweepIsThatOfRays) {
    const City city = townWithTrees(40, 3);
    SunSteps sun = threeDays();
    setDates(sun, {std::chrono::January / 5, std::chrono::April / 20, std::chrono::July / 1});
    const Receivers receivers = receiversOver(city, 0, 0, 100, 100, 2);
    const ShadowField rays = traced(city, receivers, sun), sweep = swept(city, receivers, sun);
    ASSERT_TRUE(rays.trees && sweep.trees);
    const double whole = rays.sunlitMinutesPerDay > 0 ? rays.sunlitMinutesPerDay : 260;
    for (const bool seasonal : {false, true}) {
        const auto& exact = (seasonal ? rays.trees->seasonal : rays.trees->evergreen)->grossMin;
        const auto& found = (seasonal ? sweep.trees->seasonal : sweep.trees->evergreen)->grossMin;
        std::vector<double> off;
        double meanOff = 0, added = 0;
        for (const std::uint32_t cell : receivers.cells) {
            const double exactAdded = double(exact[cell]) - double(rays.grossMin[cell]);
            off.push_back(std::abs(double(found[cell]) - double(sweep.grossMin[cell]) - exactAdded) / whole);
            meanOff += off.back() / double(receivers.cells.size());
            added += exactAdded / double(receivers.cells.size());
        }
        std::ranges::sort(off);
        EXPECT_GT(added, 5);
        EXPECT_LT(meanOff, 0.001);
        EXPECT_LT(off[off.size() * 99 / 100], 0.01);
    }
}

// `sweep`: with the columns that a sweep found. Where trees make no run longer, it is that without them.
void expectRunsOfRays(const ShadowField& rays, const ShadowField& sweep, const Receivers& receivers) {
    ASSERT_TRUE(rays.trees && sweep.trees);
    for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal}) {
        const auto &exact = fieldOfColumn(rays, column).continuousMin,
                   &found = fieldOfColumn(sweep, column).continuousMin;
        double off = 0, longer = 0;
        std::size_t cells = 0;
        for (const std::uint32_t cell : receivers.cells) {
            ASSERT_GE(found[cell], sweep.continuousMin[cell]) << "trees make no run shorter";
            if (exact[cell] <= rays.continuousMin[cell]) continue;
            off += std::abs(double(found[cell]) - double(exact[cell]));
            longer += double(exact[cell]) - double(rays.continuousMin[cell]);
            ++cells;
        }
        std::printf("longest runs with trees: %.2f min longer at %zu cells, off by %.2f min\n",
                    longer / double(cells), cells, off / double(cells));
        EXPECT_GT(cells, 200U);
        EXPECT_GT(longer, 5 * double(cells)) << "minutes that trees add";
        EXPECT_LT(off, 0.1 * longer);
    }
}

SunSteps knownSun() {
    SunSteps sun = threeDays();
    setDates(sun, {std::chrono::January / 5, std::chrono::April / 20, std::chrono::July / 1});
    return sun;
}

TEST(TreeShade, OfTheSweepHasTheLongestRunsOfRays) {
    City city = townWithTrees(40, 3);
    std::erase_if(city.buildings, [](const auto& building) { return building->parts[0].isOverhanging; });
    const SunSteps sun = knownSun();
    const Receivers receivers = receiversOver(city, 0, 0, 100, 100, 2);
    expectRunsOfRays(traced(city, receivers, sun), swept(city, receivers, sun), receivers);
}

TEST(TreeShade, OfTheSweepHasTheLongestRunsOfRaysBelowOverhangs) {
    const City city = townWithTrees(40, 3);
    ASSERT_TRUE(std::ranges::any_of(city.buildings,
                                    [](const auto& building) { return building->parts[0].isOverhanging; }));
    const SunSteps sun = knownSun();
    const Receivers receivers = receiversOver(city, 0, 0, 100, 100, 2);
    const ShadowField sweep = swept(city, receivers, sun);
    expectRunsOfRays(traced(city, receivers, sun), sweep, receivers);
    EXPECT_EQ(sweep.trees->how.find("not counted"), std::string::npos) << sweep.trees->how;
}

// A slab hides the sun from 40 to 60 degrees, and a crown behind it from there on: the run goes on from one
// to the other. Light below the slab ends it.
TEST(TreeShade, RunsOfTheSweepGoOnFromAnOverhangToACrown) {
    City city = cityOf({{{-20, -11.9F, 10}, {20, -5.8F, 10.2F}}});
    city.buildings.front() = [&] {
        Building building = *city.buildings.front();
        building.parts[0].isOverhanging = true;
        return std::make_shared<const Building>(std::move(building));
    }();
    Tree tree = treeAt(0, -5, 16, 9);
    tree.crownBaseM = 8;
    tree.shape = CrownShape::cylinder;
    tree.leafOnTransmissivity = 0.01F;
    city.trees = plant({tree});
    std::vector<Sun> rising;
    for (int i = 0; i < 60; ++i) rising.push_back({180, 20.0 + i});
    SunSteps sun = oneDay(rising);
    setDates(sun, {std::chrono::July / 1});
    const Receivers receivers = receiversOver(city, -1, 0, 1, 2);
    const ShadowField rays = traced(city, receivers, sun), sweep = swept(city, receivers, sun);
    ASSERT_TRUE(rays.trees && sweep.trees);
    for (const std::uint32_t cell : receivers.cells) {
        EXPECT_LT(rays.continuousMin[cell], rays.trees->evergreen->continuousMin[cell] - 5);
        EXPECT_LT(rays.trees->evergreen->continuousMin[cell], 55) << "light below";
        EXPECT_NEAR(sweep.trees->evergreen->continuousMin[cell], rays.trees->evergreen->continuousMin[cell],
                    1);
    }
}

// Nothing but one crown, and one noon at which half of its shadow's cells are dark.
TEST(TreeShade, LongestRunsOfTheSweepAreOfStepsThatAreHalfTaken) {
    City city;
    city.trees = plant({treeAt(0, 0)});
    SunSteps sun = oneDay({{180, 45}});
    setDates(sun, {std::chrono::July / 1});
    const Receivers receivers = receiversOver(city, -6, 0, 6, 16, 1);
    const ShadowField field = swept(city, receivers, sun);
    ASSERT_TRUE(field.trees);
    std::size_t dark = 0;
    for (const std::uint32_t cell : receivers.cells) {
        const glm::dvec3 origin(receivers.position(cell));
        const double taken = 1 - passes(city.trees->trees[0], origin, glm::dvec3(towardsSun(180, 45)), true);
        if (std::abs(taken - 0.5) < 0.02) continue;
        EXPECT_EQ(field.trees->evergreen->continuousMin[cell], taken > 0.5 ? 1 : 0);
        dark += taken > 0.5 ? 1 : 0;
    }
    EXPECT_GT(dark, 20U);
}

TEST(TreeShade, OfTheSweepIsThatOfRaysOnUnevenGround) {
    City city = townWithTrees(30, 9);
    std::vector<float> elevations;
    for (int i = 0; i < 49; ++i) elevations.push_back(float(i % 7));
    city.terrain = std::make_shared<const Terrain>(Terrain{{-100, -100, 50, 7, 7}, std::move(elevations)});
    auto trees = *city.trees;
    for (Tree& tree : trees.trees) tree.groundM = groundAt(city, tree.place);
    city.trees = std::make_shared<const Trees>(std::move(trees));
    SunSteps sun = oneDay(arc(200, 40));
    setDates(sun, {std::chrono::July / 1});
    const Receivers receivers = receiversOver(city, 0, 0, 100, 100, 4);
    const ShadowField rays = traced(city, receivers, sun), sweep = swept(city, receivers, sun);
    ASSERT_TRUE(rays.trees && sweep.trees);
    double meanOff = 0;
    for (const std::uint32_t cell : receivers.cells)
        meanOff += std::abs(double(sweep.trees->evergreen->grossMin[cell]) - double(sweep.grossMin[cell]) -
                            double(rays.trees->evergreen->grossMin[cell]) + double(rays.grossMin[cell])) /
                   double(receivers.cells.size());
    EXPECT_LT(meanOff, 0.4);
}

TEST(TreeShade, WithoutATreeInReachNothingChanges) {
    City city = cityOf(randomBoxes(5, 3));
    const SunSteps sun = threeDays();
    const Receivers receivers = receiversOver(city, 0, 0, 60, 60, 2);
    const ShadowField before = swept(city, receivers, sun), beforeByRays = traced(city, receivers, sun);
    city.trees = plant({treeAt(90'000, 0)});
    const ShadowField after = swept(city, receivers, sun);
    EXPECT_FALSE(after.trees);
    EXPECT_FALSE(traced(city, receivers, sun).trees);
    city.trees = plant({treeAt(30, 30)});
    const ShadowField with = swept(city, receivers, sun);
    ASSERT_TRUE(with.trees);
    for (const std::uint32_t cell : receivers.cells) {
        EXPECT_EQ(before.grossMin[cell], after.grossMin[cell]);
        EXPECT_EQ(before.grossMin[cell], with.grossMin[cell]);
        EXPECT_EQ(before.continuousMin[cell], with.continuousMin[cell]);
        EXPECT_GE(with.trees->evergreen->grossMin[cell], with.grossMin[cell]);
    }
}

TEST(TreeShade, IsMeasuredByRaysOnTopOfAnyFieldAndOnlyWhatIsAskedFor) {
    City city = townWithTrees(5, 4);
    SunSteps sun = oneDay(arc(60, 40));
    setDates(sun, {std::chrono::July / 1});
    const Receivers receivers = receiversOver(city, 0, 0, 60, 60, 4);
    ShadowField field = traced(city, receivers, sun);
    const auto byRays = field.trees;
    field.trees.reset();
    NoProgress quiet;
    const auto all = shadeTrees(city, receivers, sun, field, TreeColumns::all, quiet, {}).value();
    const auto some = shadeTrees(city, receivers, sun, field, TreeColumns::seasonal, quiet, {}).value();
    EXPECT_EQ(shadeTrees(city, receivers, sun, field, TreeColumns::without, quiet, {}).value(), nullptr);
    EXPECT_FALSE(some->evergreen);
    for (const std::uint32_t cell : receivers.cells) {
        EXPECT_EQ(all->seasonal->grossMin[cell], byRays->seasonal->grossMin[cell]);
        EXPECT_EQ(some->seasonal->grossMin[cell], byRays->seasonal->grossMin[cell]);
    }
}

// Of the days of threeDays() with dates in three months.
SunSteps daysOfThreeMonths() {
    SunSteps sun = threeDays();
    setDates(sun, {std::chrono::January / 5, std::chrono::April / 20, std::chrono::July / 1});
    return sun;
}

double sumOfSets(const std::vector<std::vector<float>>& minutes, std::size_t receiver) {
    double sum = 0;
    for (const std::vector<float>& ofSet : minutes) sum += double(ofSet[receiver]);
    return sum;
}

TEST(TreeShade, OfOneSweepByMonthAddsUpToThatOfThePeriod) {
    const City city = townWithTrees(40, 3);
    const SunSteps sun = daysOfThreeMonths();
    const Receivers receivers = receiversOver(city, 0, 0, 100, 100, 2);
    NoProgress quiet;
    const ShadowField sweep = HorizonSweep({.counts = ShadowCounts::gross})
                                  .accumulate(city, receivers, sun, quiet, {})
                                  .value();  // in the same bins
    const auto taken =
        sweepCrowns(city, findCrowns(city, receivers, sun), receivers, sun, monthsOf(sun), quiet, {});
    ASSERT_TRUE(taken);
    ASSERT_EQ(taken->evergreen.size(), 3U);
    double added = 0;
    for (std::size_t i = 0; i < receivers.cells.size(); ++i) {
        const std::uint32_t cell = receivers.cells[i];
        const auto ofPeriod = [&](const ShadowField& column) {
            return (double(column.grossMin[cell]) - double(sweep.grossMin[cell])) * 3;
        };
        // A level that a horizon cuts has its months in other shares than their sum: at most 1.0 min apart.
        EXPECT_NEAR(sumOfSets(taken->evergreen, i), ofPeriod(*sweep.trees->evergreen), 1.2);
        EXPECT_NEAR(sumOfSets(taken->seasonal, i), ofPeriod(*sweep.trees->seasonal), 1.2);
        added += sumOfSets(taken->evergreen, i) / double(receivers.cells.size());
    }
    EXPECT_GT(added, 15);
}

TEST(TreeShade, OfTheSweepByMonthIsThatOfRays) {
    const City city = townWithTrees(40, 3);
    const SunSteps sun = daysOfThreeMonths();
    const Receivers receivers = receiversOver(city, 0, 0, 100, 100, 2);
    NoProgress quiet;
    const StepSets months = monthsOf(sun);
    const auto rays = traceTreeSets(city, receivers, sun, months, quiet, {}).value().value();
    const auto sweep =
        sweepCrowns(city, findCrowns(city, receivers, sun), receivers, sun, months, quiet, {}).value();
    const std::vector<double> sunlit = months.sunlitMinutes(sun);
    for (std::size_t month = 0; month < sunlit.size(); ++month) {
        double off = 0;
        for (std::size_t i = 0; i < receivers.cells.size(); ++i)
            off += std::abs(double(sweep.seasonal[month][i]) - double(rays.seasonal[month][i])) /
                   double(receivers.cells.size());
        EXPECT_LT(off, 1e-4 * sunlit[month]) << months.names[month];
    }
    for (std::size_t i = 0; i < receivers.cells.size(); ++i) {
        EXPECT_LE(rays.seasonal[0][i], rays.evergreen[0][i]) << "most are bare in January";
        EXPECT_EQ(rays.seasonal[2][i], rays.evergreen[2][i]) << "all are in leaf in July";
    }
}

TEST(TreeShade, BySetsIsPutOnTopOfWhatBuildingsTake) {
    City city = townWithTrees(10, 4);
    const SunSteps sun = daysOfThreeMonths();
    const Receivers receivers = receiversOver(city, 0, 0, 60, 60, 4);
    NoProgress quiet;
    const StepSets months = monthsOf(sun);
    const auto without = HorizonSweep().breakDown(city, receivers, sun, months, false, quiet, {}).value();
    ASSERT_FALSE(areRaysQuicker(sun));
    const auto taken =
        sweepCrowns(city, findCrowns(city, receivers, sun), receivers, sun, months, quiet, {}).value();
    const auto some =
        shadeTreeSets(city, receivers, sun, without, TreeColumns::seasonal, quiet, {}).value().value();
    EXPECT_FALSE(some.evergreen);
    EXPECT_EQ(some.treesUsed, findCrowns(city, receivers, sun).crowns.size());
    for (std::size_t month = 0; month < 3; ++month)
        for (std::size_t i = 0; i < receivers.cells.size(); ++i)
            EXPECT_FLOAT_EQ(some.seasonal->minutes[month][i],
                            std::min(without.minutes[month][i] + taken.seasonal[month][i],
                                     float(without.sunlitMinutes[month])));
    EXPECT_FALSE(shadeTreeSets(city, receivers, sun, without, TreeColumns::without, quiet, {}).value());
    city.trees = plant({treeAt(90'000, 0)});
    EXPECT_FALSE(shadeTreeSets(city, receivers, sun, without, TreeColumns::all, quiet, {}).value());
}

// Receivers' places as points, facing up.
SurfacePoints pointsOn(const Receivers& receivers) {
    SurfacePoints points;
    for (const std::uint32_t cell : receivers.cells) {
        points.positions.push_back(receivers.position(cell));
        points.normals.emplace_back(0, 0, 1);
    }
    return points;
}

std::optional<ShadedPoints> shadedPoints(const City& city, const SurfacePoints& points, const SunSteps& sun,
                                         TreeColumns columns = TreeColumns::all,
                                         ShadedStepFinder::By by = ShadedStepFinder::By::rays) {
    NoProgress quiet;
    const auto without = tracePoints(city, points, sun, quiet, {}).value();
    return shadeTreesAtPoints(city, points, sun, without, columns, by, quiet, {}).value();
}

TEST(TreeShade, OfPointsFollowsThePathThroughTheCrown) {
    City city;
    city.trees = plant({treeAt(0, 0)});
    SunSteps sun = oneDay({{180, 45}});
    setDates(sun, {std::chrono::January / 10});
    SurfacePoints points = pointsOn(receiversOver(city, -12, -12, 12, 24, 2));
    const auto shaded = shadedPoints(city, points, sun);
    ASSERT_TRUE(shaded);
    EXPECT_EQ(shaded->treesUsed, 1U);
    const glm::dvec3 direction(towardsSun(180, 45));
    double lowest = 1;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 origin(points.positions[i]);
        const double green = passes(city.trees->trees[0], origin, direction, true);
        EXPECT_NEAR(shaded->evergreen->sunlitOf(i), green, 0.01);
        EXPECT_NEAR(shaded->seasonal->sunlitOf(i), passes(city.trees->trees[0], origin, direction, false),
                    0.01);
        EXPECT_EQ(shaded->evergreen->longestShadowMin[i], green <= 0.5 ? 1 : 0);
        EXPECT_EQ(shaded->evergreen->longestSunMin[i], green <= 0.5 ? 0 : 1);
        EXPECT_EQ(shaded->seasonal->longestShadowMin[i], 0) << "a bare crown takes a third";
        lowest = std::min(lowest, green);
    }
    EXPECT_LT(lowest, 0.1);
    for (glm::vec3& normal : points.normals) normal = {0, 1, 0};  // away from the sun
    EXPECT_EQ(shadedPoints(city, points, sun)->evergreen->sunlitOf(0), 0);
    EXPECT_FALSE(shadedPoints(city, points, sun, TreeColumns::without));
    EXPECT_FALSE(shadedPoints(city, points, sun, TreeColumns::seasonal)->evergreen);
    city.trees = plant({treeAt(90'000, 0)});
    EXPECT_FALSE(shadedPoints(city, points, sun));
}

// The sun by half degrees against each of its steps, over three days among houses and trees.
TEST(TreeShade, OfPointsIsThatOfCellsInTheirPlaces) {
    const City city = townWithTrees(40, 3);
    const SunSteps sun = daysOfThreeMonths();
    const Receivers receivers = receiversOver(city, 0, 0, 100, 100, 4);
    const ShadowField field = traced(city, receivers, sun);
    const SurfacePoints points = pointsOn(receivers);
    for (const auto by : {ShadedStepFinder::By::rays, ShadedStepFinder::By::horizons}) {
        const auto shaded = shadedPoints(city, points, sun, TreeColumns::all, by);
        ASSERT_TRUE(shaded);
        double off = 0, taken = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const std::uint32_t cell = receivers.cells[i];
            for (const TreeColumns column : {TreeColumns::evergreen, TreeColumns::seasonal}) {
                const double shadow = double(fieldOfColumn(field, column).grossMin[cell]) * 3;
                const double sunlit = shaded->of(column)->sunlitOf(i);
                off += std::abs(shaded->of(column)->possibleMin - sunlit - shadow);
                taken += shadow - double(field.grossMin[cell]) * 3;
            }
        }
        EXPECT_GT(taken, 15.0 * double(points.size()));
        EXPECT_LT(off, 0.01 * taken);
    }
}

TEST(LeafDays, AreThoseOfACommonYearInLeapYears) {
    using namespace std::chrono;
    for (const int of : {2026, 2028}) {
        EXPECT_FALSE(isInLeaf({60, 304}, year(of) / February / 28)) << of;
        EXPECT_TRUE(isInLeaf({60, 304}, year(of) / March / 1)) << of;
        EXPECT_TRUE(isInLeaf({60, 304}, year(of) / October / 30)) << of;
        EXPECT_FALSE(isInLeaf({60, 304}, year(of) / October / 31)) << of;
    }
}

// The trees of a town, a third of which state their own leaf days; January, April 20, July 1 are known.
City townWithOwnLeafDays() {
    City city = townWithTrees(40, 3);
    Trees trees = *city.trees;
    for (std::size_t i = 0; i < trees.trees.size(); i += 3) {
        trees.trees[i].leafOnDay = i % 2 == 0 ? 1 : 150;  // bare on 20 April; in leaf in January
        trees.trees[i].leafOffDay = i % 2 == 0 ? 30 : 250;
    }
    city.trees = std::make_shared<const Trees>(trees);
    return city;
}

// The same on one day, without leaf days of single trees: evergreens, and trees that are bare.
City townOnDay(const City& city, int day) {
    City asOnDay = city;
    Trees trees = *city.trees;
    for (Tree& tree : trees.trees) {
        const bool inLeaf = tree.evergreen || leafDaysOf(tree, trees.leafDays).inLeafOn(day);
        tree.leafOnDay = tree.leafOffDay = std::nullopt;
        if (inLeaf) tree.leafOffTransmissivity = tree.leafOnTransmissivity;
    }
    trees.leafDays = {367, 368};
    asOnDay.trees = std::make_shared<const Trees>(trees);
    return asOnDay;
}

SunSteps dayOf(const SunSteps& sun, std::size_t day) {
    SunSteps one{.stepMinutes = sun.stepMinutes, .days = {sun.days[day]}};
    one.steps.assign(sun.steps.begin() + sun.days[day].first,
                     sun.steps.begin() + sun.days[day].first + sun.days[day].count);
    one.days.front().first = 0;
    return one;
}

constexpr std::array knownDays{5, 110, 182};  // of the year

TEST(TreeShade, OfLeafDaysOfSingleTreesIsThatOfEachDay) {
    const City city = townWithOwnLeafDays();
    const SunSteps sun = knownSun();
    const Receivers receivers = receiversOver(city, 0, 0, 100, 100, 2);
    const ShadowField field = traced(city, receivers, sun);
    std::vector<double> expected(receivers.grid.size());
    for (std::size_t day = 0; day < knownDays.size(); ++day) {
        const ShadowField one = traced(townOnDay(city, knownDays[day]), receivers, dayOf(sun, day));
        for (const std::uint32_t cell : receivers.cells)
            expected[cell] += double(one.trees->seasonal->grossMin[cell]) / 3;
    }
    const ShadowField ofCity = traced(townWithTrees(40, 3), receivers, sun);
    double apart = 0;
    for (const std::uint32_t cell : receivers.cells) {
        EXPECT_NEAR(field.trees->seasonal->grossMin[cell], expected[cell], 1e-3);
        EXPECT_EQ(field.trees->evergreen->grossMin[cell], ofCity.trees->evergreen->grossMin[cell]);
        apart += std::abs(expected[cell] - double(ofCity.trees->seasonal->grossMin[cell]));
    }
    EXPECT_GT(apart, 0.2 * double(receivers.cells.size())) << "minutes that the trees' own days change";
}

TEST(TreeShade, OfTheSweepHonoursLeafDaysOfSingleTrees) {
    const City city = townWithOwnLeafDays();
    const SunSteps sun = knownSun();
    const Receivers receivers = receiversOver(city, 0, 0, 100, 100, 2);
    NoProgress quiet;
    const StepSets months = monthsOf(sun);
    const auto rays = traceTreeSets(city, receivers, sun, months, quiet, {}).value().value();
    const auto sweep =
        sweepCrowns(city, findCrowns(city, receivers, sun), receivers, sun, months, quiet, {}).value();
    const std::vector<double> sunlit = months.sunlitMinutes(sun);
    ASSERT_EQ(sweep.seasonal.size(), 3U);
    for (std::size_t month = 0; month < sunlit.size(); ++month) {
        double off = 0;
        for (std::size_t i = 0; i < receivers.cells.size(); ++i)
            off += std::abs(double(sweep.seasonal[month][i]) - double(rays.seasonal[month][i])) /
                   double(receivers.cells.size());
        EXPECT_LT(off, 1e-3 * sunlit[month]) << months.names[month];
    }
    const ShadowField swept = tests::swept(city, receivers, sun);
    EXPECT_FALSE(swept.trees) << "the sweep of horizons leaves such trees to others";
    const auto shade = shadeTrees(city, receivers, sun, swept, TreeColumns::all, quiet, {}).value();
    ASSERT_TRUE(shade);
    double taken = 0, exact = 0;
    for (std::size_t i = 0; i < receivers.cells.size(); ++i) {
        const std::uint32_t cell = receivers.cells[i];
        taken += double(shade->seasonal->grossMin[cell]) - double(swept.grossMin[cell]);
        exact += sumOfSets(rays.seasonal, i) / 3;
    }
    EXPECT_NEAR(taken, exact, 0.01 * exact);
}

// A sweep for each phase, on top of the field of another engine.
TEST(TreeShade, OfTheSweepHasTheLongestRunsOfLeafDaysOfSingleTrees) {
    const City city = townWithOwnLeafDays();
    const SunSteps sun = knownSun();
    const Receivers receivers = receiversOver(city, 0, 0, 100, 100, 2);
    const ShadowField rays = traced(city, receivers, sun);
    NoProgress quiet;
    const CrownScene crowns = findCrowns(city, receivers, sun);
    ASSERT_EQ(crowns.phases.count(), 3U);
    const auto taken =
        sweepCrowns(city, crowns, receivers, sun, makeOneSet(sun), quiet, {}, ShadowCounts::grossAndRuns)
            .value();
    TreeShade shade = makeTreeShade(rays, taken.treesUsed);
    addRuns(taken.runs, receivers, shade);
    double off = 0, longer = 0;
    for (const std::uint32_t cell : receivers.cells) {
        const auto exact = double(rays.trees->seasonal->continuousMin[cell]);
        off += std::abs(double(shade.seasonal->continuousMin[cell]) - exact);
        longer += exact - double(rays.continuousMin[cell]);
    }
    EXPECT_GT(longer, double(receivers.cells.size()));
    EXPECT_LT(off, 0.1 * longer);
}

// On each of the days some trees are in leaf by days of their own, and none change: one phase.
TEST(TreeShade, LeafDaysOfSingleTreesInOneSeasonLeaveLongestRuns) {
    City city = townWithOwnLeafDays();
    std::erase_if(city.buildings, [](const auto& building) { return building->parts[0].isOverhanging; });
    const SunSteps all = knownSun();
    const Receivers receivers = receiversOver(city, 0, 0, 100, 100, 4);
    for (std::size_t day = 0; day < knownDays.size(); ++day) {
        const SunSteps sun = dayOf(all, day);
        EXPECT_TRUE(findCrowns(city, receivers, sun).phases.empty());
        const ShadowField own = swept(city, receivers, sun),
                          fixed = swept(townOnDay(city, knownDays[day]), receivers, sun);
        ASSERT_TRUE(own.trees && fixed.trees) << knownDays[day];
        for (const std::uint32_t cell : receivers.cells) {
            EXPECT_EQ(own.trees->seasonal->continuousMin[cell], fixed.trees->seasonal->continuousMin[cell]);
            EXPECT_EQ(own.trees->seasonal->grossMin[cell], fixed.trees->seasonal->grossMin[cell]);
            EXPECT_GE(own.trees->seasonal->continuousMin[cell], own.continuousMin[cell]);
        }
    }
    EXPECT_EQ(findCrowns(city, receivers, all).phases.count(), 3U);
}

TEST(TreeShade, OfPointsHonoursLeafDaysOfSingleTrees) {
    const City city = townWithOwnLeafDays();
    const SunSteps sun = knownSun();
    const Receivers receivers = receiversOver(city, 0, 0, 100, 100, 4);
    const SurfacePoints points = pointsOn(receivers);
    const ShadowField field = traced(city, receivers, sun);
    const auto shaded = shadedPoints(city, points, sun);
    ASSERT_TRUE(shaded);
    double off = 0, taken = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t cell = receivers.cells[i];
        const double shadow = double(field.trees->seasonal->grossMin[cell]) * 3;
        off += std::abs(shaded->seasonal->possibleMin - shaded->seasonal->sunlitOf(i) - shadow);
        taken += shadow - double(field.grossMin[cell]) * 3;
    }
    EXPECT_GT(taken, 10.0 * double(points.size()));
    EXPECT_LT(off, 0.01 * taken);
}

TEST(TreeShade, StopsWhenAsked) {
    const City city = townWithTrees(5, 4);
    std::stop_source stop;
    stop.request_stop();
    const SunSteps sun = oneDay(arc(60, 40));
    const Receivers receivers = receiversOver(city, 0, 0, 60, 60, 4);
    NoProgress quiet;
    const auto shade = shadeTrees(city, receivers, sun, {}, TreeColumns::all, quiet, stop.get_token());
    ASSERT_FALSE(shade);
    EXPECT_TRUE(isCancelled(shade.error()));
}

}  // namespace
}  // namespace noonmark
