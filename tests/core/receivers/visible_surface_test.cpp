#include "core/engines/ray/visible_surface.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

constexpr int width = 64, height = 48;

// One box of 20 m on a plane, seen from the south and above.
struct View {
    City city = cityOf({{{-10, -10, 0}, {10, 10, 20}}});
    PixelCamera camera = makeCamera({0, -100, 60}, {0, 0, 10}, 40, width, height);
    VisibleSurface surface = findVisibleSurface(RayScene::over(city).value(), true, camera).value();
};

TEST(VisibleSurface, PointsLieOnTheirPixelsRaysAndFaceTheEye) {
    const View view;
    for (std::size_t i = 0; i < view.surface.points.size(); ++i) {
        const glm::dvec3 way = glm::dvec3(view.surface.points.positions[i]) - view.camera.eye;
        const int pixel = int(view.surface.pixel[i]);
        const glm::dvec3 ray = lineThrough(view.camera, pixel % width, pixel / width).direction;
        EXPECT_LT(glm::length(glm::cross(glm::normalize(way), glm::normalize(ray))), 1e-6);
        EXPECT_LT(glm::dot(glm::vec3(way), view.surface.points.normals[i]), 0);
        EXPECT_NEAR(glm::length(view.surface.points.normals[i]), 1, 1e-5);
    }
}

TEST(VisibleSurface, SeesRoofFacadeAndGround) {
    const View view;
    int roof = 0, facade = 0, ground = 0;
    for (std::size_t i = 0; i < view.surface.points.size(); ++i) {
        const glm::vec3 p = view.surface.points.positions[i], n = view.surface.points.normals[i];
        const bool inside = std::abs(p.x) <= 10.001F && std::abs(p.y) <= 10.001F;
        if (std::abs(p.z - 20) < 1e-3F && inside && n.z > 0.99F) ++roof;
        if (std::abs(p.y + 10) < 1e-3F && p.z < 20 && n.y < -0.99F) ++facade;
        if (p.z == 0 && !inside && n.z == 1) ++ground;
    }
    EXPECT_GT(roof, 20);
    EXPECT_GT(facade, 50);
    EXPECT_EQ(std::size_t(roof + facade + ground), view.surface.points.size());
}

// The box is cut at half its height: its roof and the facade above are gone, and its inside is not seen.
TEST(VisibleSurface, OnlyWhatLiesInTheSectionIsSeen) {
    View view;
    view.camera.section = VisibleBox{{-30, -30, -1}, {30, 30, 10}};
    const auto cut = findVisibleSurface(RayScene::over(view.city).value(), true, view.camera).value();
    int facade = 0, ground = 0;
    for (std::size_t i = 0; i < cut.points.size(); ++i) {
        const glm::vec3 p = cut.points.positions[i];
        EXPECT_LE(p.z, 10.011F);
        EXPECT_LE(std::max(std::abs(p.x), std::abs(p.y)), 30.011F);
        const bool onFacade = std::abs(p.y + 10) < 1e-3F && cut.points.normals[i].y < -0.99F;
        onFacade ? ++facade : ++ground;
        if (!onFacade) {
            EXPECT_EQ(p.z, 0) << "neither roof nor inner walls";
        }
    }
    EXPECT_GT(facade, 20);
    EXPECT_GT(ground, 50);
    EXPECT_LT(cut.points.size(), view.surface.points.size());
}

TEST(VisibleSurface, AParallelProjectionIsToScale) {
    View view;
    // From straight above, 60 m of ground in 48 pixels: 1.25 m a pixel; the box of 20 m covers 16 pixels a
    // side.
    view.camera = makeCamera({0, 0, 500}, {0, 0, 0}, 40, width, height);
    view.camera.heightM = 60;
    const auto surface = findVisibleSurface(RayScene::over(view.city).value(), true, view.camera).value();
    ASSERT_EQ(surface.points.size(), std::size_t(width * height));
    int roof = 0;
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        const glm::vec3 p = surface.points.positions[i];
        const int column = int(surface.pixel[i]) % width, row = int(surface.pixel[i]) / width;
        EXPECT_NEAR(p.x, (column + 0.5 - width / 2.0) * 1.25, 1e-3);
        EXPECT_NEAR(p.y, (height / 2.0 - row - 0.5) * 1.25, 1e-3);
        EXPECT_GT(surface.points.normals[i].z, 0.99F) << "no facade is seen from above";
        if (p.z > 19) ++roof;
    }
    EXPECT_EQ(roof, 16 * 16);
}

TEST(VisibleSurface, SkyHasNoPoint) {
    const View view;
    const PixelCamera level = makeCamera({0, -100, 5}, {0, 0, 5}, 40, width, height);
    const auto surface = findVisibleSurface(RayScene::over(view.city).value(), true, level).value();
    EXPECT_LT(surface.points.size(), std::size_t(width * height) * 3 / 4);
    EXPECT_GT(surface.points.size(), std::size_t(width * height) / 3);
    const auto nothing = findVisibleSurface(RayScene::over(view.city).value(), false,
                                            makeCamera({0, -100, 5}, {0, -200, 5}, 40, width, height));
    EXPECT_EQ(nothing->points.size(), 0U);
}

TEST(VisibleSurface, RefusesPicturesOutOfRange) {
    const RayScene scene = RayScene::over(City{}).value();
    EXPECT_FALSE(findVisibleSurface(scene, true, makeCamera({0, 0, 9}, {0, 0, 0}, 40, 0, 10)));
    EXPECT_FALSE(findVisibleSurface(scene, true, makeCamera({0, 0, 9}, {0, 0, 0}, 180, 10, 10)));
}

}  // namespace
}  // namespace noonmark
