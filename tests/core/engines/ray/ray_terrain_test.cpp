#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/engines/ray/ray_reference.h"
#include "core/engines/ray/ray_scene.h"
#include "tests/core/engines/terrain_scenes.h"

namespace noonmark::tests {
namespace {

TEST(RayTerrain, GroundElevationIsTheSurfaceThatCastsShadow) {
    std::mt19937 random(5);
    const City city = groundOf(8, [&](glm::dvec2) { return double(random() % 1000) * 0.03; });
    const RayScene scene = RayScene::over(city).value();
    for (int i = 0; i < 2000; ++i) {
        const glm::vec2 place(float(random() % 7000) * 0.01F - 35, float(random() % 7000) * 0.01F - 35);
        const auto hit = scene.firstHit({place, 200}, {0, 0, -1});
        ASSERT_TRUE(hit);
        ASSERT_NEAR(hit->position.z, groundAt(city, glm::dvec2(place + RayScene::wallOffsetM)), 1e-4);
    }
}

TEST(RayTerrain, APlaneSlopeShadesItselfOnlyWhenItFacesAway) {
    // Ground rising to the north at 30 degrees: lit from the north only by a sun above 30 degrees.
    const double slope = std::tan(30 * std::numbers::pi / 180);
    const City city = groundOf(20, [&](glm::dvec2 place) { return place.y * slope; });
    const Receivers receivers = receiversOver(city, -60, -60, 60, 60, 2.5);
    const auto expect = [&](Sun sun, float minutes) {
        const ShadowField field = traced(city, receivers, oneDay({sun}));
        for (const std::uint32_t cell : receivers.cells)
            ASSERT_EQ(field.grossMin[cell], minutes) << sun.azimuthDeg << ' ' << sun.altitudeDeg;
    };
    expect({180, 5}, 0);   // the sun in front of the slope
    expect({0, 29.5}, 1);  // behind it
    expect({0, 30.5}, 0);  // above it
    expect({90, 1}, 0);    // along it
}

TEST(RayTerrain, SmoothGroundHasNoAcne) {
    // A bowl far from the origin at high elevation: floats are coarse there, and every receiver sees a high
    // sun.
    Terrain terrain{{12000, -9000, 10, 60, 60}, {}};
    for (int row = 0; row < 60; ++row)
        for (int column = 0; column < 60; ++column) {
            const glm::dvec2 from = terrain.grid.centre(column, row) - glm::dvec2(12300, -8700);
            terrain.elevationM.push_back(float(1600 + (from.x * from.x + from.y * from.y) * 0.0008));
        }
    City city;
    city.terrain = std::make_shared<const Terrain>(std::move(terrain));
    const Receivers receivers = receiversOver(city, 12050, -8950, 12550, -8450, 2.5);
    ASSERT_GT(receivers.cells.size(), 30000);
    const ShadowField field = traced(city, receivers, oneDay({{100, 50}, {180, 60}, {251, 50}}));
    for (const std::uint32_t cell : receivers.cells) ASSERT_EQ(field.grossMin[cell], 0);
}

TEST(RayTerrain, AHillCastsAShadowOfTheKnownLength) {
    // A long ridge 40 m high along x = 0, with the sun in the east at 20 degrees. To the west its shadow ends
    // 40 / tan 20 = 110 m away.
    const City city =
        groundOf(80, [](glm::dvec2 place) { return std::max(0.0, 40 - 2 * std::abs(place.x + 5)); });
    const Receivers receivers = receiversOver(city, -200, -20, 100, 20);
    const ShadowField field = traced(city, receivers, oneDay({{90, 20}}));
    const double reach = 40 / std::tan(20 * std::numbers::pi / 180);
    for (const std::uint32_t cell : receivers.cells) {
        const glm::vec3 p = receivers.position(cell);
        const double west = -5 - double(p.x);  // of the crest
        if (std::abs(west - reach) < 0.6 || std::abs(west) < 0.6) continue;
        ASSERT_EQ(field.grossMin[cell], west > 0 && west < reach ? 1 : 0) << p.x;
    }
}

TEST(RayTerrain, ABuildingOnAHillShadesFurtherDownhill) {
    // Ground falls to the north by 1 in 5, with a wall of 10 m at y = 0 and the sun at 45 degrees: the shadow
    // ends where 10 + 0.2 y = y.
    City city = groundOf(40, [](glm::dvec2 place) { return -0.2 * place.y; });
    city.buildings.push_back(buildingOf({rectangle(-50, -2, 50, 0), {}}, -5, 10));
    const Receivers receivers = receiversOver(city, -20, 0, 20, 40);
    const ShadowField field = traced(city, receivers, oneDay({{180, 45}}));
    for (const std::uint32_t cell : receivers.cells)
        ASSERT_EQ(field.grossMin[cell], receivers.position(cell).y < 12.5 ? 1 : 0)
            << receivers.position(cell).y;
}

}  // namespace
}  // namespace noonmark::tests
