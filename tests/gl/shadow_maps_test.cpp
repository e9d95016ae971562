#include <gtest/gtest.h>

#include <bit>
#include <glm/geometric.hpp>
#include <numeric>
#include <stop_token>
#include <thread>

#include "core/lab/accrual/shadow_accrual_map.h"
#include "core/lab/graph/graph_engine.h"
#include "render/lab/depth_maps.h"
#include "render/lab/gl_shadow_maps.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

/// Fixture for tests that need OpenGL 4.3; they are skipped with a message where it is missing.
class OpenGl : public testing::Test {
protected:
    void SetUp() override {
        auto context = GlContext::make();
        if (!context) GTEST_SKIP() << context.error().text();
        context_ = *context;
    }
    std::shared_ptr<const GlContext> context_;
};

const SunInterval interval{glm::normalize(glm::dvec3(towardsSun(120, 25))),
                           glm::normalize(glm::dvec3(towardsSun(138, 34))), 60};

std::vector<ShadowMask> masksOf(const IntervalEngine& engine, const City& city, const Receivers& receivers,
                                const SunInterval& sun = interval) {
    SunSteps steps;
    for (int k = 0; k < sun.steps; ++k) steps.steps.push_back({.direction = glm::vec3(sun.at(k))});
    const auto scene = engine.prepare(city, receivers, steps, {}).value();
    std::vector<ShadowMask> masks(receivers.cells.size());
    EXPECT_TRUE(scene->shade(sun, masks, {}));
    return masks;
}

std::shared_ptr<const IntervalEngine> onDevice(GlPasses passes, const AccrualSettings& settings) {
    return GlShadowMaps::make(passes, settings).value();
}

double differentPercent(const std::vector<ShadowMask>& a, const std::vector<ShadowMask>& b) {
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.size(); ++i) different += std::size_t(std::popcount(a[i] ^ b[i]));
    return 100.0 * double(different) / (60.0 * double(a.size()));
}

using ShadowMapsGl = OpenGl;

// Paper, section 4, theorem 1.
TEST_F(ShadowMapsGl, OneDrawEqualsSixtyPassesBitForBit) {
    const City city = cityOf(randomBoxes(21, 10));
    const Receivers receivers = receiversOver(city, -10, -10, 210, 210);
    for (const CasterSide side : {CasterSide::towardsSun, CasterSide::awayFromSun})
        for (const bool texelsOnCells : {true, false}) {
            const AccrualSettings settings{.mapSize = 512, .side = side, .texelsOnCells = texelsOnCells};
            const auto separate = masksOf(*onDevice(GlPasses::oneAStep, settings), city, receivers);
            EXPECT_EQ(separate, masksOf(*onDevice(GlPasses::oneAnInterval, settings), city, receivers));
            EXPECT_GT(std::ranges::count_if(separate, [](ShadowMask mask) { return mask != 0; }), 1000);
        }
}

/// A scene on the device with the depths of all its steps.
struct DeviceScene {
    City city = cityOf(randomBoxes(22, 8));
    MapFrame frame = makeGroundFrame({-10, -10, 1, 180, 180}, 256, false);
    CasterFaces faces = [this] {
        std::vector<std::uint32_t> all(city.buildings.size());
        std::iota(all.begin(), all.end(), 0U);
        return makeCasterFaces(city, all);
    }();
    IntervalCasters casters =
        placeCasters(faces, frame.placed(faces.points), frame, interval, CasterSide::awayFromSun, {});

    [[nodiscard]] std::vector<std::vector<float>> depths(const GlLimits& limits, int layers) const {
        const auto maps = DepthMaps::make(limits, frame.columns, frame.rows, layers).value();
        maps->take(frame, placeSurface({{{0, 0, 0}}, {{0, 0, 1}}, {}}, frame), {});
        maps->take(casters, interval);
        std::vector<std::vector<float>> all;
        for (int step = 0; step < interval.steps; step += layers) {
            maps->draw(step, layers);
            for (int layer = 0; layer < layers; ++layer) all.push_back(maps->depths(layer));
        }
        return all;
    }
};

TEST_F(ShadowMapsGl, DepthsOfOneDrawAreThoseOfSixtyPasses) {
    const GlContext::Current current(*context_);
    const DeviceScene scene;
    const auto separate = scene.depths(context_->limits(), 1);
    EXPECT_EQ(separate, scene.depths(context_->limits(), 60));
    EXPECT_EQ(separate, scene.depths(context_->limits(), 12));
    EXPECT_NE(separate.front(), separate.back());
}

TEST_F(ShadowMapsGl, AGeometryShaderGivesTheSameWhereVertexShadersChooseNoLayer) {
    const GlContext::Current current(*context_);
    const DeviceScene scene;
    GlLimits old = context_->limits();
    old.layerInVertex = false;
    EXPECT_EQ(scene.depths(context_->limits(), 60), scene.depths(old, 60));
}

// The two rasterisers round vertices differently: to 1/256 of a texel, or in double precision.
TEST_F(ShadowMapsGl, AgreesWithTheProcessorsRasteriser) {
    const City city = cityOf(randomBoxes(23, 10));
    const Receivers receivers = receiversOver(city, -10, -10, 210, 210);
    for (const bool texelsOnCells : {true, false}) {
        const AccrualSettings settings{.texelsOnCells = texelsOnCells};
        const auto device = masksOf(*onDevice(GlPasses::oneAnInterval, settings), city, receivers);
        const auto processor = masksOf(*ShadowAccrualMap::make(settings).value(), city, receivers);
        EXPECT_LT(differentPercent(device, processor), 0.1);
    }
}

TEST_F(ShadowMapsGl, AgreesWithTheRays) {
    const City city = cityOf(randomBoxes(24, 10));
    const Receivers receivers = receiversOver(city, -10, -10, 210, 210);
    SunSteps sun;
    sun.days.push_back({.first = 0, .count = 60});
    for (int k = 0; k < 60; ++k) sun.steps.push_back({.direction = glm::vec3(interval.at(k)), .slot = k});
    const ShadowField truth = traced(city, receivers, sun);
    for (const GlPasses passes : {GlPasses::oneAStep, GlPasses::oneAnInterval}) {
        NoProgress progress;
        const auto field = GraphEngine(onDevice(passes, {}), {.merge = false})
                               .accumulate(city, receivers, sun, progress, {})
                               .value();
        double sum = 0;
        for (const std::uint32_t cell : receivers.cells)
            sum += std::abs(double(field.grossMin[cell]) - double(truth.grossMin[cell]));
        EXPECT_LT(100 * sum / (60.0 * double(receivers.cells.size())), 0.05);
    }
}

TEST_F(ShadowMapsGl, RefusesMapsLargerThanTheDeviceAllowsWithTheRange) {
    const int maximum = std::min(context_->limits().mapSize, AccrualSettings::maxMapSize);
    const auto refused = GlShadowMaps::make(GlPasses::oneAStep, {.mapSize = maximum + 1});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().advice.find(std::to_string(maximum)), std::string::npos);
    EXPECT_FALSE(GlShadowMaps::make(GlPasses::oneAStep, {.mapSize = 0}));
    const City city = cityOf({{{0, 0, 0}, {1, 1, 1}}});
    const Receivers receivers = receiversOver(city, -2, -2, 2, 2);
    const auto scene =
        onDevice(GlPasses::oneAStep, {})->prepare(city, receivers, oneDay({{90, 20}}), {}).value();
    std::vector<ShadowMask> masks(receivers.cells.size());
    EXPECT_FALSE(scene->shade({interval.first, interval.last, 65}, masks, {}));
}

TEST_F(ShadowMapsGl, ScenesWorkOnAnyThreadAndSideBySide) {
    const City city = cityOf(randomBoxes(25, 6));
    const Receivers receivers = receiversOver(city, -10, -10, 130, 130);
    const auto expected = masksOf(*onDevice(GlPasses::oneAnInterval, {}), city, receivers);
    std::vector<ShadowMask> first, second;
    std::thread one([&] { first = masksOf(*onDevice(GlPasses::oneAnInterval, {}), city, receivers); });
    std::thread two([&] { second = masksOf(*onDevice(GlPasses::oneAStep, {}), city, receivers); });
    one.join();
    two.join();
    EXPECT_EQ(first, expected);
    EXPECT_EQ(second, expected);
}

TEST_F(ShadowMapsGl, Stops) {
    const City city = cityOf(randomBoxes(26, 4));
    const Receivers receivers = receiversOver(city, -10, -10, 90, 90);
    std::stop_source stop;
    for (const GlPasses passes : {GlPasses::oneAStep, GlPasses::oneAnInterval}) {
        const auto scene = onDevice(passes, {})->prepare(city, receivers, oneDay({{120, 30}}), {}).value();
        std::vector<ShadowMask> masks(receivers.cells.size());
        stop.request_stop();
        EXPECT_TRUE(isCancelled(scene->shade(interval, masks, stop.get_token()).error()));
    }
}

TEST_F(ShadowMapsGl, EnginesAreChosenByTheirKeys) {
    for (const char* key : {"shadow-map-gl", "sam-gl"})
        EXPECT_TRUE(makeEngine(key, {{"map", 256}}, glEngines())) << key;
    EXPECT_FALSE(makeEngine("sam-gl", {{"map", 1e6}}, glEngines()));
}

}  // namespace
}  // namespace noonmark
