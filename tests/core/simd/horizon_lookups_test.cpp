// Kernels on horizon codes, on every instruction set of the machine, against scalar code written from their
// contracts.

#include <gmock/gmock.h>

#include <algorithm>

#include "core/engines/horizon/cache/block_codes.h"
#include "core/engines/horizon/counting/run_decider.h"
#include "core/engines/horizon/counting/sun_change.h"
#include "core/engines/horizon/counting/walk_steps.h"
#include "core/engines/horizon/overhangs/overhang_intervals.h"
#include "tests/core/simd/random_blocks.h"

namespace noonmark {
namespace {

constexpr int blockSide = ReceiverBlocks::side;

HorizonCode anyCode(Random& random) { return HorizonCode(random() % 8 == 0 ? noHorizon : random() % 4000); }

BlockCodes anyCodes(Random& random) {
    BlockCodes codes;
    for (HorizonCode& code : codes.values) code = anyCode(random);
    return codes;
}

bool isIn(const ReceiverBlocks::Masks& masks, int cell) {
    return (masks[std::size_t(cell / blockSide)] >> (cell % blockSide) & 1) != 0;
}

TEST(HorizonLookups, CodesOfABlockAreComparedCellByCell) {
    Random random(1);
    const BlockCodes a = anyCodes(random);
    BlockCodes b = anyCodes(random);
    for (int i = 0; i < ReceiverBlocks::cells; i += 3) b.values[i] = a.values[i];
    const ReceiverBlocks::Masks masks = anyMasks(random);
    HorizonCode minimum = HorizonCode(steepnessLevels / 2);
    for (int i = 0; i < ReceiverBlocks::cells; ++i)
        if (isIn(masks, i)) minimum = std::min(minimum, a.values[i]);
    forEachInstructionSet([&] {
        EXPECT_EQ(findLowest(a.values, masks), minimum);
        BlockCodes turned, raised = a, others = a;
        transpose(a.values, turned);
        raise(b.values, raised);
        setOthers(masks, 77, others);
        ReceiverBlocks::Masks differ, equal;
        findDifferences(a.values, b.values, masks, differ);
        findEqual(a.values, b.values, masks, equal);
        for (int i = 0; i < ReceiverBlocks::cells; ++i) {
            const bool in = isIn(masks, i), same = a.values[i] == b.values[i];
            EXPECT_EQ(turned.values[i % blockSide * blockSide + i / blockSide], a.values[i]);
            EXPECT_EQ(raised.values[i], std::max(a.values[i], b.values[i]));
            EXPECT_EQ(others.values[i], in ? a.values[i] : 77);
            EXPECT_EQ(isIn(differ, i), in && !same);
            EXPECT_EQ(isIn(equal, i), in && same && a.values[i] != noHorizon);
        }
    });
}

TEST(HorizonLookups, CountsOfSunsAreAddedForEachHorizon) {
    Random random(2);
    for (const int last : {1, 5, 900, 65'534}) {
        const int lowest = last > 60'000 ? int(noHorizon) : 100;
        std::vector<std::int16_t> counts(std::size_t(last) + 2);
        for (std::int16_t& count : counts) count = std::int16_t(int(random() % 600) - 300);
        counts[0] = 0;
        const SunTable table{counts.data(), lowest, last};
        std::vector<HorizonCode> codes(331);
        for (HorizonCode& code : codes) code = anyCode(random);
        std::fill_n(codes.begin() + 64, 64, HorizonCode{32'000});  // a vector of the last count only
        forEachInstructionSet([&] {
            std::vector<std::int16_t> sums(codes.size(), 7);
            addCounts(table, codes.data(), codes.size(), sums.data());
            for (std::size_t i = 0; i < codes.size(); ++i)
                EXPECT_EQ(sums[i], 7 + counts[std::size_t(std::clamp(codes[i] - lowest, 0, last))]);
        });
    }
}

TEST(HorizonLookups, DifferencesOfCountsAreAddedForCellsOfTheMasks) {
    Random random(3);
    std::vector<std::int16_t> counts(902);
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = std::int16_t(i / 7);
    const SunTable table{counts.data(), 100, 900};
    const BlockCodes before = anyCodes(random);
    BlockCodes after = before;
    for (int i = 0; i < 5 * blockSide; ++i) after.values[i] = anyCode(random);
    const ReceiverBlocks::Masks masks = anyMasks(random);
    forEachInstructionSet([&] {
        std::uint32_t sums[ReceiverBlocks::cells] = {};
        unsigned changed = 0;
        const unsigned rows = addDifferences(table, before.values, after.values, masks, sums);
        for (int i = 0; i < ReceiverBlocks::cells; ++i) {
            const int more = isIn(masks, i) ? table.of(after.values[i]) - table.of(before.values[i]) : 0;
            EXPECT_EQ(sums[i], std::uint32_t(more));
            if (more != 0) changed |= 1U << (i / blockSide);
        }
        EXPECT_EQ(rows, changed);
    });
}

TEST(HorizonLookups, RunsAreWalkedLaneByLane) {
    Random random(4);
    constexpr std::size_t bins = 40;
    std::vector<RunLanes> horizons(bins);
    for (RunLanes& lanes : horizons)
        for (std::int16_t& code : lanes.values) code = anyCode(random);
    std::vector<TimedStep> steps(300);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        steps[i].place = {std::uint16_t(i * bins / steps.size()), std::int16_t(random() % 3000)};
        steps[i].startsRun = random() % 50 == 0;
    }
    forEachInstructionSet([&] {
        RunLanes longest;
        longest.values[9] = 250;
        walkSteps(horizons, steps, longest);
        for (std::size_t lane = 0; lane < lanesPerPart; ++lane) {
            int run = 0, walked = lane == 9 ? 250 : 0;
            for (const TimedStep& step : steps) {
                if (step.startsRun) run = 0;
                run = horizons[step.place.bin].values[lane] > step.place.sun ? run + 1 : 0;
                walked = std::max(walked, run);
            }
            EXPECT_EQ(longest.values[lane], walked) << lane;
        }
    });
}

/// Strips blockSide by blockSide that cover part of a block.
StripLanes anyStrips(Random& random) {
    StripLanes strips;
    float q = anyFrom(random, -12, 6);
    for (strips.count = 0; strips.count < 5; ++strips.count) {
        const int i = strips.count;
        strips.low[i] = q;
        strips.high[i] = q += random() % 2 == 0 ? 2.0F : anyFrom(random, 0.1F, 6);
        for (StripLanes::Side* of : {&strips.near, &strips.far}) {
            of->distance[i] = anyFrom(random, -10, 40);
            of->slope[i] = anyFrom(random, -1, 1);
            of->rise[i] = anyFrom(random, -5, 60);
            of->riseSlope[i] = anyFrom(random, -1, 1);
        }
        if (random() % 4 == 0) q += 1;  // a gap between strips
    }
    return strips;
}

TEST(HorizonLookups, VisibleCellsOfOverhangsAreThoseOfScalarCode) {
    Random random(5);
    for (int n = 0; n < 100; ++n) {
        const StripLanes strips = anyStrips(random);
        ViewingBlock block;
        block.horizons = anyCodes(random);
        std::vector<float> grounds(ReceiverBlocks::cells);
        for (float& ground : grounds) ground = anyFrom(random, -3, 3);
        if (n % 2 == 0) block.groundsM = grounds.data();
        const BlockAxes axes{0, 0, anyFrom(random, -1, 1), n % 3 == 0 ? -1.0F : 1.0F, 1.25F};
        constexpr HorizonCode highest = 2500;
        VisibleCells expected;
        for (int cell = 0; cell < ReceiverBlocks::cells; ++cell)
            for (int strip = 0; strip < strips.count; ++strip) {
                const int row = cell / blockSide;
                const float place = float(cell % blockSide), shift = axes.shift * float(row),
                            along = axes.sign * float(row);
                if (!(strips.low[strip] + shift <= place && place < strips.high[strip] + shift)) continue;
                if (block.horizons.values[cell] > highest) break;
                const float width = place - (strips.low[strip] + shift);
                const float ground =
                    block.groundsM == nullptr ? 0 : grounds[std::size_t(cell)] * axes.alongPerMetre;
                const auto distance = [&](const StripLanes::Side& of) {
                    return (of.distance[strip] + along) - of.slope[strip] * width;
                };
                const auto rise = [&](const StripLanes::Side& of) {
                    return (of.rise[strip] + of.riseSlope[strip] * width) - ground;
                };
                if (!(distance(strips.far) > 1e-3F)) break;
                const int i = expected.count++;
                expected.cell[i] = cell;
                expected.toNear[i] = distance(strips.near), expected.toFar[i] = distance(strips.far);
                expected.nearRise[i] = rise(strips.near), expected.farRise[i] = rise(strips.far);
                break;
            }
        forEachInstructionSet([&] {
            VisibleCells seen;
            addVisibleCells(strips, block, axes, highest, seen);
            ASSERT_EQ(seen.count, expected.count);
            for (int i = 0; i < seen.count; ++i) {
                EXPECT_EQ(seen.cell[i], expected.cell[i]);
                EXPECT_EQ(seen.toNear[i], expected.toNear[i]);
                EXPECT_EQ(seen.toFar[i], expected.toFar[i]);
                EXPECT_EQ(seen.nearRise[i], expected.nearRise[i]);
                EXPECT_EQ(seen.farRise[i], expected.farRise[i]);
            }
        });
    }
}

HorizonCode codeOfRise(float rise, float distance) {
    return rise > 0 ? toHorizonCode(rise / (rise + distance)) : noHorizon;
}

TEST(HorizonLookups, IntervalsOfVisibleCellsAreThoseOfTheDefinition) {
    Random random(6);
    VisibleCells seen;
    seen.count = 203;
    for (int i = 0; i < seen.count; ++i) {
        seen.cell[i] = i;
        seen.toNear[i] = anyFrom(random, -20, 60);
        seen.toFar[i] = anyFrom(random, 0.01F, 90);
        seen.nearRise[i] = anyFrom(random, -20, 60);
        seen.farRise[i] = anyFrom(random, -20, 60);
    }
    for (const bool solid : {false, true})
        forEachInstructionSet([&] {
            alignas(64) HorizonCode low[VisibleCells::maximum], high[VisibleCells::maximum];
            findIntervals(seen, solid, low, high);
            for (int i = 0; i < seen.count; ++i) {
                const float over = solid
                                       ? seen.farRise[i]
                                       : seen.nearRise[i] * seen.toFar[i] - seen.farRise[i] * seen.toNear[i];
                const HorizonCode zenith = HorizonCode(steepnessLevels - 1 + int(noHorizon)),
                                  near = seen.toNear[i] > 0 ? codeOfRise(seen.nearRise[i], seen.toNear[i])
                                         : over > 0         ? zenith
                                                            : noHorizon,
                                  far = codeOfRise(seen.farRise[i], seen.toFar[i]);
                EXPECT_EQ(low[i], std::min(near, far)) << i;
                EXPECT_EQ(high[i], std::max(near, far)) << i;
            }
        });
}

TEST(HorizonLookups, HorizonsAreWidenedLaneByLane) {
    Random random(5);
    RunLanes before, own, after;
    for (std::size_t lane = 0; lane < lanesPerPart; ++lane) {
        before.values[lane] = own.values[lane] = after.values[lane] = anyCode(random);
        if (lane % 3 == 1) own.values[lane] = anyCode(random);
        if (lane % 3 == 2) after.values[lane] = anyCode(random);
    }
    forEachInstructionSet([&] {
        RunLanes highest, lowest, bound;
        findHighest({before, own, after}, highest);
        bound = highest;
        boundOffEdge({before, own, after}, {0.5F, 0.5F}, lowest, &bound);
        for (std::size_t lane = 0; lane < lanesPerPart; ++lane) {
            const auto [low, high] = std::minmax({before.values[lane], own.values[lane], after.values[lane]});
            EXPECT_EQ(highest.values[lane], high) << lane;
            EXPECT_EQ(lowest.values[lane], high - low <= 3 ? low : noHorizon) << lane;
            EXPECT_EQ(bound.values[lane], high - low <= 3 ? high : everyHorizon) << lane;
        }
    });
}

}  // namespace
}  // namespace noonmark
