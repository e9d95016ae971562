#include "core/engines/horizon/attribution/horizon_breakdown.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "core/samples/sample_city.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

ShadowField swept(const City& city, const Receivers& receivers, const SunSteps& sun) {
    NoProgress progress;
    return HorizonSweep().accumulate(city, receivers, sun, progress, {}).value();
}

ShadowBreakdown breakDown(const City& city, const Receivers& receivers, const SunSteps& sun,
                          const StepSets& sets, bool byBuilding = true) {
    NoProgress progress;
    return computeHorizonBreakdown(city, receivers, sun, sets, {.byBuilding = byBuilding}, progress, {})
        .value();
}

SunSteps threeMonths() {
    SunSteps sun;
    for (int day = 0; day < 12; ++day) {
        addDay(sun, arc(60 + 5 * day, 20 + 4 * day));
        sun.days.back().date = {std::chrono::year{2026}, std::chrono::month{unsigned(1 + day / 4)},
                                std::chrono::day{unsigned(1 + day % 4)}};
    }
    return sun;
}

/// Sum over receivers of steps in shadow x cell area.
double totalMinM2(const ShadowField& field, const Receivers& receivers) {
    double sum = 0;
    for (const std::uint32_t cell : receivers.cells)
        sum += std::round(double(field.grossMin[cell]) * field.days) * field.grid.cellAreaM2();
    return sum;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

City quarter() { return makeGridSample({.buildings = 200}).value(); }

Receivers findMiddle(const City& city) {
    const Box2 box = bounds(city);
    const glm::vec2 middle = (box.low + box.high) * 0.5F;
    return receiversOver(city, middle.x - 90, middle.y - 90, middle.x + 90, middle.y + 90, 3);
}

TEST(StepSets, MonthsTakeEveryStepOnce) {
    const SunSteps sun = threeMonths();
    const StepSets months = monthsOf(sun);
    EXPECT_EQ(months.names, (std::vector<std::string>{"2026-01", "2026-02", "2026-03"}));
    EXPECT_EQ(sum(months.sunlitMinutes(sun)), double(sun.steps.size()));
    EXPECT_EQ(months.ofStep[sun.days[4].first - 1], 0);
    EXPECT_EQ(months.ofStep[sun.days[4].first], 1);
}

TEST(HorizonBreakdown, SetsAddUpToTheSweepsField) {
    const City city = quarter();
    const Receivers receivers = findMiddle(city);
    const SunSteps sun = threeMonths();
    const ShadowField field = swept(city, receivers, sun);
    for (const bool byBuilding : {false, true}) {
        const ShadowBreakdown months = breakDown(city, receivers, sun, monthsOf(sun), byBuilding);
        for (std::size_t i = 0; i < receivers.cells.size(); ++i) {
            const float minutes = months.minutes[0][i] + months.minutes[1][i] + months.minutes[2][i];
            ASSERT_EQ(float(double(minutes) / field.days), field.grossMin[receivers.cells[i]]);
        }
    }
}

// A set has the same result as a period of its own steps, if the bins have the same directions.
TEST(HorizonBreakdown, ASetIsThePeriodOfItsSteps) {
    const City city = quarter();
    const Receivers receivers = findMiddle(city);
    SunSteps sun = threeMonths();
    const ShadowBreakdown months = breakDown(city, receivers, sun, monthsOf(sun), false);
    SunSteps january = sun;
    january.days.resize(4);
    january.steps.resize(january.days[3].first + january.days[3].count);
    const ShadowField alone = traced(city, receivers, january);
    double off = 0;
    for (std::size_t i = 0; i < receivers.cells.size(); ++i)
        off += std::abs(double(months.minutes[0][i]) - 4 * double(alone.grossMin[receivers.cells[i]]));
    EXPECT_LE(off / double(receivers.cells.size()) / months.sunlitMinutes[0], 0.005);
}

TEST(HorizonBreakdown, AttributedMinutesAddUpToTheTotal) {
    const City city = quarter();
    const Receivers receivers = findMiddle(city);
    const SunSteps sun = threeMonths();
    const ShadowBreakdown months = breakDown(city, receivers, sun, monthsOf(sun));
    double attributed = 0, sole = 0;
    for (const BuildingShadow& shadow : months.buildings) {
        attributed += sum(shadow.attributedMinM2);
        sole += sum(shadow.soleMinM2);
        for (std::size_t set = 0; set < 3; ++set)
            EXPECT_LE(shadow.soleMinM2[set], shadow.attributedMinM2[set]);
    }
    EXPECT_DOUBLE_EQ(attributed, totalMinM2(swept(city, receivers, sun), receivers));
    EXPECT_GT(sole, 0.02 * attributed);
    EXPECT_LT(sole, attributed);
}

TEST(HorizonBreakdown, SoleMinutesAreTheImpactOfRemovingABuilding) {
    const City city = quarter();
    const Receivers receivers = findMiddle(city);
    const SunSteps sun = threeMonths();
    const ShadowBreakdown all = breakDown(city, receivers, sun, makeOneSet(sun));
    const double total = totalMinM2(swept(city, receivers, sun), receivers);
    std::mt19937 random(3);
    for (int i = 0; i < 50; ++i) {
        const BuildingShadow& shadow = all.buildings[random() % all.buildings.size()];
        City without = city;
        without.buildings.erase(without.buildings.begin() + std::ptrdiff_t(shadow.building));
        EXPECT_DOUBLE_EQ(total - totalMinM2(swept(without, receivers, sun), receivers), shadow.soleMinM2[0])
            << shadow.building;
    }
}

/// Bridges between towers, canopies on podiums, towers on stilts, and stacked slabs, among buildings on the
/// ground.
City overhangingQuarter() {
    City city = cityOf(randomBoxes(8, 6));
    const auto add = [&](const std::vector<Box3>& boxes) {
        Building building;
        for (const Box3& box : boxes) building.parts.push_back(buildingOf(box)->parts.front());
        city.buildings.push_back(std::make_shared<const Building>(std::move(building)));
    };
    add({{{15, 15, 12}, {75, 22, 18}}});
    add({{{30, 5, 0}, {45, 20, 25}}, {{22, 0, 30}, {60, 30, 32}}});
    add({{{40, 40, 20}, {60, 60, 90}}, {{41, 41, 0}, {44, 44, 20}}, {{56, 56, 0}, {59, 59, 20}}});
    add({{{50, 20, 10}, {90, 60, 11}}});
    add({{{55, 25, 14}, {95, 65, 15}}, {{60, 30, 18}, {80, 50, 19}}});
    return city;
}

TEST(HorizonBreakdown, WhatHangsAddsUpToTheSweepsField) {
    const City city = overhangingQuarter();
    const Receivers receivers = receiversOver(city, -20, -20, 140, 140, 3);
    const SunSteps sun = threeMonths();
    const ShadowField field = swept(city, receivers, sun);
    for (const bool byBuilding : {false, true}) {
        const ShadowBreakdown months = breakDown(city, receivers, sun, monthsOf(sun), byBuilding);
        for (std::size_t i = 0; i < receivers.cells.size(); ++i) {
            const float minutes = months.minutes[0][i] + months.minutes[1][i] + months.minutes[2][i];
            ASSERT_EQ(float(double(minutes) / field.days), field.grossMin[receivers.cells[i]]);
        }
        double attributed = 0;
        for (const BuildingShadow& shadow : months.buildings) attributed += sum(shadow.attributedMinM2);
        if (byBuilding) {
            EXPECT_DOUBLE_EQ(attributed, totalMinM2(field, receivers));
        }
    }
}

TEST(HorizonBreakdown, SoleMinutesOfWhatHangsAreTheImpactOfRemovingIt) {
    const City city = overhangingQuarter();
    const Receivers receivers = receiversOver(city, -20, -20, 140, 140, 3);
    const SunSteps sun = threeMonths();
    const ShadowBreakdown all = breakDown(city, receivers, sun, makeOneSet(sun));
    const double total = totalMinM2(swept(city, receivers, sun), receivers);
    ASSERT_GE(all.buildings.size(), 38U);
    for (const BuildingShadow& shadow : all.buildings) {
        City without = city;
        without.buildings.erase(without.buildings.begin() + std::ptrdiff_t(shadow.building));
        EXPECT_DOUBLE_EQ(total - totalMinM2(swept(without, receivers, sun), receivers), shadow.soleMinM2[0])
            << shadow.building;
    }
}

// Sun from the south. Receivers 40 m behind two slabs, one at 10 m and one just above it at 12 m: the suns
// between the slopes of the two edges are divided between the slabs, and neither slab is charged with those
// of the other.
TEST(HorizonBreakdown, TwoSlabsOverOneAnotherShareWhatTheyHide) {
    const City city = cityOf({{{-200, -30, 10}, {200, -10, 11}}, {{-200, -30, 12}, {200, -10, 13}}});
    const Receivers receivers = receiversOver(city, -2, 9, 2, 11);
    std::vector<Sun> suns;
    for (int i = 0; i < 120; ++i) suns.push_back({180, 0.25 + 0.5 * i});
    const ShadowBreakdown shadow = breakDown(city, receivers, oneDay(suns), makeOneSet(oneDay(suns)));
    ASSERT_EQ(shadow.buildings.size(), 2U);
    const auto hidden = [&](const Receivers& of, double bottom, double top) {
        double minM2 = 0;
        for (const std::uint32_t cell : of.cells)
            for (const Sun& sun : suns) {
                const double tan = std::tan(sun.altitudeDeg * std::numbers::pi / 180),
                             y = of.position(cell).y;
                minM2 += tan > bottom / (y + 30) && tan < top / (y + 10);
            }
        return minM2;
    };
    const double lower = hidden(receivers, 10, 11), upper = hidden(receivers, 12, 13),
                 both = hidden(receivers, 10, 13), shared = lower + upper - both;
    ASSERT_GT(shared, 50);
    const double rounding = double(receivers.cells.size());
    EXPECT_NEAR(shadow.buildings[0].attributedMinM2[0], lower, rounding);
    EXPECT_NEAR(shadow.buildings[1].attributedMinM2[0], upper - shared, rounding);
    EXPECT_NEAR(shadow.buildings[0].soleMinM2[0], lower - shared, rounding);
    EXPECT_NEAR(shadow.buildings[1].soleMinM2[0], upper - shared, rounding);
}

// A single tower is the sole contributor to its shadow. Of two towers in line with the sun, the one behind
// adds nothing.
TEST(HorizonBreakdown, ATowerBehindAHigherOneHasNothingOfItsOwn) {
    const City city = cityOf({{{0, 0, 0}, {20, 10, 60}}, {{5, -40, 0}, {15, -30, 10}}});
    const Receivers receivers = receiversOver(city, 0, 12, 20, 30);
    const SunSteps sun = oneDay({{180, 20}, {181, 21}, {179, 22}});
    const ShadowBreakdown shadow = breakDown(city, receivers, sun, makeOneSet(sun));
    ASSERT_EQ(shadow.buildings.size(), 1U);
    EXPECT_EQ(shadow.buildings[0].building, 0U);
    EXPECT_EQ(shadow.buildings[0].soleMinM2, shadow.buildings[0].attributedMinM2);
}

}  // namespace
}  // namespace noonmark
