#include "core/engines/horizon/cache/horizon_cache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <mutex>
#include <random>
#include <set>

#include "core/receivers/roof_receivers.h"
#include "tests/core/engines/scenes.h"
#include "tests/core/engines/terrain_scenes.h"

namespace noonmark {
namespace {

using namespace tests;

constexpr double binDeg = 1;

HorizonCache cachedOf(const City& city, const Receivers& receivers,
                      std::uint64_t memoryBytes = std::uint64_t{1} << 30U) {
    return std::move(HorizonCache::make(city, receivers, {binDeg, memoryBytes}).value());
}

ShadowField retimed(HorizonCache& kept, const SunSteps& sun) {
    NoProgress progress;
    return kept.retime(sun, progress, {}).value();
}

ShadowField changed(HorizonCache& kept, const City& city, const Receivers& receivers) {
    NoProgress progress;
    return kept.change(city, receivers, progress, {}).value();
}

ShadowField fresh(const City& city, const Receivers& receivers, const SunSteps& sun) {
    HorizonCache kept = cachedOf(city, receivers);
    return retimed(kept, sun);
}

bool sameBits(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

bool sameField(const ShadowField& a, const ShadowField& b) {
    return sameBits(a.grossMin, b.grossMin) && sameBits(a.continuousMin, b.continuousMin);
}

City blocks(std::uint32_t seed, int perSide) {
    std::vector<Box3> boxes = randomBoxes(seed, perSide);
    for (Box3& box : boxes) box.low.z = 0;
    return cityOf(boxes);
}

Receivers smallRegion(const City& city, double cellM = 3) {
    return receiversOver(city, -10, -10, 110, 110, cellM);
}

SunSteps someDays(double noonDeg, int days) {
    SunSteps sun;
    for (int day = 0; day < days; ++day) addDay(sun, arc(90 + 7 * day, noonDeg + 6 * day, day % 3 == 2));
    return sun;
}

TEST(HorizonCache, AgreeWithTheSweepAndWithRays) {
    const City city = blocks(1, 5);
    const Receivers receivers = smallRegion(city, 2);
    const SunSteps sun = someDays(40, 4);
    NoProgress progress;
    const ShadowField kept = fresh(city, receivers, sun), truth = traced(city, receivers, sun),
                      swept = HorizonSweep({.binDeg = binDeg})
                                  .accumulate(city, receivers, sun, progress, {})
                                  .value();
    double ofSweep = 0, ofRays = 0;
    for (const std::uint32_t cell : receivers.cells) {
        ofSweep += double(std::abs(kept.grossMin[cell] - swept.grossMin[cell]));
        ofRays += double(std::abs(kept.grossMin[cell] - truth.grossMin[cell]));
    }
    const double whole = double(receivers.cells.size()) * truth.sunlitMinutesPerDay;
    EXPECT_LE(ofSweep / whole, 0.004);
    EXPECT_LE(ofRays / whole, 0.006);
}

TEST(HorizonCache, OtherDatesHoursAndStepsAreAsIfFresh) {
    const City city = blocks(2, 5);
    const Receivers receivers = smallRegion(city);
    HorizonCache kept = cachedOf(city, receivers);
    const std::vector<SunSteps> periods{someDays(50, 2), someDays(20, 5), oneDay({{100, 12}, {200, 60}}),
                                        oneDay(arc(400, 35, true)), someDays(50, 2)};
    for (const SunSteps& sun : periods)
        EXPECT_TRUE(sameField(retimed(kept, sun), fresh(city, receivers, sun)));
}

TEST(HorizonCache, CachedBinsAreNotSweptAgain) {
    const City city = blocks(2, 3);
    HorizonCache kept = cachedOf(city, smallRegion(city));
    const char* reason = "azimuth bins in the cache (bins x tiles)";
    EXPECT_EQ(retimed(kept, someDays(30, 3)).cost.skipped.at(reason), 0U);
    EXPECT_GT(retimed(kept, someDays(40, 2)).cost.skipped.at(reason), 100U);
    EXPECT_EQ(retimed(kept, oneDay({{181.2, 60}})).cost.skipped.at(reason), 1U);
    EXPECT_EQ(retimed(kept, oneDay({{181.2, 1}})).cost.skipped.at(reason), 0U);
}

TEST(HorizonCache, TheSweepOfOneTileSaysHowFarItIs) {
    class Heard final : public Progress {
    public:
        void report(double fraction, std::string_view) override {
            const std::scoped_lock lock(mutex_);
            fractions.insert(fraction);
        }
        std::set<double> fractions;

    private:
        std::mutex mutex_;
    } heard;
    const City city = blocks(2, 3);
    HorizonCache kept = cachedOf(city, smallRegion(city));
    ASSERT_TRUE(kept.retime(someDays(30, 3), heard, {}, ShadowCounts::gross));
    EXPECT_GT(heard.fractions.size(), 50U);
    EXPECT_GT(*heard.fractions.begin(), 0);
    EXPECT_EQ(*heard.fractions.rbegin(), 1);
}

/// Creates random buildings in or around the region.
class AnyBuilding {
public:
    AnyBuilding(std::mt19937& random, City ground, bool overhanging)
        : random_(random), ground_(std::move(ground)), overhanging_(overhanging) {}

    /// Some are rotated, some not convex, some share walls with others. With overhangs also slabs, towers on
    /// stilts, bridges between two houses of the same building, and general meshes.
    std::shared_ptr<const Building> operator()() {
        const float x = between(-40, 120), y = between(-40, 120);
        const glm::vec2 corner(random_() % 3 == 0 ? std::floor(x) : x, y);
        footM_ = groundAt(ground_, glm::dvec2(corner)) - (ground_.terrain ? 8.0F : 0.0F);
        const std::uint32_t kind = std::uint32_t(random_() % (overhanging_ ? 6 : 2));
        if (kind == 0) return built({part(box(corner, between(3, 25), between(3, 25)), 0, between(2, 80))});
        if (kind == 1) return built({part(turned(corner), 0, between(2, 80))});
        if (kind == 2)
            return built({slab(turned(corner)), slab(box(corner, between(3, 60), between(3, 25)))});
        if (kind == 3) return built({slab(box(corner, between(5, 40), between(5, 40)), 60)});
        return kind == 4 ? bridge(corner) : mesh(corner);
    }

private:
    float between(double low, double high) {
        return float(std::uniform_real_distribution<double>(low, high)(random_));
    }
    static Footprint box(glm::vec2 corner, float a, float b) {
        return {rectangle(corner.x, corner.y, corner.x + a, corner.y + b), {}};
    }
    Footprint turned(glm::vec2 at) {
        const float a = between(3, 25), b = between(3, 25), turn = between(0, 1.5F), c = std::cos(turn),
                    s = std::sin(turn);
        const auto corner = [&](float u, float v) { return at + glm::vec2(c * u - s * v, s * u + c * v); };
        return {{corner(0, 0), corner(a, 0), corner(a, b), corner(a / 2, b / 3), corner(0, b)}, {}};
    }
    Part part(Footprint footprint, float bottomM, float topM, bool isOverhanging = false) const {
        return {.footprint = std::move(footprint),
                .bottomM = footM_ + bottomM,
                .topM = footM_ + topM,
                .isOverhanging = isOverhanging};
    }
    Part slab(Footprint footprint, float mostM = 12) {
        const float bottom = 8 + between(2, 40);
        return part(std::move(footprint), bottom, bottom + between(0.5, mostM), true);
    }
    std::shared_ptr<const Building> bridge(glm::vec2 corner) {
        const float high = between(20, 60);
        return built({part(box(corner, 8, 20), 0, high), part(box(corner + glm::vec2(30, 0), 8, 20), 0, high),
                      part(box(corner + glm::vec2(8, 7), 22, 5), high / 2, high / 2 + 4, true)});
    }
    std::shared_ptr<const Building> mesh(glm::vec2 corner) {
        Part solid = random_() % 2 == 0 ? part(turned(corner), 0, between(2, 60)) : slab(turned(corner));
        solid.mesh = std::make_shared<const TriangleMesh>(meshOf(solid));
        return built({std::move(solid)});
    }
    static std::shared_ptr<const Building> built(std::vector<Part> parts) {
        return std::make_shared<const Building>(Building{.parts = std::move(parts)});
    }

    std::mt19937& random_;
    City ground_;
    bool overhanging_;
    float footM_ = 0;
};

void editAnything(City& city, std::mt19937& random, bool overhanging = false) {
    constexpr std::size_t mostBuildings = 40;
    AnyBuilding anyBuilding(random, {.terrain = city.terrain}, overhanging);
    const std::uint32_t kind = std::uint32_t(random() % 4);
    if (kind == 0 || city.buildings.size() < 5) {
        city.buildings.push_back(anyBuilding());
    } else if ((kind == 1 && city.buildings.size() > 12) || city.buildings.size() > mostBuildings) {
        city.buildings.erase(city.buildings.begin() + std::ptrdiff_t(random() % city.buildings.size()));
    } else if (kind == 2) {
        city.buildings[random() % city.buildings.size()] = anyBuilding();
    } else {
        std::swap(city.buildings.front(), city.buildings[random() % city.buildings.size()]);
        city.buildings.push_back(city.buildings[random() % city.buildings.size()]);  // the same one twice
    }
}

/// Edits a city at random and compares the field with a new one from time to time.
template <class ReceiversOf>
void expectFreshFields(City city, int edits, bool overhanging, const ReceiversOf& receiversOf) {
    std::mt19937 random(11);
    HorizonCache kept = cachedOf(city, receiversOf(city));
    const std::vector<SunSteps> periods{someDays(25, 2), someDays(50, 2)};
    retimed(kept, periods[0]);
    for (int edit = 0; edit < edits; ++edit) {
        for (std::uint32_t i = 0; i <= random() % 3; ++i) editAnything(city, random, overhanging);
        const Receivers receivers = receiversOf(city);
        const std::size_t period = std::size_t(edit) / 40 % 2;
        ShadowField field = changed(kept, city, receivers);
        if (edit % 40 == 0) field = retimed(kept, periods[period]);
        if (edit % 10 == 0) {
            ASSERT_TRUE(sameField(field, fresh(city, receivers, periods[period]))) << edit;
        }
    }
}

Receivers coarseRegion(const City& city) { return smallRegion(city, 5); }

Receivers coarseRegion(const City& city, ReceiverPlaces places) {
    return placeAtHeights(coarseRegion(city), city, places);
}

TEST(HorizonCache, AnyEditsGiveTheFieldOfAFreshComputation) {
    expectFreshFields(blocks(3, 3), 2000, false, [](const City& city) { return coarseRegion(city); });
}

TEST(HorizonCache, AnyEditsOfWhatHangsGiveTheFieldOfAFreshComputation) {
    expectFreshFields(blocks(3, 3), 1000, true, [](const City& city) { return coarseRegion(city); });
}

/// Drags buildings one after the other, some back to their first position, some together, with other edits,
/// other periods and a memory shortage in between.
void expectFreshFieldsWhileDragged(bool overhanging, std::uint64_t memoryBytes) {
    std::mt19937 random(5);
    City city = blocks(3, 3);
    AnyBuilding anyBuilding(random, {}, overhanging);
    const std::vector<SunSteps> periods{someDays(25, 2), someDays(50, 2), someDays(10, 1)};
    HorizonCache kept = cachedOf(city, coarseRegion(city), memoryBytes);
    retimed(kept, periods[0]);
    for (int drag = 0; drag < 60; ++drag) {
        if (drag % 3 == 0) city.buildings.push_back(anyBuilding());
        if (drag % 5 == 4) city.buildings.erase(city.buildings.begin() + std::ptrdiff_t(random() % 5));
        const std::size_t which = random() % city.buildings.size();
        for (std::uint32_t move = 0; move < 2 + random() % 6; ++move) {
            city.buildings[which] = anyBuilding();
            if (drag % 4 == 1) city.buildings.back() = anyBuilding();
            changed(kept, city, coarseRegion(city));
        }
        const SunSteps& sun = periods[std::size_t(drag) / 7 % periods.size()];
        ASSERT_TRUE(sameField(retimed(kept, sun), fresh(city, coarseRegion(city), sun))) << drag;
        while (city.buildings.size() > 20) city.buildings.pop_back();
    }
}

TEST(HorizonCache, DraggedBuildingsGiveTheFieldOfAFreshComputation) {
    for (const bool overhanging : {false, true})
        for (const std::uint64_t memoryBytes : {std::uint64_t{1} << 30U, std::uint64_t{320} << 10U})
            expectFreshFieldsWhileDragged(overhanging, memoryBytes);
}

TEST(HorizonCache, AnyEditsOnTerrainGiveTheFieldOfAFreshComputation) {
    City city;
    city.terrain = terrainOf(40, 6, RandomHills(4));
    expectFreshFields(city, 300, true, [](const City& now) { return coarseRegion(now); });
}

TEST(HorizonCache, AnyEditsUnderRoofsGiveTheFieldOfAFreshComputation) {
    for (const ReceiverPlaces places : {ReceiverPlaces::both, ReceiverPlaces::roofs})
        expectFreshFields(blocks(3, 3), 200, true,
                          [&](const City& city) { return coarseRegion(city, places); });
}

TEST(HorizonCache, TerrainThatBecomesAnotherIsSweptAnew) {
    City city = blocks(7, 3);
    const SunSteps sun = someDays(30, 2);
    HorizonCache kept = cachedOf(city, smallRegion(city));
    retimed(kept, sun);
    city.terrain = terrainOf(40, 6, RandomHills(4));
    EXPECT_TRUE(sameField(changed(kept, city, smallRegion(city)), fresh(city, smallRegion(city), sun)));
    city.terrain = terrainOf(40, 6, RandomHills(5));
    EXPECT_TRUE(sameField(changed(kept, city, smallRegion(city)), fresh(city, smallRegion(city), sun)));
}

/// Mean difference from the rays over the receivers, as a share of the period.
double offRays(const City& city, const Receivers& receivers, const SunSteps& sun) {
    const ShadowField kept = fresh(city, receivers, sun), truth = traced(city, receivers, sun);
    double off = 0;
    for (const std::uint32_t cell : receivers.cells)
        off += double(std::abs(kept.grossMin[cell] - truth.grossMin[cell]));
    return off / double(receivers.cells.size()) / truth.sunlitMinutesPerDay;
}

TEST(HorizonCache, WhatHangsAgreesWithRays) {
    const SunSteps sun = someDays(40, 4);
    const auto off = [&](const City& city) { return offRays(city, smallRegion(city, 2), sun); };
    EXPECT_LE(off(cityOf({{{20, 20, 10}, {60, 50, 13}}})), 0.004);
    EXPECT_LE(
        off(cityOf({{{0, 0, 0}, {15, 40, 30}}, {{15, 12, 9}, {35, 20, 15}}, {{35, 0, 0}, {50, 40, 45}}})),
        0.004);
    std::vector<Box3> onStilts{{{30, 30, 12}, {55, 55, 90}}};
    for (const double x : {31.0, 51.0})
        for (const double y : {31.0, 51.0}) onStilts.push_back({{x, y, 0}, {x + 3, y + 3, 12}});
    EXPECT_LE(off(cityOf(onStilts)), 0.004);
}

TEST(HorizonCache, TerrainAgreesWithRays) {
    City city;
    city.terrain = terrainOf(40, 6, RandomHills(4));
    std::mt19937 random(3);
    for (int i = 0; i < 12; ++i) editAnything(city, random, true);
    EXPECT_LE(offRays(city, smallRegion(city, 2), someDays(40, 4)), 0.006);
}

TEST(HorizonCache, LongestRunsMayBeCountedLater) {
    std::mt19937 random(5);
    City city = blocks(6, 3);
    Receivers receivers = smallRegion(city, 4);
    HorizonCache kept = cachedOf(city, receivers);
    NoProgress progress;
    EXPECT_FALSE(kept.withRuns(progress, {}));
    const std::vector<SunSteps> periods{someDays(25, 3), someDays(25, 2), someDays(50, 2)};
    for (int round = 0; round < 60; ++round) {
        const SunSteps& sun = periods[std::size_t(round) % periods.size()];
        kept.retime(sun, progress, {}, ShadowCounts::gross).value();
        editAnything(city, random);
        receivers = smallRegion(city, 4);
        const ShadowField gross = kept.change(city, receivers, progress, {}, ShadowCounts::gross).value();
        const ShadowField whole = fresh(city, receivers, sun);
        ASSERT_TRUE(sameBits(gross.grossMin, whole.grossMin)) << round;
        ASSERT_TRUE(
            std::ranges::all_of(gross.continuousMin, [](float minutes) { return std::isnan(minutes); }));
        if (round % 3 == 1) continue;
        ASSERT_TRUE(sameField(kept.withRuns(progress, {}).value(), whole)) << round;
    }
}

TEST(HorizonCache, TilesBeyondTheMemoryAreSweptAnew) {
    const City city = blocks(4, 4);
    const Receivers receivers = receiversOver(city, -60, -60, 330, 330);
    HorizonCache kept = cachedOf(city, receivers, 12 << 20);
    const SunSteps sun = someDays(30, 2);
    EXPECT_TRUE(sameField(retimed(kept, sun), fresh(city, receivers, sun)));
    EXPECT_LE(kept.bytes(), 12U << 20U);
    EXPECT_GT(kept.bytes(), 0U);
    City less = city;
    less.buildings.pop_back();
    const Receivers open = receiversOver(less, -60, -60, 330, 330);
    EXPECT_TRUE(sameField(changed(kept, less, open), fresh(less, open, sun)));
}

TEST(HorizonCache, RefuseWhatTheyCannotDo) {
    const City city = blocks(5, 2);
    const Receivers receivers = smallRegion(city);
    HorizonCache kept = cachedOf(city, receivers);
    NoProgress progress;
    EXPECT_NE(kept.change(city, receivers, progress, {}).error().text().find("period"), std::string::npos);
    retimed(kept, someDays(40, 1));
    EXPECT_NE(
        kept.change(city, receiversOver(city, 0, 0, 30, 30), progress, {}).error().text().find("region"),
        std::string::npos);
    City laden = city;
    for (int i = 0; i <= 50'000; ++i) laden.buildings.push_back(buildingOf({{0, 0, 5}, {10, 10, 10}}));
    EXPECT_NE(kept.change(laden, receivers, progress, {}).error().text().find("overhanging prisms"),
              std::string::npos);
    EXPECT_TRUE(sameField(changed(kept, city, receivers), fresh(city, receivers, someDays(40, 1))));
    NoProgress silent;
    EXPECT_FALSE(cachedOf(laden, receivers).retime(someDays(40, 1), silent, {}));
}

TEST(HorizonCache, WhatHangsOutOfReachIsNotCounted) {
    const City city = blocks(5, 2);
    const Receivers receivers = smallRegion(city);
    City laden = city;
    for (int i = 0; i <= 50'000; ++i) laden.buildings.push_back(buildingOf({{9000, 0, 5}, {9010, 10, 10}}));
    const SunSteps sun = someDays(40, 1);
    const ShadowField bare = fresh(city, receivers, sun);
    EXPECT_TRUE(sameField(fresh(laden, receivers, sun), bare));
    HorizonCache kept = cachedOf(city, receivers);
    retimed(kept, sun);
    EXPECT_TRUE(sameField(changed(kept, laden, receivers), bare));
    laden.buildings.push_back(buildingOf({{40, 0, 30}, {60, 100, 35}}));
    EXPECT_TRUE(sameField(changed(kept, laden, receivers), fresh(laden, receivers, sun)));
}

TEST(HorizonCache, AfterAStopTheyAreWholeAgain) {
    const City city = blocks(5, 3);
    const Receivers receivers = smallRegion(city);
    HorizonCache kept = cachedOf(city, receivers);
    std::stop_source source;
    source.request_stop();
    NoProgress progress;
    EXPECT_TRUE(isCancelled(kept.retime(someDays(40, 1), progress, source.get_token()).error()));
    EXPECT_TRUE(sameField(retimed(kept, someDays(40, 1)), fresh(city, receivers, someDays(40, 1))));
    City less = city;
    less.buildings.pop_back();
    EXPECT_TRUE(isCancelled(kept.change(less, smallRegion(less), progress, source.get_token()).error()));
    EXPECT_TRUE(sameField(retimed(kept, someDays(40, 1)), fresh(less, smallRegion(less), someDays(40, 1))));
}

}  // namespace
}  // namespace noonmark
