#include "core/receivers/tile_plan.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/measures/error_sample.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

/// The index in the whole grid of a tile's cell.
std::size_t cellOfWhole(const TilePlan& plan, const Grid& tile, int column, int row) {
    const glm::dvec2 centre = tile.centre(column, row);
    return plan.whole.index(int((centre.x - plan.whole.westM) / plan.whole.cellM),
                            int((centre.y - plan.whole.southM) / plan.whole.cellM));
}

TEST(TilePlan, EveryCellIsInOneTile) {
    const TilePlan plan{{-10, 20, 0.5, 150, 97}, 64};
    EXPECT_EQ(plan.columns(), 3);
    EXPECT_EQ(plan.rows(), 2);
    std::vector<int> seen(plan.whole.size(), 0);
    for (std::size_t number = 0; number < plan.count(); ++number) {
        const Grid tile = plan.tile(number);
        for (int row = 0; row < tile.rows; ++row)
            for (int column = 0; column < tile.columns; ++column)
                ++seen[cellOfWhole(plan, tile, column, row)];
    }
    EXPECT_EQ(seen, std::vector<int>(plan.whole.size(), 1));
}

TEST(TilePlan, TheFirstTileIsTheNorthWesternOneAndWhole) {
    const TilePlan plan{{0, 0, 1, 150, 97}, 64};
    EXPECT_EQ(plan.tile(0), (Grid{0, 33, 1, 64, 64}));
    EXPECT_EQ(plan.tile(5), (Grid{128, 0, 1, 22, 33}));
}

TEST(TilePlan, ReceiversOfTilesAreThoseOfTheWhole) {
    const City city = cityOf(randomBoxes(3, 8));
    const Region region{"cut", {{{{-10, -10}, {150, 0}, {140, 170}, {20, 120}}, {}}}};
    const Receivers whole = placeReceiversOnGround(city, region, {}).value();
    const TilePlan plan{*gridOver(region, {}), 64};
    EXPECT_EQ(plan.whole, whole.grid);
    std::size_t receivers = 0;
    for (std::size_t number = 0; number < plan.count(); ++number) {
        const Receivers part = placeReceiversInPart(city, region, plan.tile(number)).value();
        receivers += part.cells.size();
        for (int row = 0; row < part.grid.rows; ++row)
            for (int column = 0; column < part.grid.columns; ++column)
                ASSERT_EQ(part.kind[part.grid.index(column, row)],
                          whole.kind[cellOfWhole(plan, part.grid, column, row)]);
    }
    EXPECT_EQ(receivers, whole.cells.size());
}

TEST(TilePlan, ErrorSamplesOfTilesAreSpreadOverTheWhole) {
    const City city = cityOf(randomBoxes(3, 8));
    const Receivers whole = receiversOver(city, -20, -20, 180, 180);
    const TilePlan plan{whole.grid, 64};
    std::size_t count = 0;
    for (std::size_t number = 0; number < plan.count(); ++number) {
        const Receivers part =
            placeReceiversInPart(city, makeRegionFromLocalBox({{-20, -20}, {180, 180}}), plan.tile(number))
                .value();
        const auto cells = spreadReceivers(part, plan.whole, 600, 1);
        for (const std::uint32_t cell : cells) EXPECT_EQ(part.kind[cell], CellKind::ground);
        count += cells.size();
    }
    const double share = double(whole.cells.size()) / double(whole.grid.size());
    EXPECT_NEAR(double(count), 600 * share, 40);
}

}  // namespace
}  // namespace noonmark
