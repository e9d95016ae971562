#include "core/accumulate/shadow_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "core/accumulate/lanes.h"
#include "core/accumulate/shadow_lines_opencl.h"
#include "core/units.h"

namespace noonmark {
namespace {

glm::dvec3 sunAt(double azimuthDeg, double altitudeDeg) {
    const double a = Degrees{azimuthDeg}.radians().value, e = Degrees{altitudeDeg}.radians().value;
    return {std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e)};
}

const SunInterval morning{sunAt(110, 25), sunAt(124, 35), 60};

ShadowSources noSources(const Grid& grid, int levels) {
    return {levels, std::vector<float>(std::size_t(levels) * grid.size()),
            std::vector<std::uint32_t>(std::size_t(levels) * grid.size())};
}

ShadowSources randomSources(const Grid& grid, int levels) {
    std::mt19937 random(11);
    ShadowSources sources = noSources(grid, levels);
    for (std::size_t cell = 0; cell < grid.size(); ++cell)
        for (int level = 0; level < levels && random() % 3 != 0; ++level) {
            const std::size_t place = std::size_t(level) * grid.size() + cell;
            sources.heightM[place] = float(random() % 8 * 40 + random() % 5) / 2.0F;
            sources.building[place] = std::uint32_t(level) + 3 * std::uint32_t(random() % 3);
        }
    return sources;
}

TEST(Lanes, eachCellLiesOnOneLane) {
    const Grid grid{-5, 3, 0.5, 37, 23};
    for (int degrees = 0; degrees < 360; degrees += 7) {
        const double angle = Degrees{double(degrees)}.radians().value;
        const Lanes lanes(grid, {std::cos(angle), std::sin(angle)});
        std::vector<int> seen(grid.size());
        for (int lane = 0; lane < lanes.count(); ++lane) {
            const auto [first, end] = lanes.stretch(lane);
            for (int major = first; major < end; ++major) ++seen[lanes.cell(lane, major)];
        }
        EXPECT_EQ(std::ranges::count(seen, 1), std::ptrdiff_t(grid.size())) << degrees;
    }
}

TEST(ShadowLines, aShadowLiesWhereTheSunThrowsIt) {
    const Grid grid{0, 0, 1, 200, 200};
    ShadowSources sources = noSources(grid, 1);
    const std::size_t start = grid.index(60, 120);
    const float height = 80;
    // Four cells: one pass draws the shadow of a single one a third of a cell narrower than it, and between
    // the cells of some steps there is none.
    for (const std::size_t cell : {start, grid.index(61, 120), grid.index(60, 121), grid.index(61, 121)})
        sources.heightM[cell] = height;
    std::vector<ShadowMask> masks(grid.size());
    ASSERT_TRUE(makeShadowLineDrawer()->draw(grid, sources, motionForward(morning), masks, {}).has_value());
    EXPECT_EQ(masks[start] & 1, 1U);
    const glm::dvec3 sun = morning.first;
    const glm::dvec2 middle = (grid.centre(60, 120) + grid.centre(61, 121)) / 2.0;
    const glm::dvec2 top = middle + glm::dvec2(sun) * (double(height) / sun.z);
    for (int step = 0; step < morning.steps; ++step) {
        const glm::dvec3 now = morning.at(step);
        const glm::dvec2 shadow = top - glm::dvec2(now) * (double(height) / now.z);
        // The nearest cell that holds this step is less than a cell and a half away.
        double nearest = 1e9;
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column)
                if ((masks[grid.index(column, row)] >> step & 1) != 0)
                    nearest = std::min(nearest, glm::length(grid.centre(column, row) - shadow));
        EXPECT_LT(nearest, 1.5) << step;
    }
}

TEST(ShadowLines, neighboursMoveAsOne) {
    // A slab of 12 cells: its shadow moves 7 cells from one step to the next, and keeps its width but for the
    // sixth of a cell an end that the pass from the other side adds.
    const Grid grid{0, 0, 1, 600, 3};
    ShadowSources sources = noSources(grid, 1);
    for (int column = 10; column < 22; ++column) sources.heightM[grid.index(column, 1)] = 400;
    ShadowMotion motion{{1, 0}, {}};
    for (int step = 0; step < 60; ++step) motion.fraction.push_back(step / 59.0);
    std::vector<ShadowMask> masks(grid.size());
    ASSERT_TRUE(makeShadowLineDrawer()->draw(grid, sources, motion, masks, {}).has_value());
    for (int step = 0; step < 60; ++step) {
        const double west = 10 + step * 400 / 59.0;
        for (int column = 0; column < grid.columns; ++column) {
            const bool shaded = (masks[grid.index(column, 1)] >> step & 1) != 0;
            const bool inside = column > west + 0.77 && column < west + 11.23;
            const bool outside = column < west - 0.6 || column > west + 11.6;
            EXPECT_TRUE(shaded || !inside) << step << ' ' << column;
            EXPECT_FALSE(shaded && outside) << step << ' ' << column;
        }
    }
}

TEST(ShadowLines, fullMasksStayAndTheRestIsTheSame) {
    const Grid grid{0, 0, 1, 150, 90};
    const ShadowSources sources = randomSources(grid, 3);
    std::mt19937 random(4);
    std::vector<ShadowMask> masks(grid.size()), some(grid.size());
    for (ShadowMask& mask : some) mask = random() % 2 == 0 ? ~ShadowMask{0} : 0;
    const std::vector<ShadowMask> unasked = some;
    ASSERT_TRUE(makeShadowLineDrawer()->draw(grid, sources, motionForward(morning), masks, {}).has_value());
    ASSERT_TRUE(makeShadowLineDrawer()->draw(grid, sources, motionForward(morning), some, {}).has_value());
    for (std::size_t cell = 0; cell < grid.size(); ++cell)
        EXPECT_EQ(some[cell], unasked[cell] != 0 ? ~ShadowMask{0} : masks[cell]);
}

TEST(ShadowLines, aSunOnTheHorizonDrawsToTheEdge) {
    const Grid grid{0, 0, 1, 50, 1};
    ShadowSources sources = noSources(grid, 1);
    sources.heightM[0] = 300;
    const ShadowMotion motion{{4e8, 0}, {0.0, 1e-10, 1.0}};  // 10^11 cells a second
    std::vector<ShadowMask> masks(grid.size(), 0);
    ASSERT_TRUE(makeShadowLineDrawer()->draw(grid, sources, motion, masks, {}));
    EXPECT_EQ(masks[0] & 1, 1U);
    EXPECT_EQ(masks[49] & 4, 0U);  // the last step lies far beyond the grid
}

TEST(ShadowLines, backwardIsForwardSeenFromTheOtherEnd) {
    const ShadowMotion forward = motionForward(morning);
    const ShadowMotion backward = motionBackward(morning);
    EXPECT_NEAR(forward.fraction.front(), 0, 1e-12);
    EXPECT_NEAR(forward.fraction.back(), 1, 1e-12);
    EXPECT_NEAR(backward.fraction.front(), 1, 1e-12);
    EXPECT_LT(glm::length(forward.shift + backward.shift), 1e-12);
    EXPECT_TRUE(std::ranges::is_sorted(forward.fraction));
}

TEST(ShadowLines, openClDrawsWhatTheProcessorDraws) {
    if (computeDevices().empty()) GTEST_SKIP() << "There is no OpenCL on this machine";
    auto openCl = makeOpenClDrawer(0);
    ASSERT_TRUE(openCl.has_value()) << openCl.error().text();
    const Grid grid{0, 0, 1, 150, 90};
    const ShadowSources sources = randomSources(grid, 3);
    for (const ShadowMotion& motion : {motionForward(morning), motionBackward(morning)}) {
        std::vector<ShadowMask> expected(grid.size()), masks(grid.size());
        ASSERT_TRUE(makeShadowLineDrawer()->draw(grid, sources, motion, expected, {}).has_value());
        const auto drawn = (*openCl)->draw(grid, sources, motion, masks, {});
        ASSERT_TRUE(drawn.has_value()) << drawn.error().text();
        std::size_t different = 0;
        for (std::size_t i = 0; i < masks.size(); ++i) different += masks[i] != expected[i];
        EXPECT_EQ(different, 0U);
    }
}

TEST(ShadowLines, refusesADeviceThatIsNotThere) { EXPECT_FALSE(makeOpenClDrawer(99).has_value()); }

}  // namespace
}  // namespace noonmark
