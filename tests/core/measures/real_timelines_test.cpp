#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "core/engines/projected/projected_shadows.h"
#include "core/engines/ray/ray_reference.h"
#include "core/io/places/read_places.h"
#include "core/io/read_city.h"
#include "core/measures/places/place_run.h"
#include "core/measures/places/place_timeline.h"
#include "core/receivers/place_names.h"
#include "tests/core/engines/scenes.h"
#include "tests/shared/shared_data.h"

// Timelines by projected shadows against those by rays, on a real park among real buildings.
namespace noonmark {
namespace {

using namespace tests;

struct Park {
    City before, after;
    std::vector<Place> places;
};

// Bryant Park, and a tower of 300 m south of it.
std::optional<Park> readPark() {
    const auto file = sharedData("midtown_manhattan/midtown_manhattan.osm.pbf");
    if (!file) return std::nullopt;
    NoProgress quiet;
    Park park{readCity({*file}, {}, quiet, {}).value().city, {}, {}};
    auto read = readPlaces(*file, {.unnamed = false}, park.before.frame, quiet, {}).value();
    park.places.push_back(findPlace(read.places, "Bryant Park").value());
    const Box2 box = bounds(park.places.at(0));
    park.after = park.before;
    const Ring tower = rectangle(box.low.x + 60, box.low.y - 60, box.low.x + 100, box.low.y - 20);
    park.after.buildings.push_back(buildingOf({tower, {}}, 0, 300));
    return park;
}

struct MeasuredDay {
    PlaceShadow shadow;
    DayTimeline timeline;
};

MeasuredDay measure(const Engine& engine, const Park& park, const PlaceReceivers& cells,
                    const SunSteps& sun) {
    MeasuredDay measured;
    const auto take = [&](std::size_t, std::span<const PlaceShadow> shadows) -> Result<void> {
        measured.shadow = shadows[0];
        measured.timeline = computeTimeline(shadows[0], {.steps = true, .longestStays = true});
        return {};
    };
    NoProgress quiet;
    EXPECT_TRUE(shadePlaces(engine, park.before, &park.after, cells, sun, take, quiet, {}));
    return measured;
}

std::size_t countDifferent(const StepMasks& a, const StepMasks& b) {
    std::size_t bits = 0;
    for (std::size_t i = 0; i < a.words.size(); ++i)
        bits += std::size_t(std::popcount(a.words[i] ^ b.words[i]));
    return bits;
}

TEST(RealTimelines, OfAParkInMidtownAreThoseOfRays) {
    const auto park = readPark();
    if (!park) GTEST_SKIP() << "the shared Midtown extract is missing";
    const City* const cities[]{&park->before, &park->after};
    const PlaceReceivers cells = placeReceiversOnPlaces(cities, park->places, {.cellM = 2}).value();
    const Period period{.stepMinutes = 2, .zone = "America/New_York"};  // 21 March, 9 to 15 h
    const SunSteps sun = computeSunSteps(period, observerOfPlaces(park->before)).value();
    const MeasuredDay projected = measure(ProjectedShadows(), *park, cells, sun),
                      rays = measure(RayReference(), *park, cells, sun);
    const std::size_t answers = cells.receivers.cells.size() * sun.steps.size();
    ASSERT_GT(answers, 500'000U);
    // Cells whose centre a shadow's edge meets: one in a hundred thousand.
    EXPECT_LE(countDifferent(projected.shadow.baseline, rays.shadow.baseline), answers / 100'000);
    EXPECT_LE(countDifferent(projected.shadow.scenario, rays.shadow.scenario), answers / 100'000);
    EXPECT_EQ(projected.timeline.incremental.enters(), rays.timeline.incremental.enters());
    EXPECT_EQ(projected.timeline.incremental.exits(), rays.timeline.incremental.exits());
    ASSERT_TRUE(rays.timeline.incremental.longest);
    EXPECT_NEAR(projected.timeline.incremental.longest->minutes, rays.timeline.incremental.longest->minutes,
                2);
    EXPECT_GT(rays.timeline.incremental.largestM2, 1000);
    for (std::size_t i = 0; i < rays.timeline.steps.size(); ++i)
        EXPECT_NEAR(projected.timeline.steps[i].incrementalM2, rays.timeline.steps[i].incrementalM2, 8) << i;
}

}  // namespace
}  // namespace noonmark
