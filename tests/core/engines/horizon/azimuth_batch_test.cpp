#include "core/engines/horizon/geometry/azimuth_batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>

#include "core/engines/horizon/counting/short_sums.h"
#include "core/engines/horizon/horizon_sweep.h"
#include "core/engines/horizon/sweep/tile_sweep.h"
#include "tests/core/engines/sweep_scenes.h"
#include "tests/core/engines/terrain_scenes.h"

namespace noonmark::tests {
namespace {

glm::dvec2 awayOf(double azimuthDeg) {
    const double azimuth = azimuthDeg * std::numbers::pi / 180;
    return {-std::sin(azimuth), -std::cos(azimuth)};
}

/// Bins in all directions, at most 0.7 deg apart.
std::vector<SweptBin> binsAllAround() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> step(0.05, 0.7), altitude(3, 50);
    std::vector<SweptBin> bins;
    for (double azimuth = 0; azimuth < 360; azimuth += step(random))
        bins.push_back({awayOf(azimuth), toSunCode(std::tan(altitude(random) * std::numbers::pi / 180))});
    return bins;
}

TEST(AzimuthBatch, BatchesHoldEachBinOnceInOrder) {
    const std::vector<SweptBin> bins = binsAllAround();
    std::size_t next = 0;
    for (const BatchRange& batch : groupIntoBatches(bins)) {
        EXPECT_EQ(batch.first, next);
        EXPECT_GE(batch.size(), 1U);
        EXPECT_LE(batch.size(), std::size_t(BatchLanes::maximum));
        const ShadowAxes first(bins[batch.first].away), last(bins[batch.end - 1].away);
        EXPECT_EQ(first.swapped, last.swapped);
        EXPECT_EQ(first.sign, last.sign);
        EXPECT_LT(std::abs(first.k - last.k), 0.1);
        next = batch.end;
    }
    EXPECT_EQ(next, bins.size());
    EXPECT_TRUE(groupIntoBatches({}).empty());
}

/// Codes by bin and block.
using Squares = std::map<std::pair<std::size_t, std::size_t>, std::vector<HorizonCode>>;

Squares squaresOf(const TileScene& scene, std::span<const SweptBin> bins,
                  std::span<const BatchRange> batches) {
    Squares squares;
    TileSweep sweep;
    for (const BatchRange& batch : batches)
        sweep.run(scene, bins.subspan(batch.first, batch.size()),
                  [&](std::size_t bin, std::size_t block, const HorizonCode* codes, bool) {
                      if (codes != nullptr)
                          squares[{batch.first + bin, block}].assign(codes, codes + ReceiverBlocks::cells);
                  },
                  {});
    return squares;
}

/// Rotated by random angles, so that walls face in all directions.
City turnedBlocks() {
    City city;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> turn(0, 90), size(4, 30), height(3, 90);
    for (int i = 0; i < 100; ++i) {
        const double a = turn(random) * std::numbers::pi / 180, wide = size(random), deep = size(random);
        const glm::dvec2 middle(45 * (i % 10), 45 * (i / 10)), x(std::cos(a), std::sin(a)), y(-x.y, x.x);
        Ring ring;
        for (const glm::dvec2 corner : {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
            ring.push_back(glm::vec2(middle + x * corner.x * wide / 2.0 + y * corner.y * deep / 2.0));
        city.buildings.push_back(buildingOf({ring, {}}, 0, float(height(random))));
    }
    return city;
}

TEST(AzimuthBatch, HorizonsOfABatchAreThoseOfEachAzimuthAloneToTheLastBit) {
    const City city = turnedBlocks();
    const Receivers receivers = receiversOver(city, 60, 55, 330, 340);
    std::vector<std::uint32_t> all(city.buildings.size());
    std::iota(all.begin(), all.end(), 0U);
    OverhangParts open;
    const WallList walls = collectStandingObstacles(city, all, receivers, open);
    const ReceiverBlocks blocks(receivers, {0, 0, receivers.grid.columns, receivers.grid.rows});
    const BlockGrounds grounds(receivers, blocks, walls.datumM);
    const TileScene scene{walls, blocks, grounds, receivers.grid.cellM};
    const std::vector<SweptBin> bins = binsAllAround();
    std::vector<BatchRange> alone;
    for (std::size_t bin = 0; bin < bins.size(); ++bin) alone.push_back({bin, bin + 1});
    const Squares together = squaresOf(scene, bins, groupIntoBatches(bins)),
                  apart = squaresOf(scene, bins, alone);
    EXPECT_GT(together.size(), bins.size() * blocks.blocks().size() / 4);
    std::size_t different = 0;
    for (const auto& [place, codes] : apart) {
        const auto found = together.find(place);
        // A batch may examine a block that a single azimuth recognises as level immediately.
        const std::vector<HorizonCode> level(ReceiverBlocks::cells, noHorizon);
        different += codes != (found == together.end() ? level : found->second);
    }
    EXPECT_EQ(different, 0U);
}

ShadowField counted(const City& city, const Receivers& receivers, const SunSteps& sun, ShadowCounts counts) {
    NoProgress progress;
    return HorizonSweep({.binDeg = 0.5, .counts = counts})
        .accumulate(city, receivers, sun, progress, {})
        .value();
}

void expectSameGross(const City& city, const Receivers& receivers) {
    const SunSteps sun = threeDays();
    const ShadowField both = counted(city, receivers, sun, ShadowCounts::grossAndRuns),
                      gross = counted(city, receivers, sun, ShadowCounts::gross);
    double maximum = 0;
    for (const std::uint32_t cell : receivers.cells) {
        EXPECT_EQ(gross.grossMin[cell], both.grossMin[cell]) << cell;
        EXPECT_TRUE(std::isnan(gross.continuousMin[cell])) << cell;
        maximum = std::max(maximum, double(both.continuousMin[cell]));
    }
    EXPECT_GT(maximum, 0);
}

TEST(GrossAlone, IsThatOfASweepWithRuns) {
    const City city = turnedBlocks();
    expectSameGross(city, receiversOver(city, 60, 55, 330, 340));
}

TEST(GrossAlone, IsThatOfASweepWithRunsWherePartsHang) {
    const City city = cityOf({{{0, 0, 10}, {30, 25, 13}}, {{40, 0, 0}, {50, 20, 30}}});
    expectSameGross(city, receiversOver(city, -60, -60, 90, 90));
}

TEST(GrossAlone, IsThatOfASweepWithRunsOnTerrain) {
    const City city =
        groundOf(80, [](glm::dvec2 place) { return std::max(0.0, 40 - 2 * std::abs(place.x + 5)); });
    expectSameGross(city, receiversOver(city, -100, -20, -30, 20));
}

TEST(BlockSums, CountEachSquareHoweverItsLinesRun) {
    const City city;
    const Receivers receivers = receiversOver(city, 0, 0, 40, 20);
    const ReceiverBlocks blocks(receivers, {0, 0, receivers.grid.columns, receivers.grid.rows});
    const HorizonCode suns[] = {-30'000, -20'000, -20'000};
    const std::vector<CountChange> changes = findSunChanges(suns, {});
    std::vector<HorizonCode> codes(ReceiverBlocks::cells, noHorizon);
    codes[3 * ReceiverBlocks::side + 7] = -25'000;  // hides one sun
    codes[7 * ReceiverBlocks::side + 3] = 0;        // hides all
    BlockSums sums;
    sums.begin(blocks.blocks().size());
    for (int turn = 0; turn < 40'000; ++turn) sums.add(1, turn % 2 == 1, codes.data(), changes);
    sums.add(0, false, nullptr, changes);
    std::vector<std::uint32_t> steps(blocks.numbers());
    sums.addTo(blocks, steps);
    for (std::size_t number = 0; number < blocks.numbers(); ++number) {
        const std::uint32_t cell = blocks.cell(number);
        const bool either =
            cell == receivers.grid.index(16 + 7, 3) || cell == receivers.grid.index(16 + 3, 7);
        EXPECT_EQ(steps[number], either ? 20'000U * 4 : 0U) << number;
    }
}

}  // namespace
}  // namespace noonmark::tests
