#include "core/engines/ray/ray_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <random>

#include "core/engines/common/shadow_reach.h"
#include "tests/core/engines/scenes.h"

namespace noonmark::tests {
namespace {

/// The result of brute force for a ray.
struct Slow {
    bool blocked = false;
    double edgeM = 1e30;  ///< how far from the nearest triangle's edge the ray crosses its plane, metres; a
                          ///< measure of certainty
};

double distanceToEdge(glm::dvec3 point, glm::dvec3 a, glm::dvec3 b) {
    return glm::length(glm::cross(point - a, b - a)) / std::max(glm::length(b - a), 1e-12);
}

// The intersection test of Moeller and Trumbore in double.
void meet(Slow& slow, glm::dvec3 origin, glm::dvec3 direction, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
    const glm::dvec3 p = glm::cross(direction, c - a);
    const double determinant = glm::dot(b - a, p);
    if (std::abs(determinant) < 1e-12) return;
    const double u = glm::dot(origin - a, p) / determinant;
    const glm::dvec3 q = glm::cross(origin - a, b - a);
    const double v = glm::dot(direction, q) / determinant;
    const double t = glm::dot(c - a, q) / determinant;
    if (t <= double(RayScene::nearestM)) return;
    slow.blocked = slow.blocked || std::min({u, v, 1 - u - v}) >= 0;
    const glm::dvec3 point = origin + t * direction;
    slow.edgeM = std::min(
        {slow.edgeM, distanceToEdge(point, a, b), distanceToEdge(point, b, c), distanceToEdge(point, c, a)});
}

/// Tests every triangle.
Slow slowly(const TriangleMesh& mesh, glm::vec3 place, glm::vec3 direction) {
    Slow slow;
    const glm::vec3 origin = place + glm::vec3(RayScene::wallOffsetM, RayScene::wallOffsetM, 0);
    for (const glm::uvec3 t : mesh.triangles)
        meet(slow, glm::dvec3(origin), glm::dvec3(direction), glm::dvec3(mesh.vertices[t.x]),
             glm::dvec3(mesh.vertices[t.y]), glm::dvec3(mesh.vertices[t.z]));
    return slow;
}

std::uint32_t blockedFrom(const RayScene& scene, glm::vec3 origin, const DirectionPacket& directions) {
    std::uint32_t blocked = 0;
    scene.blockedLanes({&origin, 1}, directions, {&blocked, 1});
    return blocked;
}

/// Receivers at whole and half metres (many in line with walls), and suns, some exactly along the axes.
struct RandomRays {
    explicit RandomRays(std::uint32_t seed) : random(seed) {}
    glm::vec3 origin() {
        return {float(random() % 200) * 0.5F - 10, float(random() % 200) * 0.5F - 10, 0.001F};
    }
    DirectionPacket packet() {
        DirectionPacket packet;
        packet.count = 16;
        const double start = double(random() % 360), altitude = 2 + double(random() % 80);
        for (std::size_t lane = 0; lane < 16; ++lane) {
            const glm::vec3 d = towardsSun(start + 0.25 * double(lane), altitude);
            packet.x[lane] = d.x, packet.y[lane] = d.y, packet.z[lane] = d.z;
        }
        return packet;
    }
    std::mt19937 random;
};

// The stated failure rate: of a million rays none may be wrong unless it passes within a tenth of a
// millimetre of an edge, and the wrong ones at edges may be at most one in a thousand of all rays.
TEST(RayScene, AgreesWithBruteForceOnRandomCities) {
    std::size_t rays = 0, wrongAtEdge = 0;
    for (std::uint32_t seed = 0; seed < 8; ++seed) {
        const City city = cityOf(randomBoxes(seed, 4));
        const TriangleMesh mesh = meshOf(city).mesh;
        const RayScene scene = RayScene::over(city).value();
        RandomRays random(seed);
        for (int i = 0; i < 600; ++i) {
            const glm::vec3 origin = random.origin();
            const DirectionPacket packet = random.packet();
            const std::uint32_t blocked = blockedFrom(scene, origin, packet);
            for (std::size_t lane = 0; lane < 16; ++lane, ++rays) {
                const Slow slow = slowly(mesh, origin, {packet.x[lane], packet.y[lane], packet.z[lane]});
                if (((blocked >> lane & 1U) != 0) == slow.blocked) continue;
                ++wrongAtEdge;
                ASSERT_LT(slow.edgeM, 1e-4) << origin.x << ' ' << origin.y << ", seed " << seed;
            }
        }
    }
    EXPECT_LE(wrongAtEdge * 1000, rays) << wrongAtEdge << " of " << rays;
}

TEST(RayScene, OneRayAndPacketsAgreeAwayFromEdges) {
    const City city = cityOf(randomBoxes(21, 5));
    const TriangleMesh mesh = meshOf(city).mesh;
    const RayScene scene = RayScene::over(city).value();
    RandomRays random(21);
    std::size_t different = 0;
    for (int i = 0; i < 2000; ++i) {
        const glm::vec3 origin = random.origin();
        DirectionPacket packet = random.packet();
        packet.count = 1 + i % 16;
        const std::uint32_t blocked = blockedFrom(scene, origin, packet);
        ASSERT_EQ(blocked >> unsigned(packet.count), 0U) << "lanes beyond the count stay clear";
        for (std::size_t lane = 0; lane < std::size_t(packet.count); ++lane) {
            const glm::vec3 direction{packet.x[lane], packet.y[lane], packet.z[lane]};
            if (((blocked >> lane & 1U) != 0) == scene.occluded(origin, direction)) continue;
            ++different;
            ASSERT_LT(slowly(mesh, origin, direction).edgeM, 1e-4);
        }
    }
    EXPECT_LT(different, 32);
}

TEST(RayScene, FirstHitNamesTheBuilding) {
    const City city =
        cityOf({{{0, 0, 0}, {10, 10, 10}}, {{20, 0, 0}, {30, 10, 30}}, {{40, 0, 0}, {50, 10, 10}}});
    const RayScene scene = RayScene::over(city).value();
    const auto hit = scene.firstHit({5, 5, 20}, {2, 0, 0});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->building, 1U);
    EXPECT_NEAR(hit->position.x, 20, 1e-4);
    EXPECT_NEAR(hit->distanceM, 15, 1e-4);
    EXPECT_NEAR(hit->normal.x, -1, 1e-6);
    EXPECT_FALSE(scene.firstHit({5, 5, 40}, {1, 0, 0}));
    EXPECT_FALSE(scene.firstHit({5, -5, 5}, {0, 0, -1})) << "flat ground is not in the scene";
}

TEST(RayScene, SomeBuildingsKeepTheCitysNumbers) {
    const City city =
        cityOf({{{0, 0, 0}, {10, 10, 10}}, {{20, 0, 0}, {30, 10, 30}}, {{40, 0, 0}, {50, 10, 10}}});
    const std::vector<std::uint32_t> some{0, 2};
    const RayScene scene = RayScene::over(city, some).value();
    EXPECT_EQ(scene.triangleCount(), 24);
    EXPECT_EQ(scene.firstHit({15, 5, 5}, {1, 0, 0})->building, 2U)
        << "straight through where the second would be";
}

TEST(RayScene, TerrainIsHitAndIsNoBuilding) {
    City city = cityOf({{{0, 0, 0}, {10, 10, 10}}});
    city.terrain = std::make_shared<const Terrain>(Terrain{{-100, -100, 100, 2, 2}, {0, 0, 0, 0}});
    const RayScene scene = RayScene::over(city).value();
    const auto hit = scene.firstHit({-20, -20, 30}, {0, 0, -1});
    ASSERT_TRUE(hit);
    EXPECT_FALSE(hit->building);
    EXPECT_NEAR(hit->position.z, 0, 1e-5);
}

TEST(RayScene, OfNothing) {
    const RayScene scene = RayScene::over(City{}).value();
    EXPECT_FALSE(scene.occluded({0, 0, 0}, {0, 0, 1}));
    EXPECT_EQ(scene.triangleCount(), 0);
}

// --- Buildings out of reach

Crown crownAt(double x, double y, CrownShape shape) {
    return {.x = x, .y = y, .bottomM = 3, .topM = 12, .radiusM = 4, .shape = shape};
}

// Sixteen level rays to the east, one metre apart, at the given height.
HitPacket levelRays(float x, float z) {
    HitPacket packet;
    for (std::size_t lane = 0; lane < HitPacket::lanes; ++lane) {
        packet.originX[lane] = x, packet.originY[lane] = float(lane) - 8.0F, packet.originZ[lane] = z;
        packet.directionX[lane] = 1, packet.directionY[lane] = 0, packet.directionZ[lane] = 0;
        packet.from[lane] = 0, packet.distance[lane] = 1000;
    }
    return packet;
}

TEST(CrownScene, RaysMeetCrownsWhereTheyEnter) {
    for (const double far : {0.0, 60'000.0}) {
        const std::vector<GroupedCrown> crowns{{crownAt(far + 20, 0, CrownShape::ellipsoid), 0},
                                               {crownAt(far + 40, 2, CrownShape::cone), 1},
                                               {crownAt(far + 60, -2, CrownShape::cylinder), 2}};
        const RayScene scene = RayScene::over(crowns).value();
        HitPacket packet = levelRays(float(far), 6.5F);
        scene.firstHits(packet);
        std::size_t met = 0;
        for (std::size_t lane = 0; lane < HitPacket::lanes; ++lane) {
            double nearest = 1000;
            std::uint32_t expected = HitPacket::nothing;
            for (const GroupedCrown& some : crowns) {
                const LinePart part = findLinePart(some.crown, {far, packet.originY[lane], 6.5}, {1, 0, 0});
                if (!(part.leave > part.enter) || part.enter >= nearest) continue;
                nearest = part.enter;
                expected = some.group;
            }
            EXPECT_EQ(packet.hit[lane], expected) << lane;
            EXPECT_NEAR(packet.distance[lane], nearest, 0.001) << lane;
            if (expected == HitPacket::nothing) continue;
            ++met;
            EXPECT_LT(packet.normalX[lane], 0) << "against the ray";
        }
        EXPECT_GE(met, 10U);
    }
}

TEST(CrownScene, MeetsOnlyTheGroupsThatAreAskedFor) {
    const RayScene scene =
        RayScene::over(std::vector<GroupedCrown>{{crownAt(20, 0, CrownShape::ellipsoid), 0},
                                                 {crownAt(40, 0, CrownShape::ellipsoid), 1}})
            .value();
    constexpr std::size_t middle = 8;
    const auto hitOf = [&](std::vector<std::uint8_t> groups) {
        HitPacket packet = levelRays(0, 7.5F);
        scene.firstHits(packet, groups);
        return packet.hit[middle];
    };
    EXPECT_EQ(hitOf({}), 0U);
    EXPECT_EQ(hitOf({1, 1}), 0U);
    EXPECT_EQ(hitOf({0, 1}), 1U);
    EXPECT_EQ(hitOf({0, 0}), HitPacket::nothing);
    const std::vector<std::uint8_t> second{0, 1};
    HitPacket fromBetween = levelRays(30, 7.5F);
    EXPECT_NE(scene.findBlocked(fromBetween) >> middle & 1U, 0U);
    EXPECT_NE(scene.findBlocked(fromBetween, second) >> middle & 1U, 0U);
    const HitPacket fromInside = levelRays(20, 7.5F), fromBehind = levelRays(25, 7.5F);
    const std::vector<std::uint8_t> first{1, 0};
    EXPECT_NE(scene.findBlocked(fromInside, first) >> middle & 1U, 0U) << "the rest of the crown";
    EXPECT_EQ(scene.findBlocked(fromBehind, first), 0U);
}

TEST(Reach, BuildingsBeyondItChangeNothing) {
    // The engine's result without distant buildings, compared with the same rays against all buildings. At
    // whole metres receivers are in line with walls, and some suns are exactly on an axis: the result must
    // not depend on how the bounding volume hierarchy is split.
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        std::mt19937 random(seed);
        std::vector<Box3> boxes = randomBoxes(seed, 10);
        if (seed % 2 == 0)
            for (Box3& box : boxes) box = {glm::round(box.low), glm::round(box.high)};
        const City city = cityOf(boxes);
        const float west = float(random() % 180), south = float(random() % 180);
        const Receivers receivers = receiversOver(city, west, south, west + 24, south + 24, 2);
        SunSteps sun = oneDay(arc(3 + int(random() % 40), 10 + double(random() % 70), seed % 4 > 1));
        sun.steps[0].direction = {0, -0.8F, 0.6F};
        sun.steps[1].direction = {0.8F, 0, 0.6F};
        const ShadowField field = traced(city, receivers, sun);
        const RayScene all = RayScene::over(city).value();
        for (const std::uint32_t cell : receivers.cells) {
            float blocked = 0;
            for (const SunPacket& packet : packSteps(sun))
                blocked += float(std::popcount(
                    blockedFrom(all, placeRayOrigin(receivers.position(cell)), packet.directions)));
            ASSERT_EQ(field.grossMin[cell], blocked) << "seed " << seed;
        }
    }
}

TEST(Reach, LeavesOutWhatIsTooFarOrOnTheWrongSide) {
    const Receivers receivers = receiversOver({}, 0, 0, 10, 10);
    const SunSteps sun = oneDay({{170, 45}, {190, 45}});  // shadows run north, as long as the heights
    const auto reaching = [&](const Box3& box) {
        return !findBuildingsInReach(cityOf({box}), receivers, sun).empty();
    };
    EXPECT_TRUE(reaching({{0, -30, 0}, {10, -25, 30}}));
    EXPECT_FALSE(reaching({{0, -40, 0}, {10, -35, 30}})) << "too far";
    EXPECT_FALSE(reaching({{0, 15, 0}, {10, 20, 30}})) << "north of the receivers";
    EXPECT_FALSE(reaching({{40, -20, 0}, {50, -15, 30}})) << "beside";
    EXPECT_FALSE(reaching({{0, -30, -20}, {10, -25, -1}})) << "below the ground";
}

TEST(Reach, ALowSunReachesFar) {
    const Receivers receivers = receiversOver({}, 0, 0, 10, 10);
    const City city = cityOf({{{-3000, 0, 0}, {-2990, 10, 30}}});
    EXPECT_TRUE(findBuildingsInReach(city, receivers, oneDay({{270, 0.5}})).size() == 1);
    EXPECT_TRUE(findBuildingsInReach(city, receivers, oneDay({{270, 1}})).empty());
    EXPECT_TRUE(findBuildingsInReach(city, receivers, oneDay({})).empty());
}

}  // namespace
}  // namespace noonmark::tests
