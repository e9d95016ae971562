#include "core/receivers/rasterize.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace noonmark {
namespace {

std::vector<int> coversOf(const std::vector<Footprint>& footprints, const Grid& grid) {
    std::vector<int> covers(grid.size());
    for (const Footprint& footprint : footprints)
        forEachRun(footprint, grid, [&](int row, int first, int end) {
            for (int column = first; column < end; ++column) ++covers[grid.index(column, row)];
        });
    return covers;
}

// Steps of one half place points and whole edges exactly on cell centres and cell edges.
glm::vec2 randomPoint(std::mt19937& random, float step) {
    return {float(random() % 60) * step - 5, float(random() % 60) * step - 5};
}

Ring randomRing(std::mt19937& random, float step) {
    Ring ring(3 + random() % 8);
    for (glm::vec2& point : ring) point = randomPoint(random, step);
    return ring;
}

void expectAgreement(const Footprint& footprint, const Grid& grid) {
    const auto covers = coversOf({footprint}, grid);
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            ASSERT_EQ(covers[grid.index(column, row)], contains(footprint, grid.centre(column, row)) ? 1 : 0)
                << column << ' ' << row;
}

TEST(Rasterize, AgreesWithContainsForAnyRings) {
    std::mt19937 random(1);
    for (int i = 0; i < 600; ++i) {
        const float step = i % 3 == 0 ? 0.5F : i % 3 == 1 ? 1.0F : 0.37F;
        Footprint footprint{randomRing(random, step), {}};
        if (i % 2 == 0) footprint.holes.push_back(randomRing(random, step));
        const Grid grid{-4, -3, i % 5 == 0 ? 0.3 : 1.0, 24, 28};
        SCOPED_TRACE(i);
        expectAgreement(footprint, grid);
    }
}

TEST(Rasterize, AgreesWithContainsFarFromTheOrigin) {
    std::mt19937 random(2);
    for (int i = 0; i < 100; ++i) {
        Ring ring = randomRing(random, 0.5F);
        for (glm::vec2& point : ring) point += glm::vec2(-12000.25F, 9000.75F);
        expectAgreement({ring, {}}, {-12004, 8997, 0.25, 120, 120});
    }
}

// An irregular net of four-sided lots fills a block: every cell belongs to exactly one of them.
TEST(Rasterize, PartyWallsShareNoCellAndLeaveNoneOut) {
    constexpr int lots = 12;
    std::mt19937 random(3);
    for (int round = 0; round < 20; ++round) {
        std::vector<glm::vec2> corners;
        const float step = round % 2 == 0 ? 0.5F : 0.07F;
        for (int y = 0; y <= lots; ++y)
            for (int x = 0; x <= lots; ++x) {
                const auto jitter = [&](int at) {
                    return at == 0 || at == lots ? 0.0F : float(int(random() % 5) - 2) * step;
                };
                const glm::vec2 moved{jitter(x), jitter(y)};
                corners.push_back(glm::vec2(float(x), float(y)) * 5.0F + moved);
            }
        std::vector<Footprint> block;
        for (int y = 0; y < lots; ++y)
            for (int x = 0; x < lots; ++x) {
                const auto at = [&](int dx, int dy) {
                    return corners[std::size_t(y + dy) * (lots + 1) + std::size_t(x + dx)];
                };
                block.push_back({{at(0, 0), at(1, 0), at(1, 1), at(0, 1)}, {}});
            }
        for (const int covers : coversOf(block, {0, 0, 0.5, lots * 10, lots * 10})) ASSERT_EQ(covers, 1);
    }
}

TEST(Rasterize, FootprintsOutsideTheGridFillNothing) {
    const Grid grid{0, 0, 1, 4, 4};
    for (const glm::vec2 to : {glm::vec2(-50, 0), glm::vec2(50, 0), glm::vec2(0, -50), glm::vec2(0, 50)}) {
        const Footprint far{{to, to + glm::vec2(4, 0), to + glm::vec2(0, 4)}, {}};
        EXPECT_EQ(coversOf({far}, grid), std::vector<int>(16));
    }
    EXPECT_EQ(coversOf({Footprint{}}, grid), std::vector<int>(16));
    EXPECT_EQ(coversOf({Footprint{{{-9, -9}, {9, -9}, {9, 9}, {-9, 9}}, {}}}, grid), std::vector<int>(16, 1));
}

}  // namespace
}  // namespace noonmark
