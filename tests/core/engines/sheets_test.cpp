// Surfaces without thickness cast shadow in every engine; the expected results are computed here.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "core/city/meshes/mesh_parts.h"
#include "core/engines/api/engine_registry.h"
#include "core/engines/horizon/cache/horizon_cache.h"
#include "core/engines/projected/shadow_cache.h"
#include "core/lab/lab_engines.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

using IsShaded = std::function<bool(glm::dvec2 place, glm::dvec3 towardsSun)>;

City cityOfMesh(const TriangleMesh& mesh) {
    MeshParts made = partsOf(mesh, "sheet", "sheet");
    EXPECT_TRUE(made.warnings.empty());
    markOverhangs(made.parts, [](glm::dvec2) { return 0.0F; });
    City city;
    city.buildings.push_back(std::make_shared<const Building>(Building{"sheet", {}, {}, made.parts}));
    return city;
}

// An L of 20 x 12 m without its north-east quarter, 5 m above the ground; two of its triangles face down.
constexpr float canopyM = 5;
TriangleMesh canopy() {
    return {{{0, 0, canopyM},
             {20, 0, canopyM},
             {20, 6, canopyM},
             {10, 6, canopyM},
             {10, 12, canopyM},
             {0, 12, canopyM}},
            {{0, 1, 2}, {0, 3, 2}, {0, 3, 4}, {0, 5, 4}}};
}

bool isUnderCanopy(glm::dvec2 place, glm::dvec3 sun) {
    const glm::dvec2 at = place + glm::dvec2(sun) * (double(canopyM) / sun.z);
    return at.x > 0 && at.y > 0 && ((at.x < 20 && at.y < 6) || (at.x < 10 && at.y < 12));
}

// A wall from (0, 0) to (16, 12), 20 m long, between two heights.
TriangleMesh wall(float lowM, float highM) {
    return {{{0, 0, lowM}, {16, 12, lowM}, {16, 12, highM}, {0, 0, highM}}, {{0, 1, 2}, {0, 2, 3}}};
}

IsShaded behindWall(double lowM, double highM) {
    return [=](glm::dvec2 place, glm::dvec3 sun) {
        const glm::dvec2 along(0.8, 0.6), across(-0.6, 0.8);
        const double speed = glm::dot(glm::dvec2(sun), across);
        const double time = -glm::dot(place, across) / speed;
        if (!(time > 0)) return false;
        const double at = glm::dot(place + time * glm::dvec2(sun), along), height = time * sun.z;
        return at > 0 && at < 20 && height > lowM && height < highM;
    };
}

SunSteps day() { return oneDay(arc(540, 41)); }

struct Off {
    double mean = 0, largest = 0;  // minutes per cell
};

Off offOf(const ShadowField& field, const Receivers& receivers, const IsShaded& isShaded) {
    const SunSteps sun = day();
    Off off;
    for (const std::uint32_t cell : receivers.cells) {
        const glm::dvec2 place(glm::vec2(receivers.position(cell)));
        const Minutes truth = minutesOf(sun, [&](glm::dvec3 towards) { return isShaded(place, towards); });
        const double difference = std::abs(double(field.grossMin[cell]) - truth.gross);
        off.mean += difference / double(receivers.cells.size());
        off.largest = std::max(off.largest, difference);
    }
    return off;
}

struct Allowed {
    const char* engine;
    double mean, largest;
};

void expectShadow(const TriangleMesh& mesh, const IsShaded& isShaded) {
    const City city = cityOfMesh(mesh);
    const Receivers receivers = receiversOver(city, -50, -30, 50, 50);
    ASSERT_GE(receivers.cells.size(), 7970U);
    NoProgress progress;
    // iam ignores occluders closer than 1 m, so cells beside a wall are off.
    for (const Allowed& allowed : std::initializer_list<Allowed>{{"ray", 0.05, 4},
                                                                 {"projected", 0.05, 4},
                                                                 {"horizon", 0.4, 20},
                                                                 {"ray-graph", 0.2, 15},
                                                                 {"iam", 1.5, 540},
                                                                 {"sam", 0.5, 40},
                                                                 {"auto", 0.4, 20}}) {
        const auto engine = makeEngine(allowed.engine, {}, coreAndLabEngines()).value();
        const Off off =
            offOf(engine->accumulate(city, receivers, day(), progress, {}).value(), receivers, isShaded);
        EXPECT_LE(off.mean, allowed.mean) << allowed.engine;
        EXPECT_LE(off.largest, allowed.largest) << allowed.engine;
    }
    ShadowCache shadows = std::move(ShadowCache::make(city, receivers, day(), progress, {}).value());
    EXPECT_LE(offOf(shadows.field(), receivers, isShaded).mean, 0.05);
    HorizonCache horizons =
        std::move(HorizonCache::make(city, receivers, {1, std::uint64_t{1} << 30U}).value());
    EXPECT_LE(offOf(horizons.computePeriod(day(), progress, {}).value(), receivers, isShaded).mean, 0.6);
}

TEST(Sheets, ACanopyShadesWhatItsOutlineCovers) { expectShadow(canopy(), isUnderCanopy); }

TEST(Sheets, AWallOnTheGroundShades) { expectShadow(wall(0, 9), behindWall(0, 9)); }

TEST(Sheets, ABillboardInTheAirShades) { expectShadow(wall(6, 12), behindWall(6, 12)); }

// Float spacing at 400 m is 0.03 mm, so a canopy at that height keeps its thickness.
TEST(Sheets, ACanopyOfAHighCityIsAsThickAsOneAtTheSea) {
    TriangleMesh high = canopy();
    for (glm::vec3& vertex : high.vertices) vertex.z += 400;
    const MeshParts made = partsOf(high, "", "");
    ASSERT_EQ(made.parts.size(), 1U);
    EXPECT_EQ(made.parts[0].topM, 405);
    EXPECT_NEAR(made.parts[0].bottomM, 404.99, 1e-4);
    EXPECT_NEAR(area(made.parts[0].footprint), 180, 1e-6);
}

}  // namespace
}  // namespace noonmark
