#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/core/engines/sweep_scenes.h"

namespace noonmark {
namespace {

using namespace tests;

/// Mean differences from the rays over the receivers, percent of the period (gross) and of a day.
struct Off {
    double gross = 0, continuous = 0;
};

Off offOf(const City& city, const Receivers& receivers, const SunSteps& sun) {
    const ShadowField field = swept(city, receivers, sun), truth = traced(city, receivers, sun);
    Off off;
    for (const std::uint32_t cell : receivers.cells) {
        off.gross += double(std::abs(field.grossMin[cell] - truth.grossMin[cell]));
        off.continuous += double(std::abs(field.continuousMin[cell] - truth.continuousMin[cell]));
    }
    const double whole = double(receivers.cells.size()) * truth.sunlitMinutesPerDay / 100;
    return {off.gross / whole, off.continuous / whole};
}

void expectAgreement(const City& city, double maxGross = 0.1, double maxContinuous = 0.3) {
    const Receivers receivers = receiversOver(city, -60.3F, -40.3F, 80.7F, 110.7F);
    const Off off = offOf(city, receivers, threeDays());
    EXPECT_LE(off.gross, maxGross);
    EXPECT_LE(off.continuous, maxContinuous);
}

// A slab 10 m above the ground lets the sun in below it: the sun is hidden above atan(10 / distance to the
// far edge), up to the zenith if the receiver is under the slab.
TEST(HorizonOverhangs, ALiftedSlabHidesAnInterval) {
    const City city = cityOf({{{-2000, 0, 10}, {2000, 30, 12}}});
    const Receivers receivers = receiversOver(city, -3, -20, 3, 90);
    std::vector<Sun> suns;
    for (int i = 0; i < 170; ++i) suns.push_back({180, 3.25 + 0.5 * i});
    const ShadowField field = swept(city, receivers, oneDay(suns));
    for (const std::uint32_t cell : receivers.cells) {
        const double y = double(receivers.position(cell).y);
        const double low = y > 0 ? std::atan2(10, y) : 9, high = y > 30 ? std::atan2(12, y - 30) : 9;
        const auto hidden = std::ranges::count_if(suns, [&](const Sun& sun) {
            const double altitude = sun.altitudeDeg * std::numbers::pi / 180;
            return altitude > low && altitude < high;
        });
        EXPECT_NEAR(double(field.grossMin[cell]), double(hidden), 1.001) << y;
        EXPECT_EQ(field.continuousMin[cell], field.grossMin[cell]) << y;
    }
}

TEST(HorizonOverhangs, ASlabAgreesWithRays) { expectAgreement(cityOf({{{0, 0, 10}, {30, 25, 13}}})); }

TEST(HorizonOverhangs, ABridgeOverAStreetAgreesWithRays) {
    expectAgreement(
        cityOf({{{0, 0, 0}, {15, 40, 30}}, {{15, 12, 9}, {35, 20, 15}}, {{35, 0, 0}, {50, 40, 45}}}));
}

TEST(HorizonOverhangs, ATowerOnStiltsAgreesWithRays) {
    std::vector<Box3> boxes{{{0, 0, 12}, {25, 25, 90}}};
    for (const double x : {1.0, 21.0})
        for (const double y : {1.0, 21.0}) boxes.push_back({{x, y, 0}, {x + 3, y + 3, 12}});
    expectAgreement(cityOf(boxes), 0.15, 0.5);
}

TEST(HorizonOverhangs, AConcaveCanopyAgreesWithRays) {
    City city;
    city.buildings.push_back(
        buildingOf({{{0, 0}, {40, 0}, {40, 8}, {8, 8}, {8, 30}, {0, 30}}, {}}, 6, 8, true));
    expectAgreement(city);
}

/// A house of 12 x 18 m with a pitched roof, as a closed mesh.
City pitchedRoof() {
    const std::vector<glm::vec3> points{{0, 0, 0},  {12, 0, 0},  {12, 18, 0}, {0, 18, 0}, {0, 0, 8},
                                        {12, 0, 8}, {12, 18, 8}, {0, 18, 8},  {6, 0, 14}, {6, 18, 14}};
    const std::vector<glm::uvec3> triangles{{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {4, 5, 8}, {2, 3, 7},
                                            {2, 7, 6}, {6, 7, 9}, {1, 2, 6}, {1, 6, 5}, {3, 0, 4}, {3, 4, 7},
                                            {5, 6, 9}, {5, 9, 8}, {7, 4, 8}, {7, 8, 9}};
    Part part{.footprint = {rectangle(0, 0, 12, 18), {}}, .topM = 14};
    part.mesh = std::make_shared<const TriangleMesh>(TriangleMesh{points, triangles});
    City city;
    city.buildings.push_back(std::make_shared<const Building>(Building{.parts = {part}}));
    return city;
}

TEST(HorizonOverhangs, APitchedRoofAgreesWithRays) { expectAgreement(pitchedRoof()); }

// A block contains more strips than are processed together.
TEST(HorizonOverhangs, AFineRoundCanopyAgreesWithRays) {
    Ring round;
    for (int i = 0; i < 96; ++i) {
        const float angle = float(i) * 2 * std::numbers::pi_v<float> / 96;
        round.push_back({20 + 6 * std::cos(angle), 12 + 6 * std::sin(angle)});
    }
    City city;
    city.buildings.push_back(buildingOf({round, {}}, 9, 11, true));
    expectAgreement(city);
}

// With so many overhangs, each azimuth is swept on its own.
TEST(HorizonOverhangs, ThousandsInOnePlaceHideWhatOneDoes) {
    const City one = cityOf({{{0, 0, 0}, {8, 8, 20}}, {{10, 0, 10}, {30, 25, 13}}});
    City many = one;
    for (int i = 0; i < 4200; ++i) many.buildings.push_back(one.buildings[1]);
    const Receivers receivers = receiversOver(one, -60, -40, 60, 60);
    const SunSteps sun = oneDay({{100, 12}, {160, 35}, {200, 33}, {262, 9}});
    const ShadowField few = swept(one, receivers, sun), all = swept(many, receivers, sun);
    for (const std::uint32_t cell : receivers.cells) {
        ASSERT_EQ(few.grossMin[cell], all.grossMin[cell]) << cell;
        ASSERT_EQ(few.continuousMin[cell], all.continuousMin[cell]) << cell;
    }
}

TEST(HorizonOverhangs, AMeshOfAPrismIsThatPrism) {
    const City prism = cityOf({{{3.3, -7.1, 0}, {31, 22.7, 40}}});
    City mesh = prism;
    Building building = *prism.buildings[0];
    building.parts[0].mesh = std::make_shared<const TriangleMesh>(meshOf(building.parts[0]));
    mesh.buildings[0] = std::make_shared<const Building>(building);
    const Receivers receivers = receiversOver(prism, -60.3F, -40.3F, 80.7F, 110.7F);
    const ShadowField a = swept(prism, receivers, threeDays()), b = swept(mesh, receivers, threeDays());
    std::size_t different = 0;
    for (const std::uint32_t cell : receivers.cells) {
        different += a.grossMin[cell] != b.grossMin[cell];
        EXPECT_NEAR(a.grossMin[cell], b.grossMin[cell], 2) << cell;  // one bin's steps: on its corner
    }
    EXPECT_LE(different, receivers.cells.size() / 500);
}

}  // namespace
}  // namespace noonmark
