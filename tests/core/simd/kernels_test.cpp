#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include "core/engines/depths/depth_slice.h"
#include "core/engines/projected/counting/cached_band.h"
#include "core/engines/projected/masks/caster_reach.h"
#include "core/lab/inverse/shadow_lines.h"
#include "core/lab/inverse/sources/projected_source_finder.h"
#include "core/simd/instruction_set.h"

// Kernels that engines reach rarely, or with few of their cases, against plain loops.
namespace noonmark {
namespace {

// Runs each test on every instruction set of this processor.
class Kernels : public ::testing::TestWithParam<InstructionSet> {
protected:
    void SetUp() override { ASSERT_TRUE(useInstructionSet(GetParam())); }
    void TearDown() override { ASSERT_TRUE(useInstructionSet(before_)); }
    int number(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
    double number(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }

private:
    InstructionSet before_ = instructionSetInUse();
    std::mt19937 random_{11};
};

INSTANTIATE_TEST_SUITE_P(InstructionSets, Kernels, ::testing::ValuesIn(availableInstructionSets()),
                         [](const auto& set) { return std::string(nameOf(set.param)); });

TEST_P(Kernels, RunsOfAWordAreThoseOfItsCells) {
    for (const std::size_t steps : {1U, 7U, 8U, 61U, 901U}) {
        const std::size_t eights = (steps + 7) / 8;
        std::vector<StepWords> words(eights, StepWords{});
        std::vector<RunStarts> starts(eights, RunStarts{});
        for (std::size_t step = 0; step < steps; ++step) starts[step / 8][step % 8] = number(0, 40) == 0;
        for (int cell = 0; cell < 64; ++cell)
            for (int run = 0; run < 4; ++run) {
                const int first = number(0, int(steps)), end = std::min(int(steps), first + number(0, 90));
                for (int step = first; step < end; ++step)
                    words[std::size_t(step) / 8].words[step % 8] |= std::uint64_t{1} << cell;
            }
        std::vector<const StepWords*> all;
        for (const StepWords& word : words) all.push_back(&word);
        WordRuns byLanes, byChanges, any;
        countByLanes(all, starts, steps, byLanes);
        countByChanges(all, starts, steps, byChanges);
        countRuns(all, starts, steps, any);
        for (std::size_t cell = 0; cell < 64; ++cell) {
            std::uint32_t gross = 0, longest = 0, run = 0;
            for (std::size_t step = 0; step < steps; ++step) {
                const bool shaded = (words[step / 8].words[step % 8] >> cell & 1) != 0;
                run = shaded ? (starts[step / 8][step % 8] ? 0 : run) + 1 : 0;
                gross += shaded;
                longest = std::max(longest, run);
            }
            for (const WordRuns* counted : {&byLanes, &byChanges, &any}) {
                EXPECT_EQ(counted->gross[cell], gross) << steps << ' ' << cell;
                EXPECT_EQ(counted->longest[cell], longest) << steps << ' ' << cell;
            }
        }
    }
}

TEST_P(Kernels, CountsOfBuildingsComeAndGo) {
    std::array<StepWords, CountTile::rows> removed{}, added{};
    std::vector<std::array<StepWords, CountTile::rows>> standing;
    CountTile tile;
    for (int round = 0; round < 60; ++round) {
        const bool removes = !standing.empty() && number(0, 2) == 0;
        removed = removes ? standing.front() : decltype(removed){};
        if (removes) standing.erase(standing.begin());
        for (StepWords& row : added)
            for (std::uint64_t& word : row.words)
                word = number(0, 1) == 0 ? 0 : ~std::uint64_t{0} << number(0, 63) >> number(0, 63);
        std::array<StepWords, CountTile::rows> before;
        for (int row = 0; row < CountTile::rows; ++row) before[std::size_t(row)] = tile.shaded(row);
        std::array<std::uint64_t, CountTile::rows> changed{};
        tile.change(0, CountTile::rows, removed.data(), added.data(), changed.data());
        standing.push_back(added);
        for (std::size_t row = 0; row < std::size_t(CountTile::rows); ++row) {
            std::uint64_t different = 0;
            for (std::size_t step = 0; step < stepsTogether; ++step) {
                std::uint64_t shaded = 0;
                for (const auto& building : standing) shaded |= building[row].words[step];
                EXPECT_EQ(tile.shaded(int(row)).words[step], shaded) << round;
                different |= shaded ^ before[row].words[step];
            }
            EXPECT_EQ(changed[row] & different, different) << round;
        }
    }
}

TEST_P(Kernels, CellsOfARunAreShadedAtTheStepsBetweenItsEnds) {
    StepTable table([] {
        std::vector<double> fractions;
        for (int step = 0; step < 60; ++step) fractions.push_back(step / 59.0);
        return fractions;
    }());
    for (int round = 0; round < 400; ++round) {
        const RunRule rule{float(number(0.01, 4.0)), 3};
        const int first = number(0, 40);
        const SourceRun run{first, first + number(0, 30), float(number(0.0, 40.0)), float(number(0.0, 40.0)),
                            1};
        const RunSweep sweep(run, rule, 200);
        const CellRange cells{number(0, 5), number(5, std::max(5, sweep.count))};
        std::vector<ShadowMask> row(std::size_t(sweep.count) + 8), expected(row.size());
        shadeCells(table.before.data(), sweep.plain, cells, row.data());
        for (int i = cells.first; i < std::min(cells.end, sweep.count); ++i)
            expected[std::size_t(i)] = sweep.plain.steps(i, table);
        EXPECT_EQ(row, expected) << round;
    }
}

TEST_P(Kernels, LanesBetweenCrossings) {
    for (int round = 0; round < 200; ++round) {
        const int count = number(1, 37), from = number(-20, 60);
        std::vector<double> low(std::size_t(count), 1e300), high(std::size_t(count), -1e300);
        std::vector<double> lowest = low, highest = high;
        std::vector<int> bend, firstLane(low.size()), endLane(low.size());
        for (int i = 0; i < count; ++i) bend.push_back(i / 3);
        for (int line = 0; line < 2; ++line) {
            const double minor = number(-30.0, 90.0), slope = number(-2.0, 2.0);
            widen(minor, slope, count, low.data(), high.data());
            for (int i = 0; i < count; ++i) {
                lowest[std::size_t(i)] = std::min(lowest[std::size_t(i)], minor + i * slope);
                highest[std::size_t(i)] = std::max(highest[std::size_t(i)], minor + i * slope);
            }
        }
        ASSERT_EQ(low, lowest);
        ASSERT_EQ(high, highest);
        const LanePlaces places{bend.data(), from, 3, 77};
        findLanesBetween(low.data(), high.data(), places, count, firstLane.data(), endLane.data());
        const auto laneOf = [&](double position, std::size_t i) {
            return int(std::ceil(std::clamp(position, 3.0, 77.0))) - from - bend[i];
        };
        for (std::size_t i = 0; i < low.size(); ++i) {
            EXPECT_EQ(firstLane[i], std::max(laneOf(low[i], i), 0));
            EXPECT_EQ(endLane[i], std::min(laneOf(high[i], i), 16));
        }
    }
}

TEST_P(Kernels, SpansOfAnyLengthRaiseTheirTexelsOnly) {
    for (int columns = 1; columns < 70; ++columns) {
        DepthSlice slice(columns + 4, 3);
        MapPolygon square{.place = {{{1.5, -0.5}, {1.5 + columns, -0.5}, {1.5 + columns, 1.5}, {1.5, 1.5}}},
                          .depth = {1, 1 + 0.25 * columns, 1 + 0.25 * columns, 1},
                          .corners = 4};
        EXPECT_EQ(DepthPainter().draw(square, slice), 2);
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < int(slice.stride); ++column) {
                const bool inside = row < 2 && column >= 2 && column < 2 + columns;
                const float depth = slice.depth[std::size_t(row) * slice.stride + std::size_t(column)];
                EXPECT_FLOAT_EQ(depth, inside ? 1 + 0.25F * (float(column) - 1.5F) : DepthSlice::empty);
            }
    }
}

TEST_P(Kernels, CastersThatTouchAreThoseOfThePlainTest) {
    for (int round = 0; round < 50; ++round) {
        ReachLimits limits;
        const double angle = number(0.0, 6.2);
        limits.acrossUnit = {std::cos(angle), std::sin(angle)};
        for (ReachLimits::Axis* axis : {&limits.x, &limits.y, &limits.across}) {
            axis->low = number(-100.0, 100.0);
            axis->high = axis->low + number(0.0, 50.0);
            axis->minimum = number(-3.0, 0.0);
            axis->maximum = number(0.0, 3.0);
        }
        CasterExtents extents;
        for (int i = 0; i < 80; ++i) {
            ShadowCaster caster;
            caster.low = {number(-200.0, 200.0), number(-200.0, 200.0)};
            caster.high = caster.low + glm::dvec2(number(0.0, 60.0), number(0.0, 60.0));
            caster.topM = float(number(1, 90));
            extents.add(caster);
        }
        const auto meets = [&](const ReachLimits::Axis& axis, double low, double high, std::size_t at) {
            return low + axis.minimum * extents.topM[at] <= axis.high &&
                   high + axis.maximum * extents.topM[at] >= axis.low;
        };
        const auto first = std::size_t(number(0, 16)), count = std::size_t(number(0, 64));
        std::uint64_t expected = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t at = first + i;
            double minimum = 1e30, maximum = -1e30;  // across: of the four corners
            for (const double x : {extents.lowX[at], extents.highX[at]})
                for (const double y : {extents.lowY[at], extents.highY[at]}) {
                    const double across = x * limits.acrossUnit.x + y * limits.acrossUnit.y;
                    minimum = std::min(minimum, across);
                    maximum = std::max(maximum, across);
                }
            if (meets(limits.across, minimum, maximum, at) &&
                meets(limits.x, extents.lowX[at], extents.highX[at], at) &&
                meets(limits.y, extents.lowY[at], extents.highY[at], at))
                expected |= std::uint64_t{1} << i;
        }
        ASSERT_EQ(findTouching(extents, first, count, limits), expected);
    }
}

}  // namespace
}  // namespace noonmark
