#include "render/view/camera_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace noonmark {
namespace {

const ViewLens lens{40, 1200, 800};
const ViewBounds city{{{-1500, -900}, {1200, 1100}}, 300, 0};

double flat(glm::dvec2) { return 0; }
double hill(glm::dvec2 p) { return 250 * std::exp(-(p.x * p.x + p.y * p.y) / 3e5); }

CameraPose poseFrom(std::mt19937& random) {
    const auto number = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    CameraPose pose;
    pose.target = {number(-800, 800), number(-800, 800), 0};
    pose.distanceM = number(50, 5000);
    pose.headingDeg = number(0, 360);
    pose.pitchDeg = number(5, 90);
    return pose;
}

TEST(CameraControl, AxesAreUnitAndSquareEvenStraightDown) {
    std::mt19937 random(1);
    for (int i = 0; i < 100; ++i) {
        CameraPose pose = poseFrom(random);
        if (i % 5 == 0) pose.pitchDeg = 90;
        EXPECT_NEAR(glm::length(computeForward(pose)), 1, 1e-12);
        EXPECT_NEAR(glm::length(computeUp(pose)), 1, 1e-12);
        EXPECT_NEAR(glm::dot(computeForward(pose), computeUp(pose)), 0, 1e-12);
        EXPECT_LT(glm::length(glm::cross(computeForward(pose), computeUp(pose)) - computeRight(pose)), 1e-12);
    }
}

TEST(CameraControl, NorthIsUpAndEastRightWhenLookingDownNorthUp) {
    const CameraPose pose{{0, 0, 0}, 1000, 0, 90};
    const auto north = pixelOf(pose, lens, {0, 100, 0});
    const auto east = pixelOf(pose, lens, {100, 0, 0});
    ASSERT_TRUE(north && east);
    EXPECT_NEAR(north->x, 600, 1e-9);
    EXPECT_LT(north->y, 400);
    EXPECT_GT(east->x, 600);
    EXPECT_NEAR(east->y, 400, 1e-9);
}

TEST(CameraControl, PixelOfUndoesRayThrough) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> x(0, lens.widthPx);
    std::uniform_real_distribution<double> y(0, lens.heightPx);
    for (int i = 0; i < 200; ++i) {
        const CameraPose pose = poseFrom(random);
        const glm::dvec2 pixel{x(random), y(random)};
        const ViewRay ray = makeRayThrough(pose, lens, pixel);
        const auto back = pixelOf(pose, lens, ray.origin + 321.0 * ray.direction);
        ASSERT_TRUE(back);
        EXPECT_LT(glm::length(*back - pixel), 1e-6);
    }
}

TEST(CameraControl, NothingBehindTheEyeHasAPixel) {
    EXPECT_FALSE(pixelOf({{0, 0, 0}, 1000, 0, 45}, lens, {0, -5000, 100}));
}

TEST(CameraControl, ZoomKeepsThePointUnderTheCursor) {
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        const CameraPose pose = poseFrom(random);
        const glm::dvec2 pixel{300, 700};
        const auto point = findPlaneHit(makeRayThrough(pose, lens, pixel), 0);
        if (!point) continue;
        const auto after = pixelOf(zoom(pose, *point, 0.8), lens, *point);
        ASSERT_TRUE(after);
        EXPECT_LT(glm::length(*after - pixel), 1e-4);
    }
}

TEST(CameraControl, PanKeepsTheGroundUnderTheCursor) {
    const CameraPose pose{{10, 20, 0}, 1500, 30, 50};
    const glm::dvec2 from{500, 500};
    const glm::dvec2 to{640, 430};
    const auto ground = findPlaneHit(makeRayThrough(pose, lens, from), 0);
    const auto after = pixelOf(pan(pose, from, to, lens), lens, *ground);
    ASSERT_TRUE(after);
    EXPECT_LT(glm::length(*after - to), 1e-6);
}

TEST(CameraControl, PanAtTheHorizonStaysWithinReach) {
    const CameraPose pose{{0, 0, 0}, 1000, 0, 3};
    const CameraPose there = pan(pose, {600, 382}, {600, 700}, lens);
    EXPECT_LE(glm::length(there.target - pose.target), pose.distanceM * 1.001);
}

CameraPose inParallel(CameraPose pose) {
    pose.projection = Projection::parallel;
    return pose;
}

TEST(CameraControl, AParallelProjectionIsToScaleAtAnyHeight) {
    // 1000 m away, 40 degrees: 2 * 1000 * tan 20 = 727.94 m in 800 pixels.
    const CameraPose plan = inParallel({{0, 0, 0}, 1000, 0, 90});
    const double pixelsPerM = 800 / 727.9405;
    for (const double z : {0.0, 50.0, 300.0}) {
        const auto pixel = pixelOf(plan, lens, {100, 100, z});
        ASSERT_TRUE(pixel);
        EXPECT_NEAR(pixel->x, 600 + 100 * pixelsPerM, 1e-3);
        EXPECT_NEAR(pixel->y, 400 - 100 * pixelsPerM, 1e-3);
    }
    EXPECT_NEAR(metresPerPixel(plan, lens), 1 / pixelsPerM, 1e-6);
    EXPECT_EQ(metresPerPixel(plan, lens, 17), metresPerPixel(plan, lens));
    const CameraPose perspective{{0, 0, 0}, 1000, 0, 90};
    EXPECT_NEAR(pixelOf(perspective, lens, {100, 100, 0})->x, 600 + 100 * pixelsPerM, 1e-3)
        << "as large at the target";
}

TEST(CameraControl, PanZoomAndPickingHoldInAParallelProjection) {
    std::mt19937 random(4);
    for (int i = 0; i < 200; ++i) {
        const CameraPose pose = inParallel(poseFrom(random));
        const glm::dvec2 from{500, 500}, to{640, 430};
        const ViewRay ray = makeRayThrough(pose, lens, from);
        const glm::dvec3 point = ray.origin + 1234.5 * ray.direction;
        EXPECT_LT(glm::length(*pixelOf(pose, lens, point) - from), 1e-6);
        EXPECT_LT(glm::length(*pixelOf(pan(pose, from, to, lens), lens, point) - to), 1e-5);
        EXPECT_LT(glm::length(*pixelOf(zoom(pose, point, 0.8), lens, point) - from), 1e-4);
    }
}

TEST(CameraControl, TheLimitsKeepTheParallelPicture) {
    const CameraPose pose = pan(inParallel({{50, 60, 0}, 800, 30, 50}), {600, 400}, {650, 300}, lens);
    EXPECT_GT(std::abs(pose.target.z), 10) << "moved along the screen, off the ground";
    const CameraPose kept = keepAboveGround(pose, computeLimits(city), flat);
    EXPECT_NEAR(kept.target.z, 0, 1e-9);
    for (const glm::dvec3 point : {glm::dvec3(0, 0, 0), glm::dvec3(120, -40, 80)})
        EXPECT_LT(glm::length(*pixelOf(kept, lens, point) - *pixelOf(pose, lens, point)), 1e-6);
    EXPECT_EQ(keepAboveGround(inParallel({{0, 0, 40}, 500, 0, 0}), computeLimits(city), flat).target.z, 40)
        << "an elevation may look at a building's middle";
    const CameraPose raised{{0, 0, 40}, 500, 0, 0};
    EXPECT_GT(keepAboveGround(raised, computeLimits(city), flat).pitchDeg, 0) << "not a perspective";
}

TEST(CameraControl, AnotherProjectionShowsTheSameMiddle) {
    const CameraPose pose{{50, 60, 0}, 800, 30, 50};
    const CameraPose parallel = project(pose, Projection::parallel, flat);
    EXPECT_EQ(parallel.target, pose.target);
    EXPECT_EQ(parallel.projection, Projection::parallel);
    CameraPose moved = parallel;
    moved.target -= 300.0 * computeForward(parallel);  // the same picture
    const CameraPose back = project(moved, Projection::perspective, flat);
    EXPECT_LT(glm::length(back.target - pose.target), 1e-9);
}

TEST(CameraControl, NeverBelowTheGroundWhateverTheUserDoes) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> drag(-300, 300);
    const CameraLimits limits = computeLimits(city);
    for (const GroundHeight& ground : {GroundHeight(flat), GroundHeight(hill)}) {
        CameraPose pose = wholeCity(city, lens);
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec2 move{drag(random), drag(random)};
            if (i % 3 == 0) pose = orbit(pose, move, lens);
            if (i % 3 == 1) pose = pan(pose, {600, 500}, glm::dvec2(600, 500) + move, lens);
            if (i % 3 == 2) pose = zoom(pose, pose.target, std::exp(move.x / 300));
            pose = keepAboveGround(pose, limits, ground);
            const glm::dvec3 eye = computeEye(pose);
            ASSERT_GE(eye.z, ground({eye.x, eye.y}) + CameraLimits::clearanceM - 1e-9) << "step " << i;
            ASSERT_GE(pose.distanceM, limits.nearestM);
            ASSERT_LE(pose.distanceM, limits.furthestM);
        }
    }
}

TEST(CameraControl, WholeCityIsInThePicture) {
    for (const ViewLens& window : {lens, ViewLens{40, 500, 900}, ViewLens{40, 2000, 400}}) {
        const CameraPose pose = wholeCity(city, window);
        for (const float x : {city.box.low.x, city.box.high.x})
            for (const float y : {city.box.low.y, city.box.high.y}) {
                const auto pixel = pixelOf(pose, window, {x, y, 0});
                ASSERT_TRUE(pixel);
                EXPECT_GE(pixel->x, -1);
                EXPECT_LE(pixel->x, window.widthPx + 1);
                EXPECT_GE(pixel->y, -1);
                EXPECT_LE(pixel->y, window.heightPx + 1);
            }
    }
}

TEST(CameraControl, ClipRangeHoldsTheCity) {
    std::mt19937 random(5);
    for (int i = 0; i < 200; ++i) {
        const CameraPose pose = poseFrom(random);
        const ClipRange clip = computeClipRange(pose, city);
        EXPECT_GT(clip.nearM, 0);
        EXPECT_LT(clip.nearM, pose.distanceM);
        for (const float x : {city.box.low.x, city.box.high.x})
            EXPECT_LT(glm::dot(glm::dvec3(x, city.box.high.y, 0) - computeEye(pose), computeForward(pose)),
                      clip.farM);
    }
}

TEST(ViewRay, MeetsAHillWhereItStands) {
    const ViewRay ray{{-2000, 0, 300}, glm::normalize(glm::dvec3{1, 0, -0.1})};
    const auto hit = findGroundHit(ray, hill, 0, 250);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->z, hill({hit->x, hit->y}), 0.01);
    EXPECT_LT(hit->x, 0) << "the far side of the hill is hidden";
}

TEST(ViewRay, AboveTheHorizonThereIsNoGround) {
    EXPECT_FALSE(findGroundHit({{0, 0, 10}, {0, 1, 0}}, flat, 0, 0));
    EXPECT_FALSE(findGroundHit({{0, 0, 10}, glm::normalize(glm::dvec3{0, 1, 0.2})}, flat, 0, 0));
}

}  // namespace
}  // namespace noonmark
