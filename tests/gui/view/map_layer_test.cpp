#include "app/gui/view/panel/map_layer.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/gui/view/panel/ground_layers.h"
#include "render/view/city_view.h"
#include "tests/gui/small_city.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using Pixel = GroundPicture::Pixel;

Pixel pixelAt(const GroundPicture& picture, glm::dvec2 at) {
    const Grid& grid = picture.grid;
    return picture
        .pixels[grid.index(int((at.x - grid.westM) / grid.cellM), int((at.y - grid.southM) / grid.cellM))];
}

/// A lake whose shore is at x = 50.3 and y = 50.3.
MapContext makeLake() {
    MapContext context;
    const Footprint lake{{{0, 0}, {50.3F, 0}, {50.3F, 50.3F}, {0, 50.3F}}, {}};
    context.areas.push_back({ContextKind::water, "Lake", {lake}});
    return context;
}

TEST(ContextPicture, IsTheSameMapInPixelsOfAnySize) {
    const GroundPicture coarse = paintContextPicture(makeLake(), {{0, 0}, {100, 100}}, 2);
    const GroundPicture fine = paintContextPicture(makeLake(), {{40, 40}, {60, 60}}, 0.05);
    EXPECT_DOUBLE_EQ(fine.grid.cellM, 0.05);
    EXPECT_EQ(fine.grid.columns, 400);
    EXPECT_EQ(pixelAt(fine, {45, 45}), pixelAt(coarse, {45, 45}));
    EXPECT_EQ(pixelAt(fine, {50.2, 50.2}), pixelAt(fine, {45, 45}));
    EXPECT_EQ(pixelAt(fine, {50.4, 50.2}), Pixel{});
    EXPECT_EQ(pixelAt(coarse, {80, 80}), Pixel{});
}

TEST(ContextPicture, HasAtMostSoManyPixelsASide) {
    const GroundPicture picture = paintContextPicture(makeLake(), {{0, 0}, {100, 50}}, 0.01, 500);
    EXPECT_DOUBLE_EQ(picture.grid.cellM, 0.2);
    EXPECT_EQ(picture.grid.rows, 250);
}

TEST(ContextPicture, HasTreesAsDotsUnlessTheyAreLeftOut) {
    MapContext context = makeLake();
    context.trees.push_back({80, 80});
    const Box2 around{{0, 0}, {100, 100}};
    EXPECT_NE(pixelAt(paintContextPicture(context, around, 0.5), {80, 80}), Pixel{});
    const GroundPicture bare = paintContextPicture(context, around, 0.5, 500, false);
    EXPECT_EQ(pixelAt(bare, {80, 80}), Pixel{});
    EXPECT_NE(pixelAt(bare, {20, 20}), Pixel{}) << "the lake stays";
}

TEST(CloseGround, IsWhatIsSeenAroundTheTargetButNotTheHorizon) {
    const ViewBounds city{{{-5000, -5000}, {5000, 5000}}, 100, 0};
    const ViewLens lens{40, 1200, 800};
    const CameraPose low{{100, 50, 0}, 200, 0, 5};
    const double reachM = metresPerPixel(low, lens) * lens.widthPx;
    const Box2 box = findCloseGround(low, lens, city);
    EXPECT_NEAR(double(box.high.y), 50 + reachM, 0.01);
    EXPECT_GE(double(box.low.y), 50 - reachM - 0.01);
    const CameraPose above{{100, 50, 0}, 200, 0, 90};
    EXPECT_EQ(findCloseGround(above, lens, city), bounds(visibleGround(above, lens, city)));
    EXPECT_TRUE(findCloseGround({{0, 9000, 0}, 300, 0, 60}, lens, city).empty());
}

TEST(MapLayerTest, IsFinerWhereTheCameraIsCloseAndCoarseFarAway) {
    CityView view;
    view.resize(400, 300);
    City city = test::smallCity();
    city.context = std::make_shared<const MapContext>(makeLake());
    view.showCity(std::make_shared<const CityArrays>(makeArrays(city)));
    MapLayer map(view);
    map.showCity(city);
    view.setPose({{50, 50, 0}, 20, 0, 60});
    const double pixelM = metresPerPixel(view.pose(), view.lens()) / view.devicePixelRatio();
    ASSERT_TRUE(test::waitFor([&] { return map.finerCellM().has_value(); }));
    EXPECT_NEAR(*map.finerCellM(), pixelM, 0.5 * pixelM);
    view.setPose({{50, 50, 0}, 2000, 0, 60});
    EXPECT_TRUE(test::waitFor([&] { return !map.finerCellM(); }));
}

}  // namespace
}  // namespace noonmark
