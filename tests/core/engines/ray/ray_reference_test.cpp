#include "core/engines/ray/ray_reference.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>

#include "tests/core/engines/scenes.h"

namespace noonmark::tests {
namespace {

const Box3 tower{{0, 0, 0}, {10, 20, 30}};

// --- One box, known answers

TEST(RayReference, ShadowOfABoxHasTheKnownLengthAndWidth) {
    // The sun due south at 45 degrees: a 30 m box casts a shadow 30 m to the north, as wide as itself.
    const City city = cityOf({tower});
    const Receivers receivers = receiversOver(city, -20, -20, 30, 70);
    const ShadowField field = traced(city, receivers, oneDay({{180, 45}}));
    for (const std::uint32_t cell : receivers.cells) {
        const glm::vec3 p = receivers.position(cell);
        const bool shaded = p.x > 0 && p.x < 10 && p.y > 20 && p.y < 50;
        ASSERT_EQ(field.grossMin[cell], shaded ? 1 : 0) << p.x << ' ' << p.y;
    }
}

TEST(RayReference, CellsThatAreNoReceiversHoldNaN) {
    const City city = cityOf({tower});
    const Receivers receivers = receiversOver(city, -20, -20, 30, 70);
    const ShadowField field = traced(city, receivers, oneDay({{180, 45}}));
    EXPECT_TRUE(std::isnan(field.grossMin[cellAt(field.grid, 5, 5)]));
    EXPECT_TRUE(std::isnan(field.continuousMin[cellAt(field.grid, 5, 5)]));
    EXPECT_EQ(field.cost.rays, receivers.cells.size());
    EXPECT_EQ(field.cost.skipped.at("cells under buildings"), 200);
}

// --- Far from the origin

// At 60 km, coordinates are multiples of 4 mm, and so are the boxes' here. A slab test in double decides,
// except within a millimetre of a box.
TEST(RayReference, IsAsExactFarFromTheOriginAsNear) {
    constexpr glm::dvec3 far(60'000, -45'000, 0);
    std::vector<Box3> boxes = randomBoxes(21, 8);
    for (Box3& box : boxes) {
        box.low = glm::round((box.low + far) * 256.0) / 256.0;
        box.high = glm::round((box.high + far) * 256.0) / 256.0;
    }
    const City city = cityOf(boxes);
    const Receivers receivers = receiversOver(city, 59'980.5F, -45'020.5F, 60'180.5F, -44'820.5F, 1);
    SunSteps sun = oneDay(arc(240, 50));
    std::size_t decided = 0, wrong = 0;
    for (std::size_t step = 0; step < sun.steps.size(); step += 8) {
        const glm::dvec3 towards(sun.steps[step].direction);
        SunSteps one = sun;
        one.steps = {sun.steps[step]};
        one.days = {{.first = 0, .count = 1}};
        const ShadowField field = traced(city, receivers, one);
        for (const std::uint32_t cell : receivers.cells) {
            const glm::dvec3 origin(placeRayOrigin(receivers.position(cell)));
            const bool surely = inShadow(boxes, origin, towards, -0.001),
                       perhaps = inShadow(boxes, origin, towards, 0.001);
            if (surely != perhaps) continue;
            ++decided;
            wrong += (field.grossMin[cell] > 0) != surely;
        }
    }
    EXPECT_GT(decided, 400'000U);
    EXPECT_EQ(wrong, 0U);
}

// --- Gross and continuous

TEST(RayReference, AGapBetweenTwoBoxesShowsInContinuousOnly) {
    // One wall 20 m wide, and the same 20 m with a slit in the middle through which the receiver sees the sun
    // for one step.
    const SunSteps sun = oneDay({{170, 30}, {174, 30}, {180, 30}, {186, 30}, {190, 30}});
    const City whole = cityOf({{{-10, -12, 0}, {10, -10, 40}}});
    const City slit = cityOf({{{-10, -12, 0}, {-0.5, -10, 40}}, {{0.5, -12, 0}, {10, -10, 40}}});
    Receivers centre = receiversOver(whole, 0, 0, 1, 1);
    centre.grid.westM = centre.grid.southM = -0.5;
    const ShadowField one = traced(whole, centre, sun);
    const ShadowField two = traced(slit, centre, sun);
    EXPECT_EQ(one.grossMin[0], 5);
    EXPECT_EQ(one.continuousMin[0], 5);
    EXPECT_EQ(two.grossMin[0], 4);
    EXPECT_EQ(two.continuousMin[0], 2);
}

/// One receiver at the origin, north of a wall that hides every sun in the south below 60 degrees.
struct BehindAWall {
    City city = cityOf({{{-200, -12, 0}, {200, -10, 40}}});
    Receivers receivers = receiversOver(city, 0, 0, 1, 1);
    static constexpr Sun hidden{180, 30};
    static constexpr Sun seen{180, 85};
    [[nodiscard]] Minutes of(const SunSteps& sun) const {
        const ShadowField field = traced(city, receivers, sun);
        return {field.grossMin[0], field.continuousMin[0]};
    }
};

TEST(RayReference, GrossIsTheMeanOfDaysAndContinuousTheLongestRunOfAny) {
    const BehindAWall scene;
    SunSteps sun;
    sun.stepMinutes = 2;
    addDay(sun, {scene.hidden, scene.hidden, scene.seen, scene.hidden});
    addDay(sun, {});  // polar night
    addDay(sun, {scene.hidden, scene.hidden, scene.hidden, scene.seen, scene.hidden, scene.hidden});
    const Minutes minutes = scene.of(sun);
    EXPECT_FLOAT_EQ(float(minutes.gross), 2 * (3 + 0 + 5) / 3.0F);
    EXPECT_EQ(minutes.continuous, 6);
}

TEST(RayReference, ARunEndsWithItsDay) {
    const BehindAWall scene;
    SunSteps sun;
    for (int day = 0; day < 7; ++day) addDay(sun, std::vector<Sun>(5, scene.hidden));
    const Minutes minutes = scene.of(sun);
    EXPECT_EQ(minutes.gross, 5);
    EXPECT_EQ(minutes.continuous, 5);
}

TEST(RayReference, MissingSlotsBreakARun) {
    const BehindAWall scene;
    SunSteps sun = oneDay(std::vector<Sun>(40, scene.hidden));
    for (std::size_t i = 18; i < sun.steps.size(); ++i) sun.steps[i].slot += 7;
    const Minutes minutes = scene.of(sun);
    EXPECT_EQ(minutes.gross, 40);
    EXPECT_EQ(minutes.continuous, 22);
}

TEST(RayReference, RunsOfAnyLengthCrossPackets) {
    const BehindAWall scene;
    std::mt19937 random(7);
    for (int trial = 0; trial < 200; ++trial) {
        SunSteps sun;
        for (int day = 0; day < 3; ++day) {
            std::vector<Sun> suns(random() % 70);
            for (Sun& each : suns) each = random() % 8 != 0 ? scene.hidden : scene.seen;
            addDay(sun, suns);
        }
        for (std::size_t i = 0; i < sun.steps.size(); ++i) sun.steps[i].slot += int(i / 37);
        const Minutes expected = minutesOf(sun, [](glm::dvec3 direction) { return direction.z < 0.8; });
        const Minutes minutes = scene.of(sun);
        ASSERT_FLOAT_EQ(float(minutes.gross), float(expected.gross)) << trial;
        ASSERT_EQ(minutes.continuous, expected.continuous) << trial;
    }
}

// --- Shapes

TEST(RayReference, CourtyardSeesTheSunThroughItsHole) {
    // Walls of 10 m around a courtyard of 20 m: its northern part is lit at 45 degrees, its southern 10 m are
    // not.
    Footprint block{rectangle(0, 0, 40, 40), {{{10, 10}, {10, 30}, {30, 30}, {30, 10}}}};
    City city;
    city.buildings.push_back(buildingOf(block, 0, 10));
    const Receivers receivers = receiversOver(city, 10, 10, 30, 30);
    ASSERT_EQ(receivers.cells.size(), 400);
    const ShadowField field = traced(city, receivers, oneDay({{180, 45}}));
    for (const std::uint32_t cell : receivers.cells)
        ASSERT_EQ(field.grossMin[cell], receivers.position(cell).y < 20 ? 1 : 0);
}

TEST(RayReference, LightPassesUnderALiftedSlab) {
    const Box3 slab{{0, 0, 10}, {10, 10, 12}};
    const City city = cityOf({slab});
    const Receivers receivers = receiversOver(city, -30, -30, 40, 40);
    ASSERT_EQ(receivers.cells.size(), 4900) << "the ground under it is a receiver";
    const ShadowField noon = traced(city, receivers, oneDay({{180, 89.9}}));
    const ShadowField low = traced(city, receivers, oneDay({{180, 30}}));
    EXPECT_EQ(noon.grossMin[cellAt(noon.grid, 5.5, 5.5)], 1);
    EXPECT_EQ(low.grossMin[cellAt(low.grid, 5.5, 5.5)], 0);
    // At 30 degrees the shadow lies 10 / tan 30 = 17.3 m to 12 / tan 30 + 10 = 30.8 m north of its southern
    // edge.
    EXPECT_EQ(low.grossMin[cellAt(low.grid, 5.5, 16.5)], 0);
    EXPECT_EQ(low.grossMin[cellAt(low.grid, 5.5, 17.6)], 1);
    EXPECT_EQ(low.grossMin[cellAt(low.grid, 5.5, 30.5)], 1);
    EXPECT_EQ(low.grossMin[cellAt(low.grid, 5.5, 31.5)], 0);
}

TEST(RayReference, PartyWallsLetNoLightThrough) {
    // Two boxes share the wall x = 0; suns sweep along it and across it, with receivers on its line and
    // beside it.
    const std::vector<Box3> boxes{{{-10, 0, 0}, {0, 10, 30}}, {{0, 0, 0}, {10, 10, 30}}};
    const City city = cityOf(boxes);
    std::vector<Sun> suns;
    for (int i = -400; i <= 400; ++i) suns.push_back({180 + i * 0.01, 20});
    for (int i = 0; i < 100; ++i) suns.push_back({180, 1 + i * 0.3});
    const SunSteps sun = oneDay(suns);
    Receivers receivers = receiversOver(city, -8, 12, 8, 40);
    for (const double shift : {0.0, 0.5, 1e-6, -1e-6, 0.125}) {
        receivers.grid.westM = -8 + shift;
        const ShadowField field = traced(city, receivers, sun);
        for (const std::uint32_t cell : receivers.cells) {
            const glm::dvec3 origin(placeRayOrigin(receivers.position(cell)));
            const Minutes sure = minutesOf(sun, [&](glm::dvec3 d) {
                return inShadow(boxes, origin, d, -1e-4) ||
                       inShadow({{{-10, 0, 0}, {10, 10, 30}}}, origin, d, -1e-4);
            });
            ASSERT_GE(field.grossMin[cell], float(sure.gross)) << origin.x << ' ' << origin.y;
        }
    }
}

TEST(RayReference, EdgesOfACityThatIsShadowedWhollyLeakNothing) {
    // Wall-to-wall boxes of equal height and a low sun: every receiver to the north is dark at any azimuth.
    std::vector<Box3> boxes;
    for (int i = -40; i < 40; ++i)
        for (int j = 0; j < 3; ++j)
            boxes.push_back({{i * 3.1, j * 2.7, 0}, {i * 3.1 + 3.1, j * 2.7 + 2.7, 20}});
    for (Box3& box : boxes) box = {glm::dvec3(glm::vec3(box.low)), glm::dvec3(glm::vec3(box.high))};
    const City city = cityOf(boxes);
    std::vector<Sun> suns;
    for (int i = 0; i < 2000; ++i) suns.push_back({150 + i * 0.03, 10});
    const Receivers receivers = receiversOver(city, -10, 9, 10, 29, 0.5);
    const ShadowField field = traced(city, receivers, oneDay(suns));
    for (const std::uint32_t cell : receivers.cells) ASSERT_EQ(field.grossMin[cell], 2000);
}

// --- On a wall's line

/// Steps in shadow at one point beside the tower.
float shadowAt(double x, double y, const SunSteps& sun) {
    Receivers receivers = receiversOver({}, 0, 0, 1, 1);
    receivers.grid.westM = x - 0.5;
    receivers.grid.southM = y - 0.5;
    return traced(cityOf({tower}), receivers, sun).grossMin[0];
}
float shadowAt(double x, double y, Sun sun) { return shadowAt(x, y, oneDay({sun})); }

/// `count` suns due south, whose x is exactly 0 (or -0).
SunSteps exactlySouth(double altitudeDeg, std::size_t count, float zero) {
    SunSteps sun = oneDay(std::vector<Sun>(count, {180, altitudeDeg}));
    for (SunStep& step : sun.steps) step.direction.x = zero;
    return sun;
}

TEST(RayReference, AReceiverOnAWallIsLitInFrontAndDarkBehind) {
    EXPECT_EQ(shadowAt(10, 10, {90, 30}), 0) << "on the eastern wall, the sun in the east";
    EXPECT_EQ(shadowAt(10, 10, {270, 30}), 1) << "the same, the sun behind the building";
    EXPECT_EQ(shadowAt(0, 10, {270, 30}), 0);
    EXPECT_EQ(shadowAt(0, 10, {90, 30}), 1);
    EXPECT_EQ(shadowAt(5, 20, {0, 30}), 0);
    EXPECT_EQ(shadowAt(5, 20, {180, 30}), 1);
}

TEST(RayReference, InLineWithAWallItCountsAsEastAndNorthOfIt) {
    for (const float zero : {0.0F, -0.0F})
        for (const std::size_t count : {1, 2, 15, 16, 17, 40}) {
            EXPECT_EQ(shadowAt(10, 40, exactlySouth(30, count, zero)), 0) << "in line with the eastern wall";
            EXPECT_EQ(shadowAt(0, 40, exactlySouth(30, count, zero)), count) << "with the western wall";
            EXPECT_EQ(shadowAt(0, 40, exactlySouth(70, count, zero)), 0) << "the same, above the roof";
        }
    EXPECT_EQ(shadowAt(30, 20, {270, 30}), 0) << "with the northern wall";
    EXPECT_EQ(shadowAt(30, 0, {270, 30}), 1) << "with the southern wall";
}

TEST(RayReference, AReceiverOnACorner) {
    EXPECT_EQ(shadowAt(10, 20, {45, 30}), 0) << "the sun before both walls";
    EXPECT_EQ(shadowAt(10, 20, {225, 30}), 1) << "behind the building";
}

// --- Nothing to do

TEST(RayReference, PolarNightIsAFieldOfZeros) {
    const City city = cityOf({tower});
    const Receivers receivers = receiversOver(city, -5, -5, 15, 25);
    SunSteps sun = oneDay({});
    addDay(sun, {});
    const ShadowField field = traced(city, receivers, sun);
    EXPECT_EQ(field.days, 2);
    EXPECT_EQ(field.sunlitMinutesPerDay, 0);
    for (const std::uint32_t cell : receivers.cells)
        ASSERT_EQ(field.grossMin[cell] + field.continuousMin[cell], 0);
    EXPECT_TRUE(std::isnan(field.grossMin[cellAt(field.grid, 5, 5)]));
}

TEST(RayReference, NoReceiversNoBuildingsNoDays) {
    const City city = cityOf({tower});
    const Receivers covered = receiversOver(city, 2, 2, 8, 8);
    ASSERT_TRUE(covered.cells.empty());
    EXPECT_TRUE(std::isnan(traced(city, covered, oneDay({{180, 45}})).grossMin[0]));
    const Receivers open = receiversOver({}, 0, 0, 4, 4);
    EXPECT_EQ(traced({}, open, oneDay({{180, 45}})).grossMin[3], 0);
    EXPECT_EQ(traced({}, open, {}).grossMin[3], 0);
}

// --- Cost and cancellation

TEST(RayReference, CostAndWordsAreThere) {
    const City city = cityOf({tower, {{5000, 0, 0}, {5010, 10, 30}}});
    const Receivers receivers = receiversOver(city, -20, -20, 30, 50);
    const SunSteps sun = oneDay(arc(100, 60));
    const ShadowField field = traced(city, receivers, sun);
    EXPECT_EQ(field.engine, "Ray reference, Embree 3.13.5, robust, packets of 16");
    EXPECT_EQ(field.cost.rays, receivers.cells.size() * 100);
    EXPECT_EQ(
        field.cost.buildingsUsed + field.cost.skipped.at("buildings whose shadow cannot reach a receiver"),
        2);
    EXPECT_EQ(field.sunlitMinutesPerDay, 100);
    EXPECT_GT(field.cost.seconds.at("build"), 0);
    EXPECT_GT(field.cost.seconds.at("trace"), 0);
    EXPECT_EQ(field.cost.seconds.size(), 2);
}

TEST(RayReference, TheNumberOfThreadsChangesNothing) {
    const City city = cityOf(randomBoxes(3, 12));
    const Receivers receivers = receiversOver(city, 50, 50, 190, 190);
    const SunSteps sun = oneDay(arc(333, 50));
    const ShadowField one = traced(city, receivers, sun, 1);
    for (const int threads : {0, 2, 5}) {
        const ShadowField many = traced(city, receivers, sun, threads);
        for (const std::uint32_t cell : receivers.cells) {
            ASSERT_EQ(one.grossMin[cell], many.grossMin[cell]);
            ASSERT_EQ(one.continuousMin[cell], many.continuousMin[cell]);
        }
    }
}

/// Requests a stop as soon as tracing has begun.
class StopsWhenTracing final : public Progress {
public:
    void report(double fraction, std::string_view stage) override {
        EXPECT_GE(fraction, 0);
        EXPECT_LE(fraction, 1);
        ++reports;
        if (stage == "tracing rays") source.request_stop();
    }
    std::stop_source source;
    std::atomic<int> reports{0};
};

TEST(RayReference, StopsWhenAsked) {
    const City city = cityOf(randomBoxes(3, 12));
    const Receivers receivers = receiversOver(city, 0, 0, 240, 240);
    StopsWhenTracing progress;
    const auto result = RayReference().accumulate(city, receivers, oneDay(arc(5000, 50)), progress,
                                                  progress.source.get_token());
    ASSERT_FALSE(result);
    EXPECT_TRUE(isCancelled(result.error()));
    EXPECT_LT(progress.reports, 20) << "most of the work was left undone";
}

TEST(RayReference, StopsBeforeItBegins) {
    const City city = cityOf({tower});
    std::stop_source source;
    source.request_stop();
    NoProgress progress;
    const auto result = RayReference().accumulate(city, receiversOver(city, -9, -9, 0, 0), oneDay(arc(9, 50)),
                                                  progress, source.get_token());
    ASSERT_FALSE(result);
    EXPECT_TRUE(isCancelled(result.error()));
}

TEST(RayReference, ProgressRunsFromNothingToAll) {
    class Recorder final : public Progress {
    public:
        void report(double fraction, std::string_view) override {
            const std::scoped_lock lock(mutex_);
            fractions.push_back(fraction);
        }
        std::vector<double> fractions;

    private:
        std::mutex mutex_;
    } progress;
    const City city = cityOf(randomBoxes(4, 6));
    ASSERT_TRUE(RayReference().accumulate(city, receiversOver(city, 0, 0, 120, 120), oneDay(arc(50, 50)),
                                          progress, {}));
    EXPECT_EQ(progress.fractions.front(), 0);
    EXPECT_EQ(progress.fractions.back(), 1);
    EXPECT_GE(progress.fractions.size(), 50);
}

}  // namespace
}  // namespace noonmark::tests
