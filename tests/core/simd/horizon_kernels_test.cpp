// Kernels of the horizon sweep on every instruction set of the machine, against scalar code written from
// their contracts. All comparisons are of bits.

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <random>
#include <span>

#include "core/engines/horizon/attribution/attributed_block.h"
#include "core/engines/horizon/geometry/bin_walls.h"
#include "core/engines/horizon/sweep/raise_block.h"
#include "tests/core/simd/random_blocks.h"

namespace noonmark {
namespace {

constexpr int side = ReceiverBlocks::side;

BlockRows anyRows(Random& random) { return {double(anyFrom(random, -1, 1)), random() % 2 == 0 ? 1.0 : -1.0}; }

// Every fourth wall is ahead of all cells; ends fall on cells now and then.
WallOnBlock anyWall(Random& random) {
    WallOnBlock wall{};
    wall.high = anyFrom(random, -40, 10);
    wall.low = wall.high + anyFrom(random, 0.01F, 32);
    if (random() % 4 == 0) wall.low = std::round(wall.low);
    if (random() % 4 == 0) wall.high = std::round(wall.high);
    wall.slope = anyFrom(random, -1, 1);
    wall.ahead = random() % 4 == 0;
    wall.along = wall.ahead ? anyFrom(random, 150, 400) : anyFrom(random, -20, 60);
    wall.rise = anyFrom(random, 1, 200);
    wall.riseSlope = random() % 2 == 0 ? 0 : anyFrom(random, -2, 2);
    wall.perRise = 1 / wall.rise;
    wall.nearest = computeNearestAlong(random() % 2 == 0 ? 1e-4F : -1e-4F, wall.slope);
    wall.building = std::int32_t(random() % 3);
    return wall;
}

/// A wall or an edge seen from one cell.
struct KernelEdge {
    bool shades;
    float cot;
};

// `perRise`: for walls, which all cells see at the same rise.
KernelEdge seeWall(const WallOnBlock& wall, const BlockRows& rows, int row, int place, float perRise) {
    const float low = wall.low - rows.shifts[std::size_t(row)],
                high = wall.high - rows.shifts[std::size_t(row)];
    const float distance = (wall.along + rows.alongs[std::size_t(row)]) - wall.slope * low;
    const float cot = distance * perRise - wall.slope * perRise * float(place);
    const bool before = float(place) + low >= 0 && float(place) + high < 0;
    return {before && cot > wall.nearest * perRise, cot > 0 ? cot : 0};
}

KernelEdge seeEdge(const WallOnBlock& wall, const BlockRows& rows, int row, int place, float ground) {
    const float low = wall.low - rows.shifts[std::size_t(row)];
    const float over = wall.rise + wall.riseSlope * (float(place) + low) - ground;
    if (!(over > 0)) return {false, 0};
    return seeWall(wall, rows, row, place, 1 / over);
}

// Of two arrays.
void expectSameBits(const auto& a, const auto& b) {
    EXPECT_TRUE(std::ranges::equal(std::as_bytes(std::span(a)), std::as_bytes(std::span(b))));
}

TEST(HorizonKernels, WallsRaiseABlockAsScalarCodeDoes) {
    Random random(1);
    for (int n = 0; n < 200; ++n) {
        const ReceiverBlocks::Masks masks = anyMasks(random);
        const BlockRows rows = anyRows(random);
        std::vector<WallOnBlock> walls(1 + random() % 70);
        for (WallOnBlock& wall : walls) wall = anyWall(random);
        BlockHorizons expected;
        float lowest = BlockHorizons::notReceiver;
        for (int row = 0; row < side; ++row)
            for (int place = 0; place < side; ++place) {
                const bool receiver = (masks[std::size_t(row)] >> place & 1) != 0;
                float cot = receiver ? std::numeric_limits<float>::infinity() : BlockHorizons::notReceiver;
                for (const WallOnBlock& wall : walls)
                    if (const KernelEdge seen = seeWall(wall, rows, row, place, wall.perRise); seen.shades)
                        cot = std::min(cot, seen.cot);
                expected.rows[row].values[place] = cot;
                lowest = std::max(lowest, cot);
            }
        forEachInstructionSet([&] {
            BlockHorizons horizons;
            clearBlock(masks, horizons);
            EXPECT_EQ(raiseBlock(walls, rows, horizons), lowest);
            expectSameBits(horizons.rows, expected.rows);
        });
    }
}

TEST(HorizonKernels, EdgesRaiseUnevenBlocksAsScalarCodeDoes) {
    Random random(2);
    for (int n = 0; n < 500; ++n) {
        const BlockRows rows = anyRows(random);
        const WallOnBlock wall = anyWall(random);
        UnevenHorizons before;
        clearBlock(anyMasks(random), before);
        for (auto& row : before.rows)
            for (float& cot : row.values) cot = std::min(cot, anyFrom(random, 0, 4));
        for (auto& row : before.grounds)
            for (float& ground : row.values) ground = anyFrom(random, -5, 100);
        UnevenHorizons expected = before;
        for (int row = 0; row < side; ++row)
            for (int place = 0; place < side; ++place) {
                float& cot = expected.rows[row].values[place];
                const KernelEdge seen = seeEdge(wall, rows, row, place, before.grounds[row].values[place]);
                if (seen.shades && seen.cot < cot) cot = seen.cot;
            }
        forEachInstructionSet([&] {
            UnevenHorizons horizons = before;
            raiseBlock(wall, rows, horizons);
            expectSameBits(horizons.rows, expected.rows);
        });
    }
}

TEST(HorizonKernels, AttributedHorizonsNameTheBuildingThatMakesThem) {
    Random random(3);
    for (int n = 0; n < 100; ++n) {
        const BlockRows rows = anyRows(random);
        const ReceiverBlocks::Masks masks = anyMasks(random);
        std::vector<WallOnBlock> walls(20);
        for (WallOnBlock& wall : walls) wall = anyWall(random);
        float best[side][side], other[side][side];
        std::int32_t building[side][side];
        for (int row = 0; row < side; ++row)
            for (int place = 0; place < side; ++place) {
                const bool receiver = (masks[std::size_t(row)] >> place & 1) != 0;
                best[row][place] = other[row][place] = receiver ? std::numeric_limits<float>::infinity() : -1;
                building[row][place] = -1;
                for (const WallOnBlock& wall : walls) {
                    const KernelEdge seen = seeEdge(wall, rows, row, place, 0);
                    if (!seen.shades) continue;
                    const bool own = building[row][place] == wall.building;
                    if (seen.cot < best[row][place]) {
                        if (!own) other[row][place] = best[row][place];
                        best[row][place] = seen.cot;
                        building[row][place] = wall.building;
                    } else if (!own && seen.cot < other[row][place]) {
                        other[row][place] = seen.cot;
                    }
                }
            }
        forEachInstructionSet([&] {
            AttributedHorizons horizons;
            clearBlock(masks, horizons);
            std::ranges::fill(horizons.grounds, CacheLine<float>{});
            for (const WallOnBlock& wall : walls) raiseBlock(wall, rows, horizons);
            expectSameBits(horizons.highest.rows, best);
            expectSameBits(horizons.others.rows, other);
            expectSameBits(horizons.buildings, building);
        });
    }
}

TEST(HorizonKernels, CotangentsBecomeCodesAsInTheDefinition) {
    Random random(4);
    BlockHorizons horizons;
    for (auto& row : horizons.rows)
        for (float& cot : row.values) cot = std::exp(anyFrom(random, -12, 12));
    horizons.rows[3].values[5] = 0;
    horizons.rows[4].values[6] = std::numeric_limits<float>::infinity();
    horizons.rows[5].values[7] = BlockHorizons::notReceiver;
    const HorizonCode lowest = toHorizonCode(0.01F);
    forEachInstructionSet([&] {
        alignas(64) HorizonCode codes[ReceiverBlocks::cells];
        toCodes(horizons, lowest, codes);
        for (int i = 0; i < ReceiverBlocks::cells; ++i) {
            const float cot = horizons.rows[i / side].values[i % side];
            const int level =
                cot < 0 ? 0 : std::min(int(float(steepnessLevels) / (1 + cot)), steepnessLevels - 1);
            const int code = level + int(noHorizon);
            EXPECT_EQ(codes[i], cot >= 0 && code > lowest ? code : noHorizon) << i << ", " << cot;
        }
    });
}

TEST(HorizonKernels, NeedOfABlockIsThatOfItsLowestCells) {
    Random random(5);
    UnevenHorizons horizons;
    clearBlock(anyMasks(random), horizons);
    for (auto& row : horizons.rows)
        for (float& cot : row.values) cot = std::min(cot, anyFrom(random, 0, 4));
    for (auto& row : horizons.grounds)
        for (float& ground : row.values) ground = anyFrom(random, -5, 100);
    const BlockRows rows(0.3, 1);
    float minimum = 1e30F;
    for (int row = 0; row < side; ++row) {
        const float behind = 50 + rows.alongs[std::size_t(row)], surely = behind * (1 - 1e-5F) - 1e-2F;
        for (int place = 0; place < side; ++place) {
            const float cot = std::min(horizons.rows[row].values[place], 3.0F);
            if (cot < 0) continue;
            minimum =
                std::min(minimum, horizons.grounds[row].values[place] + 1 / std::max(cot, 1e-7F) * surely);
        }
    }
    forEachInstructionSet([&] {
        BlockNeed need;
        findNeed(horizons.rows, horizons.grounds, 3, need);
        EXPECT_EQ(findMinRise(need, rows, 50), minimum - 1e-3F);
    });
}

TEST(HorizonKernels, PiecesOutOfSightAreExcludedAlikeOnAllSets) {
    Random random(6);
    constexpr std::size_t count = 100;
    PieceBounds bounds;
    bounds.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float low = anyFrom(random, -50, 50);
        bounds.set(i, low, low + anyFrom(random, 0, 32), anyFrom(random, -100, 20), anyFrom(random, 0, 100));
    }
    const BlockQuery query{-5, 20, 30, 0.9F, 0.01F};
    std::vector<std::uint32_t> expected;
    forEachInstructionSet([&] {
        std::vector<std::uint32_t> found;
        for (std::size_t first = 0; first < count; first += PieceBounds::together)
            found.push_back(bounds.mayRaise(first, count, query));
        if (expected.empty()) expected = found;
        EXPECT_EQ(found, expected);
        EXPECT_EQ(found.back() >> (count % PieceBounds::together), 0U);
    });
    EXPECT_THAT(expected, testing::Contains(testing::Ne(0U)));
}

}  // namespace
}  // namespace noonmark
