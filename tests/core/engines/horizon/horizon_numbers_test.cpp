#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "core/engines/api/shadow_field.h"
#include "core/engines/horizon/horizon_sweep.h"
#include "core/io/read_city.h"
#include "tests/core/engines/scenes.h"
#include "tests/shared/shared_data.h"

namespace noonmark {
namespace {

using namespace tests;

ShadowField sweptShadow(const City& city, const Receivers& receivers, const SunSteps& sun,
                        double binDeg = 0.5) {
    NoProgress progress;
    return HorizonSweep({.binDeg = binDeg}).accumulate(city, receivers, sun, progress, {}).value();
}

std::vector<Box3> standOnTerrain(std::uint32_t seed, int perSide, glm::dvec3 move = glm::dvec3(0)) {
    std::vector<Box3> boxes = randomBoxes(seed, perSide);
    for (Box3& box : boxes) {
        box.low = glm::round(box.low) + move;
        box.high = glm::round(box.high) + move;
        box.low.z = 0;
    }
    return boxes;
}

/// With one sun per bin only rounding remains.
std::vector<Sun> oneSunABin(double altitudeDeg) {
    std::vector<Sun> suns;
    for (int i = 0; i < 240; ++i) suns.push_back({1.5 * i + 0.37, altitudeDeg + 0.01 * i});
    return suns;
}

// The sweep works in float within a block, the test in double. Cell-steps may differ only if moving a box by
// a millimetre, or a sun by half a level (0.001 deg), would change the result too.
TEST(HorizonNumbers, DifferFromDoubleByRoundingOnly) {
    const std::vector<Box3> boxes = standOnTerrain(7, 5);
    const City city = cityOf(boxes);
    const Receivers receivers = receiversOver(city, -30.37F, -30.21F, 130.1F, 130.7F, 1.37);
    std::size_t different = 0, unexplained = 0, all = 0;
    for (const double altitude : {2.0, 14.0, 47.0}) {
        for (const Sun& sun : oneSunABin(altitude)) {
            if (int(sun.azimuthDeg) % 5 != 0) continue;
            const ShadowField field = sweptShadow(city, receivers, oneDay({sun}));
            const glm::dvec3 direction(towardsSun(sun.azimuthDeg, sun.altitudeDeg));
            const glm::dvec3 up(towardsSun(sun.azimuthDeg, sun.altitudeDeg + 0.001)),
                down(towardsSun(sun.azimuthDeg, sun.altitudeDeg - 0.001));
            for (const std::uint32_t cell : receivers.cells) {
                const glm::dvec3 origin(receivers.position(cell));
                const bool hidden = field.grossMin[cell] > 0;
                ++all;
                if (hidden == inShadow(boxes, origin, direction)) continue;
                ++different;
                unexplained += inShadow(boxes, origin, up, -1e-3) || !inShadow(boxes, origin, down, 1e-3);
            }
        }
    }
    EXPECT_EQ(unexplained, 0U);
    EXPECT_LE(double(different), 2e-5 * double(all));  // the stated maximum difference
}

TEST(HorizonNumbers, SlopesOfATenThousandthAndOfTenThousand) {
    for (const double height : {0.01, 1.0, 80.0, 5000.0}) {
        const City city = cityOf({{{-20'000, -5, 0}, {20'000, 0, height}}});
        const Receivers receivers = receiversOver(city, 0, 0, 1, 100, 0.5);
        for (const std::uint32_t cell : receivers.cells) {
            const double north = double(receivers.position(cell).y) + double(RayScene::wallOffsetM);
            const double altitude = std::atan2(height, north) * 180 / std::numbers::pi;
            if (altitude > 89.99 || altitude < 0.004) continue;
            if (cell % 7 != 0) continue;
            const ShadowField field =
                sweptShadow(city, receivers, oneDay({{180, altitude - 0.002}, {180, altitude + 0.002}}));
            EXPECT_EQ(field.grossMin[cell], 1) << height << ' ' << north;
        }
    }
}

TEST(HorizonNumbers, TenKilometresFromTheOriginAreLikeThere) {
    const SunSteps sun = oneDay(oneSunABin(20));
    const City here = cityOf(standOnTerrain(8, 5)),
               there = cityOf(standOnTerrain(8, 5, {10'000, -10'000, 0}));
    const ShadowField a = sweptShadow(here, receiversOver(here, -20, -20, 120, 120), sun),
                      b = sweptShadow(there, receiversOver(there, 9980, -10'020, 10'120, -9880), sun);
    ASSERT_EQ(a.grossMin.size(), b.grossMin.size());
    std::size_t different = 0;
    for (std::size_t cell = 0; cell < a.grossMin.size(); ++cell) {
        ASSERT_EQ(std::isnan(a.grossMin[cell]), std::isnan(b.grossMin[cell]));
        different += !std::isnan(a.grossMin[cell]) && a.grossMin[cell] != b.grossMin[cell];
    }
    EXPECT_LE(different, a.grossMin.size() / 1000);
}

// Suns along the walls. Cells on edges and corners are in shadow or not by the half-open rule. No cell more
// than a millimetre outside the box's shadow is dark, and no cell inside the shadow of a box a millimetre
// smaller is lit.
TEST(HorizonNumbers, EdgesAlongTheAzimuthAndReceiversOnThem) {
    std::vector<Box3> boxes = standOnTerrain(9, 4);
    for (Box3& box : boxes) {  // puts cell centres on walls and corners
        box.low += glm::dvec3(0.5, 0.5, 0);
        box.high += glm::dvec3(0.5, 0.5, 0);
    }
    const City city = cityOf(boxes);
    const Receivers receivers = receiversOver(city, -20, -20, 110, 110);
    for (const double azimuth : {0.0, 90.0, 180.0, 270.0, 45.0}) {
        const ShadowField field = sweptShadow(city, receivers, oneDay({{azimuth, 30}}));
        const glm::dvec3 direction(towardsSun(azimuth, 30));
        for (const std::uint32_t cell : receivers.cells) {
            const glm::dvec3 origin(receivers.position(cell));
            if (field.grossMin[cell] > 0) {
                EXPECT_TRUE(inShadow(boxes, origin, direction, 2e-3)) << azimuth << ' ' << cell;
            } else {
                EXPECT_FALSE(inShadow(boxes, origin, direction, -2e-3)) << azimuth << ' ' << cell;
            }
        }
    }
}

class Collect final : public Progress, public PartialSink {
public:
    void report(double, std::string_view) override {}
    [[nodiscard]] bool wants() const override { return true; }
    void take(PartialField partial) override { taken.push_back(std::move(partial)); }
    std::vector<PartialField> taken;
};

TEST(HorizonNumbers, RunningResultsGrowToTheWhole) {
    const City city = cityOf(standOnTerrain(3, 4));
    const Receivers receivers = receiversOver(city, -20, -20, 110, 110, 2);
    SunSteps sun = oneDay(arc(400, 30));
    addDay(sun, arc(400, 50));
    Collect collect;
    const ShadowField whole =
        HorizonSweep({.binDeg = 0.5}).accumulate(city, receivers, sun, collect, {}).value();
    ASSERT_GT(collect.taken.size(), 5U);
    const ShadowField alone = sweptShadow(city, receivers, sun);
    double share = 0;
    for (const PartialField& partial : collect.taken) {
        EXPECT_GT(partial.share, share);
        share = partial.share;
        EXPECT_NEAR(partial.field.sunlitMinutesPerDay, share * whole.sunlitMinutesPerDay, 1e-6);
        for (const std::uint32_t cell : receivers.cells)
            ASSERT_LE(partial.field.grossMin[cell], whole.grossMin[cell]);
    }
    for (const std::uint32_t cell : receivers.cells) EXPECT_EQ(whole.grossMin[cell], alone.grossMin[cell]);
}

// 1,184 parts of Midtown have a min_height; those of them with open air below that reach the region are
// overhangs.
TEST(HorizonNumbers, MidtownAgreesWithRays) {
    const auto file = sharedData("midtown_manhattan/midtown_manhattan.osm.pbf");
    if (!file) GTEST_SKIP() << "the shared Midtown extract is missing";
    NoProgress progress;
    const City city = readCity({*file}, {}, progress, {}).value().city;
    const Box2 box = bounds(city);
    const glm::vec2 middle = (box.low + box.high) * 0.5F;
    const Receivers receivers =
        receiversOver(city, middle.x - 200, middle.y - 200, middle.x + 200, middle.y + 200, 4);
    SunSteps sun;
    sun.stepMinutes = 5;
    for (int day = 0; day < 6; ++day) addDay(sun, arc(96, 26 + 9 * day));
    const ShadowField truth = traced(city, receivers, sun);
    const ShadowField field =
        HorizonSweep({.binDeg = 0.5}).accumulate(city, receivers, sun, progress, {}).value();
    double off = 0;
    for (const std::uint32_t cell : receivers.cells)
        off += double(std::abs(field.grossMin[cell] - truth.grossMin[cell]));
    EXPECT_LE(100 * off / double(receivers.cells.size()) / truth.sunlitMinutesPerDay, 0.2);
}

}  // namespace
}  // namespace noonmark
