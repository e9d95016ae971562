#include <gtest/gtest.h>

#include "core/engines/ray/surface_rays.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {

namespace {

using namespace tests;

TEST(RayPlaces, AreTheReceiversOfTheReferenceToTheLastBit) {
    const City city = cityOf(randomBoxes(5, 6));
    const Receivers receivers = receiversOver(city, -30, -30, 150, 150, 3);
    SunSteps sun = oneDay(arc(70, 45), 2);
    addDay(sun, arc(33, 20));
    const ShadowField field = traced(city, receivers, sun);
    std::vector<glm::vec3> places;
    for (const std::uint32_t cell : receivers.cells) places.push_back(receivers.position(cell));
    NoProgress progress;
    const auto minutes = traceMinutesAt(RayScene::over(city).value(), places, sun, progress, {});
    ASSERT_TRUE(minutes);
    for (std::size_t i = 0; i < places.size(); ++i) {
        ASSERT_EQ(float((*minutes)[i].gross), field.grossMin[receivers.cells[i]]);
        ASSERT_EQ(float((*minutes)[i].continuous), field.continuousMin[receivers.cells[i]]);
    }
}

TEST(RayPlaces, StopWhenAsked) {
    const City city = cityOf(randomBoxes(5, 2));
    std::stop_source stop;
    stop.request_stop();
    NoProgress progress;
    const std::vector<glm::vec3> places{{1, 2, 0}};
    const auto minutes =
        traceMinutesAt(RayScene::over(city).value(), places, oneDay(arc(9, 45)), progress, stop.get_token());
    ASSERT_FALSE(minutes);
    EXPECT_TRUE(isCancelled(minutes.error()));
}

SurfaceShadow tracedOn(const City& city, const SurfacePoints& points, const SunSteps& sun) {
    NoProgress progress;
    return SurfaceRays().accumulate(city, points, sun, progress, {}).value();
}

TEST(SurfaceRays, FacadesAreDarkWhileTheSunIsBehindThem) {
    const City city = cityOf({{{0, 0, 0}, {10, 10, 20}}});
    // East facade, west facade, roof.
    const SurfacePoints points{{{10, 5, 8}, {0, 5, 8}, {5, 5, 20}}, {{1, 0, 0}, {-1, 0, 0}, {0, 0, 1}}, {}};
    const SurfaceShadow shadow = tracedOn(city, points, oneDay({{80, 20}, {100, 30}, {120, 40}, {240, 40}}));
    EXPECT_EQ(shadow.grossMin, (std::vector<float>{1, 3, 0}));
    EXPECT_EQ(shadow.continuousMin, (std::vector<float>{1, 3, 0}));
    EXPECT_EQ(shadow.sunlitMinutesPerDay, 4);
}

TEST(SurfaceRays, ATowerShadesTheRoofBesideIt) {
    const City city = cityOf({{{0, 0, 0}, {10, 10, 20}}, {{20, 0, 0}, {30, 10, 40}}});
    const SurfacePoints points{{{5, 5, 20}, {5, 5, 20}}, {{0, 0, 1}, {0, 0, 1}}, {}};
    // 15 m away and 20 m higher: dark below 53 degrees.
    const SurfaceShadow shadow = tracedOn(city, points, oneDay({{90, 50}, {90, 52}, {90, 54}, {90, 56}}));
    EXPECT_EQ(shadow.grossMin, (std::vector<float>{2, 2}));
}

TEST(SurfaceRays, OnTheGroundTheyAgreeWithTheRayReference) {
    const City city = cityOf(randomBoxes(8, 6));
    const Receivers receivers = receiversOver(city, -20, -20, 140, 140);
    const SunSteps sun = oneDay(arc(60, 50));
    const ShadowField truth = traced(city, receivers, sun);
    SurfacePoints points;
    for (const std::uint32_t cell : receivers.cells) points.positions.push_back(receivers.position(cell));
    points.normals.assign(points.size(), {0, 0, 1});
    const SurfaceShadow shadow = tracedOn(city, points, sun);
    double difference = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        difference += std::abs(double(shadow.grossMin[i]) - double(truth.grossMin[receivers.cells[i]]));
    EXPECT_LT(difference / (60.0 * double(points.size())), 2e-4);  // rays start a centimetre higher
}

TEST(SurfaceRays, RefusesPlacesWithoutNormals) {
    NoProgress progress;
    const SurfacePoints points{{{0, 0, 0}}, {}, {}};
    EXPECT_FALSE(SurfaceRays().accumulate({}, points, oneDay({{90, 20}}), progress, {}));
}

}  // namespace

}  // namespace noonmark
