#include "core/lab/inverse/shadow_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "core/base/units.h"
#include "core/lab/inverse/shadow_lines_opencl.h"

namespace noonmark {
namespace {

glm::dvec3 sunAt(double azimuthDeg, double altitudeDeg) {
    const double a = Degrees{azimuthDeg}.radians().value, e = Degrees{altitudeDeg}.radians().value;
    return {std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e)};
}

const SunInterval morning{sunAt(110, 25), sunAt(124, 35), 60};

/// Shadow sources of the cells of a grid: levels x cells, 0 where there is none.
struct GridSources {
    Grid grid;
    int levels;
    std::vector<float> heightM;
    std::vector<std::uint32_t> building;

    GridSources(const Grid& of, int levelCount)
        : grid(of),
          levels(levelCount),
          heightM(std::size_t(levels) * grid.size()),
          building(heightM.size()) {}

    /// The sources on all blocks of the lanes.
    [[nodiscard]] LaneSources on(const Lanes& lanes) const {
        LaneSources sources;
        sources.resize(levels, lanes.majors(), lanes.blocks());
        forEachPlace(lanes, [&](int block, int major, int lane, std::size_t cell) {
            for (int level = 0; level < levels; ++level) {
                const std::size_t from = std::size_t(level) * grid.size() + cell,
                                  to = sources.line(block, major, level);
                sources.heightM[to].values[lane] = heightM[from];
                sources.building[to].values[lane] = heightM[from] > 0 ? building[from] : LaneSources::nobody;
            }
        });
        return sources;
    }

    /// Calls body(block, major, lane of the block, cell).
    static void forEachPlace(const Lanes& lanes, const auto& body) {
        for (int lane = 0; lane < lanes.count(); ++lane)
            for (int major = 0; major < lanes.majors(); ++major)
                if (const int minor = lanes.minor(lane, major); lanes.onGrid(minor))
                    body(lane / Lanes::perBlock, major, lane % Lanes::perBlock, lanes.cellAt(major, minor));
    }
};

GridSources randomSources(const Grid& grid, int levels) {
    std::mt19937 random(11);
    GridSources sources(grid, levels);
    for (std::size_t cell = 0; cell < grid.size(); ++cell)
        for (int level = 0; level < levels && random() % 3 != 0; ++level) {
            const std::size_t place = std::size_t(level) * grid.size() + cell;
            sources.heightM[place] = float(random() % 8 * 40 + random() % 5) / 2.0F;
            sources.building[place] = std::uint32_t(level) + 3 * std::uint32_t(random() % 3);
        }
    return sources;
}

/// The masks of the cells; masks that are not wanted are unspecified. Empty `asked`: all are wanted.
std::vector<ShadowMask> drawn(ShadowLineDrawer& drawer, const GridSources& sources,
                              const ShadowMotion& motion, const std::vector<bool>& asked = {}) {
    const Lanes lanes(sources.grid, motion.shift);
    LaneMasks masks;
    masks.resize(lanes.majors(), lanes.blocks());
    for (int block = 0; block < lanes.blocks(); ++block)
        masks.ask(block, [&](int major, int lane) {
            const int minor = lanes.minor(block * Lanes::perBlock + lane, major);
            return lanes.onGrid(minor) && (asked.empty() || asked[lanes.cellAt(major, minor)]);
        });
    const auto done = drawer.draw(LinePass(lanes, motion, 4), sources.on(lanes), masks);
    EXPECT_TRUE(done.has_value()) << done.error().text();
    std::vector<ShadowMask> result(sources.grid.size());
    GridSources::forEachPlace(lanes, [&](int block, int major, int lane, std::size_t cell) {
        result[cell] = masks.lane(block, lane)[major];
    });
    return result;
}

TEST(Lanes, EachCellLiesOnOneLane) {
    const Grid grid{-5, 3, 0.5, 37, 23};
    for (int degrees = 0; degrees < 360; degrees += 7) {
        const double angle = Degrees{double(degrees)}.radians().value;
        const Lanes lanes(grid, {std::cos(angle), std::sin(angle)});
        std::vector<int> seen(grid.size());
        GridSources::forEachPlace(lanes, [&](int, int, int, std::size_t cell) { ++seen[cell]; });
        EXPECT_EQ(std::ranges::count(seen, 1), std::ptrdiff_t(grid.size())) << degrees;
    }
}

TEST(ShadowLines, AShadowLiesWhereTheSunThrowsIt) {
    const Grid grid{0, 0, 1, 200, 200};
    GridSources sources(grid, 1);
    const std::size_t start = grid.index(60, 120);
    const float height = 80;
    // Four cells: one pass draws the shadow of a single cell a third of a cell narrower than the cell, so at
    // some steps it falls between cells.
    for (const std::size_t cell : {start, grid.index(61, 120), grid.index(60, 121), grid.index(61, 121)})
        sources.heightM[cell] = height;
    const auto masks = drawn(*makeShadowLineDrawer(), sources, computeForwardMotion(morning));
    EXPECT_EQ(masks[start] & 1, 1U);
    const glm::dvec3 sun = morning.first;
    const glm::dvec2 middle = (grid.centre(60, 120) + grid.centre(61, 121)) / 2.0;
    const glm::dvec2 top = middle + glm::dvec2(sun) * (double(height) / sun.z);
    for (int step = 0; step < morning.steps; ++step) {
        const glm::dvec3 now = morning.at(step);
        const glm::dvec2 shadow = top - glm::dvec2(now) * (double(height) / now.z);
        // The nearest cell that is shaded at this step is less than a cell and a half away.
        double nearest = 1e9;
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column)
                if ((masks[grid.index(column, row)] >> step & 1) != 0)
                    nearest = std::min(nearest, glm::length(grid.centre(column, row) - shadow));
        EXPECT_LT(nearest, 1.5) << step;
    }
}

TEST(ShadowLines, NeighboursMoveAsOne) {
    // A slab of 12 cells: its shadow moves 7 cells from step to step and keeps its width, except for the
    // sixth of a cell per end that the pass from the other side adds.
    const Grid grid{0, 0, 1, 600, 3};
    GridSources sources(grid, 1);
    for (int column = 10; column < 22; ++column) sources.heightM[grid.index(column, 1)] = 400;
    ShadowMotion motion{{1, 0}, {}};
    for (int step = 0; step < 60; ++step) motion.fraction.push_back(step / 59.0);
    const auto masks = drawn(*makeShadowLineDrawer(), sources, motion);
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

TEST(ShadowLines, PlacesAskedForAreTheSameWhateverElseIs) {
    const GridSources sources = randomSources({0, 0, 1, 150, 90}, 3);
    std::mt19937 random(4);
    std::vector<bool> asked(sources.grid.size());
    for (std::size_t cell = 0; cell < asked.size(); ++cell) asked[cell] = random() % 40 == 0;
    for (const ShadowMotion& motion : {computeForwardMotion(morning), computeBackwardMotion(morning)}) {
        const auto all = drawn(*makeShadowLineDrawer(), sources, motion),
                   some = drawn(*makeShadowLineDrawer(), sources, motion, asked);
        for (std::size_t cell = 0; cell < asked.size(); ++cell)
            EXPECT_TRUE(!asked[cell] || some[cell] == all[cell]) << cell;
    }
}

TEST(ShadowLines, NoBitsBeyondTheSteps) {
    const SunInterval few{sunAt(110, 25), sunAt(124, 35), 7};
    for (const ShadowMask mask :
         drawn(*makeShadowLineDrawer(), randomSources({0, 0, 1, 150, 90}, 3), computeForwardMotion(few)))
        EXPECT_EQ(mask & ~fullMask(7), 0U);
}

// The piecewise lookup gives the same result as the ends of a run, cell by cell.
TEST(ShadowLines, ARunIsShadedAsItsEndsSay) {
    const ShadowMotion motion{{0.37, 0}, computeForwardMotion(morning).fraction};
    std::mt19937 random(8);
    for (int round = 0; round < 300; ++round) {
        const int first = int(random() % 60), width = int(random() % 40);
        GridSources sources({0, 0, 1, 160, 1}, 1);
        const float rise = float(int(random() % 5) - 2) * 0.5F, low = 1 + float(random() % 200);
        for (int i = 0; i <= width; ++i)
            sources.heightM[std::size_t(first) + std::size_t(i)] = std::max(0.5F, low + rise * float(i));
        const Lanes lanes(sources.grid, motion.shift);
        const LinePass pass(lanes, motion, 4);
        const SourceRun run{first, first + width, sources.heightM[std::size_t(first)],
                            sources.heightM[std::size_t(first) + std::size_t(width)], 0};
        const RunSweep sweep(run, pass.rule, 160);
        const auto masks = drawn(*makeShadowLineDrawer(), sources, motion);
        for (int i = 0; i < 160; ++i) {
            const bool inside = i >= first && i < first + sweep.count;
            EXPECT_EQ(masks[std::size_t(i)], inside ? sweep.steps(i - first, pass.table) : 0) << round;
        }
    }
}

TEST(ShadowLines, ASunOnTheHorizonDrawsToTheEdge) {
    const Grid grid{0, 0, 1, 50, 1};
    GridSources sources(grid, 1);
    sources.heightM[0] = 300;
    const ShadowMotion motion{{4e8, 0}, {0.0, 1e-10, 1.0}};  // 10^11 cells per second
    const auto masks = drawn(*makeShadowLineDrawer(), sources, motion);
    EXPECT_EQ(masks[0] & 1, 1U);
    EXPECT_EQ(masks[49] & 4, 0U);  // the last step lies far outside the grid
}

TEST(ShadowLines, BackwardIsForwardSeenFromTheOtherEnd) {
    const ShadowMotion forward = computeForwardMotion(morning);
    const ShadowMotion backward = computeBackwardMotion(morning);
    EXPECT_NEAR(forward.fraction.front(), 0, 1e-12);
    EXPECT_NEAR(forward.fraction.back(), 1, 1e-12);
    EXPECT_NEAR(backward.fraction.front(), 1, 1e-12);
    EXPECT_LT(glm::length(forward.shift + backward.shift), 1e-12);
    EXPECT_TRUE(std::ranges::is_sorted(forward.fraction));
}

TEST(ShadowLines, OpenClDrawsWhatTheProcessorDraws) {
    if (listComputeDevices().empty()) GTEST_SKIP() << "There is no OpenCL on this machine";
    auto openCl = makeOpenClDrawer(0);
    ASSERT_TRUE(openCl.has_value()) << openCl.error().text();
    const GridSources sources = randomSources({0, 0, 1, 150, 90}, 3);
    for (const ShadowMotion& motion : {computeForwardMotion(morning), computeBackwardMotion(morning)})
        EXPECT_EQ(drawn(**openCl, sources, motion), drawn(*makeShadowLineDrawer(), sources, motion));
}

TEST(ShadowLines, RefusesADeviceThatIsNotThere) { EXPECT_FALSE(makeOpenClDrawer(99).has_value()); }

}  // namespace
}  // namespace noonmark
