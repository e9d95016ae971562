#include "core/engines/ray/surface_rays.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace noonmark
