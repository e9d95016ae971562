#include "core/lab/graph/direction_graph.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <random>
#include <set>

#include "core/base/units.h"
#include "core/lab/graph/graph_engine.h"
#include "core/sun/sun_steps.h"

namespace noonmark {
namespace {

SunStep stepTowards(glm::dvec3 direction, int slot) {
    const glm::dvec3 d = glm::normalize(direction);
    const double azimuth = Radians{std::atan2(d.x, d.y)}.degrees().value;
    return {.direction = glm::vec3(d),
            .azimuthDeg = float(azimuth < 0 ? azimuth + 360 : azimuth),
            .altitudeDeg = float(Radians{std::asin(d.z)}.degrees().value),
            .slot = slot};
}

// Days on which the sun moves along one great circle, tilted slightly more each day, so that interpolation
// between the ends is exact.
SunSteps greatCircleDays(int days, int stepsADay, double tiltADayDeg) {
    SunSteps sun;
    for (int day = 0; day < days; ++day) {
        const double tilt = Degrees{30 + day * tiltADayDeg}.radians().value;
        sun.days.push_back({.first = std::uint32_t(sun.steps.size()), .count = std::uint32_t(stepsADay)});
        for (int k = 0; k < stepsADay; ++k) {
            const double angle = Degrees{20 + 140.0 * k / stepsADay}.radians().value;
            sun.steps.push_back(stepTowards(
                {std::cos(angle), -std::sin(angle) * std::sin(tilt), std::sin(angle) * std::cos(tilt)}, k));
        }
    }
    return sun;
}

// A stub engine: receiver i is shaded where an irregular function of the direction exceeds a limit.
bool shadedAt(std::size_t receiver, glm::dvec3 direction) {
    return std::sin(direction.x * (8 + double(receiver % 17)) + double(receiver)) > 0.3;
}

class PatternEngine final : public IntervalEngine {
    class Scene final : public IntervalScene {
        Result<void> shade(const SunInterval& interval, std::span<ShadowMask> masks,
                           std::stop_token) override {
            for (std::size_t i = 0; i < masks.size(); ++i) {
                masks[i] = 0;
                for (int k = 0; k < interval.steps; ++k)
                    masks[i] |= ShadowMask(shadedAt(i, interval.at(k))) << k;
            }
            return {};
        }
        [[nodiscard]] Cost cost() const override { return {}; }
    };

public:
    [[nodiscard]] Result<std::unique_ptr<IntervalScene>> prepare(const City&, const Receivers&,
                                                                 const SunSteps&,
                                                                 std::stop_token) const override {
        return std::make_unique<Scene>();
    }
    [[nodiscard]] std::string_view name() const override { return "Pattern"; }
    [[nodiscard]] std::string describe() const override { return "pattern"; }
};

Receivers someReceivers(int count) {
    Receivers receivers;
    receivers.grid = {0, 0, 1, count, 1};
    receivers.kind.assign(std::size_t(count), CellKind::ground);
    for (int i = 0; i < count; ++i) receivers.cells.push_back(std::uint32_t(i));
    return receivers;
}

TEST(ShadowMask, RunsAgreeWithCounting) {
    std::mt19937_64 random(3);
    for (int round = 0; round < 2000; ++round) {
        const int steps = 1 + int(random() % 64);
        const ShadowMask half = random(), maximum = random() | half;
        const ShadowMask mask = random() & maximum & fullMask(steps);
        MaskRuns expected;
        int run = 0;
        for (int k = 0; k < steps; ++k) {
            run = (mask >> k & 1) != 0 ? run + 1 : 0;
            expected.gross = std::uint8_t(expected.gross + (run > 0));
            expected.longest = std::max(expected.longest, std::uint8_t(run));
            if (run == k + 1) expected.prefix = std::uint8_t(run);
        }
        expected.suffix = std::uint8_t(run);
        EXPECT_EQ(measureRuns(mask, steps), expected);
    }
    EXPECT_EQ(measureRuns(fullMask(64), 64), (MaskRuns{64, 64, 64, 64}));
}

TEST(DirectionBins, AreNoWiderThanTheBound) {
    const DirectionBins bins(greatCircleDays(5, 365, 1), 5, 60);
    std::mt19937 random(5);
    std::normal_distribution<double> any;
    std::map<std::uint32_t, std::vector<glm::dvec3>> members;
    for (int i = 0; i < 40000; ++i) {
        const glm::dvec3 direction = glm::normalize(glm::dvec3(any(random), any(random), any(random)));
        members[bins.of(direction)].push_back(direction);
    }
    const double furthest = std::cos(Degrees{5.01}.radians().value);
    for (const auto& [bin, directions] : members)
        for (const glm::dvec3& direction : directions)
            EXPECT_GT(glm::dot(direction, directions.front()), furthest) << bin;
}

// The circles of the bins are those of the sun: during a day it stays between two of them.
TEST(DirectionBins, ADayStaysInOneRing) {
    for (const double latitudeDeg : {-66.0, -34.0, 0.0, 40.7, 69.6}) {
        const Observer observer{.place = {0, latitudeDeg}};
        const SunSteps sun = computeSunSteps({.hours = 6}, observer).value();
        const DirectionBins bins(sun, 5, 60);
        std::set<std::uint32_t> rings;
        for (const SunStep& step : sun.steps) rings.insert(bins.of(glm::dvec3(step.direction)) >> 16U);
        EXPECT_EQ(rings.size(), 1U) << latitudeDeg;
    }
}

// The paper has 299 edges for the 2,190 hours of a year. New York has about as many here, with a smaller
// distance between merged directions.
TEST(DirectionGraph, AYearOfSixHoursHasAsManyEdgesAsThePapers) {
    const SunSteps sun =
        computeSunSteps({.start = {std::chrono::year{2026}, std::chrono::January, std::chrono::day{1}},
                         .days = 365,
                         .from = std::chrono::hours(9),
                         .hours = 6,
                         .zone = "America/New_York"},
                        {.place = {-73.98, 40.75}})
            .value();
    const DirectionGraph graph = buildDirectionGraph(sun, {}).value();
    EXPECT_EQ(graph.intervals, 2190U);
    EXPECT_LE(graph.edges.size(), 299U);
    EXPECT_LT(buildDirectionGraph(sun, {.boundDeg = 10})->edges.size(), graph.edges.size());
}

TEST(DirectionGraph, MergesIntervalsThatLookAlikeAndLosesNone) {
    const SunSteps sun = greatCircleDays(30, 365, 0.2);
    const auto graph = buildDirectionGraph(sun, {});
    ASSERT_TRUE(graph.has_value());
    EXPECT_EQ(graph->intervals, 30U * 7U);  // six hours and a remainder of five minutes
    EXPECT_LT(graph->edges.size(), 40U);
    std::uint64_t steps = 0;
    for (const auto& edge : graph->edges) steps += std::uint64_t(edge.weight) * std::uint64_t(edge.sun.steps);
    EXPECT_EQ(steps, sun.steps.size());
}

TEST(DirectionGraph, RefusesSettingsOutOfRange) {
    const SunSteps sun = greatCircleDays(1, 60, 0);
    EXPECT_FALSE(buildDirectionGraph(sun, {.boundDeg = 0}).has_value());
    EXPECT_FALSE(buildDirectionGraph(sun, {.intervalMinutes = 121}).has_value());
    EXPECT_FALSE(buildDirectionGraph(sun, {.intervalMinutes = 0}).has_value());
    EXPECT_FALSE(
        buildDirectionGraph(sun, {.intervalMinutes = 65}).has_value());  // 65 steps do not fit into a mask
}

TEST(GraphEngine, StitchesRunsAcrossIntervals) {
    const SunSteps sun = greatCircleDays(3, 205, 3);
    const Receivers receivers = someReceivers(200);
    NoProgress progress;
    const GraphEngine engine(std::make_shared<PatternEngine>(), {.merge = false});
    const auto field = engine.accumulate({}, receivers, sun, progress, {});
    ASSERT_TRUE(field.has_value());
    for (std::size_t i = 0; i < 200; ++i) {
        int gross = 0, longest = 0;
        for (const SunDay& day : sun.days) {
            int run = 0;
            for (std::uint32_t k = day.first; k < day.first + day.count; ++k) {
                run = shadedAt(i, glm::dvec3(sun.steps[k].direction)) ? run + 1 : 0;
                gross += run > 0;
                longest = std::max(longest, run);
            }
        }
        // A step exactly at the pattern's edge may differ because of rounding.
        EXPECT_NEAR(field->grossMin[i], gross / 3.0, 1.01) << i;
        EXPECT_NEAR(field->continuousMin[i], longest, 1.01) << i;
    }
}

TEST(GraphEngine, ShortStepsMakeShorterIntervals) {
    SunSteps sun = greatCircleDays(1, 200, 0);
    sun.stepMinutes = 0.5;
    const Receivers receivers = someReceivers(10);
    NoProgress progress;
    const GraphEngine engine(std::make_shared<PatternEngine>(), {});
    EXPECT_TRUE(engine.accumulate({}, receivers, sun, progress, {}).has_value());
}

TEST(DirectionGraph, AGapInTheDayBreaksTheRun) {
    SunSteps sun = greatCircleDays(1, 120, 0);
    for (std::size_t k = 90; k < 120; ++k) sun.steps[k].slot += 10;
    const auto graph = buildDirectionGraph(sun, {});
    ASSERT_TRUE(graph.has_value());
    ASSERT_EQ(graph->paths.size(), 1U);
    ASSERT_EQ(graph->paths[0].size(), 3U);  // 60, 30, and 30 after the gap
    EXPECT_FALSE(graph->paths[0][1].breaksRun);
    EXPECT_TRUE(graph->paths[0][2].breaksRun);
}

}  // namespace
}  // namespace noonmark
