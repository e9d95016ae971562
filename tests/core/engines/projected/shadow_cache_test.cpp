#include "core/engines/projected/shadow_cache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "core/engines/common/changed_buildings.h"
#include "core/engines/projected/projected_shadows.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

NoProgress silent;

ShadowField fresh(const City& city, const Receivers& receivers, const SunSteps& sun) {
    return ProjectedShadows().accumulate(city, receivers, sun, silent, {}).value();
}

ShadowCache cachedOf(const City& city, const Receivers& receivers, const SunSteps& sun) {
    return std::move(ShadowCache::make(city, receivers, sun, silent, {}).value());
}

bool sameBits(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

bool sameField(const ShadowField& a, const ShadowField& b) {
    return sameBits(a.grossMin, b.grossMin) && sameBits(a.continuousMin, b.continuousMin);
}

// Two short days, one with a gap; the number of steps is not a multiple of eight.
SunSteps someDays() {
    SunSteps sun;
    addDay(sun, arc(37, 50));
    addDay(sun, arc(20, 35));
    for (std::size_t k = 45; k < sun.steps.size(); ++k) sun.steps[k].slot += 3;
    return sun;
}

Receivers overAll(const City& city, double cellM = 3) {
    return receiversOver(city, -11, -7, 221, 140, cellM);
}

/// Creates buildings of every kind in and around the region.
class AnyBuilding {
public:
    explicit AnyBuilding(std::uint32_t seed) : random_(seed) {}

    std::shared_ptr<const Building> make() {
        x_ = between(-60, 240);
        y_ = between(-60, 160);
        if (random_() % 3 == 0) x_ = std::floor(x_);
        turn_ = random_() % 2 == 0 ? 0 : between(0, 1.5F);
        top_ = between(2, 80);
        switch (random_() % 5) {
            case 0:
                return buildingOf({concave(), {}}, 0, top_);
            case 1:
                return withCourt();
            case 2:
                return buildingOf({random_() % 2 == 0 ? box() : concave(), {}}, 0.7F * top_, top_, true);
            case 3:
                return gabled();
            default:
                return buildingOf({box(), {}}, 0, top_);
        }
    }

    std::size_t below(std::size_t count) { return std::size_t(random_()) % count; }

private:
    float between(float low, float high) {
        return low + (high - low) * float(random_() % 100000) / 100000.0F;
    }
    glm::vec2 corner(float u, float v) const {
        const float c = std::cos(turn_), s = std::sin(turn_);
        return {x_ + c * u - s * v, y_ + s * u + c * v};
    }
    Ring parseRing(const std::vector<glm::vec2>& points) const {
        Ring ring;
        for (const glm::vec2 p : points) ring.push_back(corner(p.x, p.y));
        return ring;
    }
    Ring box() {
        const float a = between(3, 30), b = between(3, 30);
        return parseRing({{0, 0}, {a, 0}, {a, b}, {0, b}});
    }
    Ring concave() {
        const float a = between(6, 30), b = between(6, 30);
        return parseRing({{0, 0}, {a, 0}, {a, b}, {a / 2, b / 3}, {0, b}});
    }
    std::shared_ptr<const Building> withCourt() {
        const float a = between(9, 30), b = between(9, 30);
        const Ring hole = parseRing({{a / 3, b / 3}, {a / 3, b / 2}, {a / 2, b / 2}, {a / 2, b / 3}});
        return buildingOf({parseRing({{0, 0}, {a, 0}, {a, b}, {0, b}}), {hole}}, 0, top_);
    }
    // A mesh with a pitched roof.
    std::shared_ptr<const Building> gabled() {
        const float a = between(6, 25), b = between(6, 25), eaves = 0.6F * top_;
        TriangleMesh mesh;
        for (const float z : {0.0F, eaves})
            for (const glm::vec2 p : {glm::vec2(0, 0), {a, 0}, {a, b}, {0, b}})
                mesh.vertices.emplace_back(corner(p.x, p.y), z);
        mesh.vertices.emplace_back(corner(0, b / 2), top_);
        mesh.vertices.emplace_back(corner(a, b / 2), top_);
        mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {2, 3, 7}, {2, 7, 6},
                          {1, 2, 6}, {1, 6, 9}, {1, 9, 5}, {3, 0, 4}, {3, 4, 8}, {3, 8, 7},
                          {4, 5, 9}, {4, 9, 8}, {6, 7, 8}, {6, 8, 9}};
        Building building;
        building.parts.push_back({.footprint = {parseRing({{0, 0}, {a, 0}, {a, b}, {0, b}}), {}},
                                  .topM = top_,
                                  .mesh = std::make_shared<const TriangleMesh>(mesh)});
        return std::make_shared<const Building>(std::move(building));
    }

    std::mt19937 random_;
    float x_ = 0, y_ = 0, turn_ = 0, top_ = 0;
};

void editAnything(City& city, AnyBuilding& any) {
    const std::size_t kind = any.below(4);
    const auto somewhere = [&] {
        return city.buildings.begin() + std::ptrdiff_t(any.below(city.buildings.size()));
    };
    if (kind == 0 || city.buildings.size() < 5) {
        city.buildings.insert(somewhere(), any.make());
    } else if (kind == 1 || city.buildings.size() > 30) {
        city.buildings.erase(somewhere());
    } else if (kind == 2) {
        *somewhere() = any.make();
    } else {
        std::iter_swap(city.buildings.begin(), somewhere());
        city.buildings.push_back(*somewhere());  // the same building twice
    }
}

TEST(ShadowCache, AreThoseOfAFreshRunAfterAnyEdits) {
    AnyBuilding any(5);
    City city = cityOf(randomBoxes(3, 4));
    const SunSteps sun = someDays();
    ShadowCache kept = cachedOf(city, overAll(city), sun);
    ASSERT_TRUE(sameField(kept.field(), fresh(city, overAll(city), sun)));
    for (int edit = 0; edit < 3000; ++edit) {
        for (std::size_t i = 0; i <= any.below(3); ++i) editAnything(city, any);
        const Receivers receivers = overAll(city);
        ASSERT_TRUE(kept.change(city, receivers, silent, {}));
        if (edit % 5 == 0) {
            ASSERT_TRUE(sameField(kept.field(), fresh(city, receivers, sun))) << edit;
        }
    }
    EXPECT_GT(kept.bytes(), 0U);
}

TEST(ShadowCache, ADayOfManyStepsWhereATowerMovesAndGoes) {
    City city = cityOf(randomBoxes(7, 5));
    const SunSteps sun = oneDay(arc(301, 48));
    ShadowCache kept = cachedOf(city, overAll(city, 1), sun);
    city.buildings.push_back(nullptr);
    for (float east = 0; east < 60; east += 13) {
        city.buildings.back() = buildingOf(Box3{{20 + east, 30, 0}, {45 + east, 52, 90}});
        const Receivers receivers = overAll(city, 1);
        ASSERT_TRUE(kept.change(city, receivers, silent, {}));
        EXPECT_TRUE(sameField(kept.field(), fresh(city, receivers, sun))) << east;
    }
    city.buildings.pop_back();
    ASSERT_TRUE(kept.change(city, overAll(city, 1), silent, {}));
    EXPECT_TRUE(sameField(kept.field(), fresh(city, overAll(city, 1), sun)));
}

TEST(ShadowCache, HoldWhereManyBuildingsShadeTheSameCells) {
    City city;
    for (int i = 0; i < 40; ++i)
        city.buildings.push_back(buildingOf(Box3{{3 * i, 20 + i, 0}, {3 * i + 60, 30 + i, 30 + i}}));
    const SunSteps sun = oneDay(arc(24, 30));
    ShadowCache kept = cachedOf(city, overAll(city), sun);
    while (!city.buildings.empty()) {
        city.buildings.erase(city.buildings.begin() + std::ptrdiff_t(city.buildings.size() / 2));
        ASSERT_TRUE(kept.change(city, overAll(city), silent, {}));
        ASSERT_TRUE(sameField(kept.field(), fresh(city, overAll(city), sun))) << city.buildings.size();
    }
}

TEST(ShadowCache, RefuseAnotherRegionTerrainAndTooMuchMemory) {
    City city = cityOf(randomBoxes(2, 3));
    const Receivers receivers = overAll(city);
    const SunSteps sun = oneDay(arc(64, 40));
    ShadowCache kept = cachedOf(city, receivers, sun);
    EXPECT_NE(kept.change(city, receiversOver(city, 0, 0, 30, 30), silent, {}).error().text().find("region"),
              std::string::npos);
    City hilly = city;
    hilly.terrain = std::make_shared<const Terrain>(Terrain{{-50, -50, 50, 2, 2}, {0, 1, 2, 3}});
    EXPECT_NE(kept.change(hilly, receivers, silent, {}).error().text().find("flat ground"),
              std::string::npos);
    EXPECT_TRUE(sameField(kept.field(), fresh(city, receivers, sun)));
    for (const std::uint64_t few : {10000U, 60000U}) {  // refused at once, and refused once the need is known
        const auto refused = ShadowCache::make(city, receivers, sun, silent, {}, {few});
        ASSERT_FALSE(refused) << few;
        EXPECT_NE(refused.error().text().find("smaller region"), std::string::npos);
    }
}

TEST(ShadowCache, AfterAStopTheyAreMadeAgain) {
    City city = cityOf(randomBoxes(2, 3));
    const SunSteps sun = oneDay(arc(40, 40));
    ShadowCache kept = cachedOf(city, overAll(city), sun);
    std::stop_source source;
    source.request_stop();
    city.buildings.pop_back();
    EXPECT_TRUE(isCancelled(kept.change(city, overAll(city), silent, source.get_token()).error()));
    city.buildings.erase(city.buildings.begin());
    ASSERT_TRUE(kept.change(city, overAll(city), silent, {}));
    EXPECT_TRUE(sameField(kept.field(), fresh(city, overAll(city), sun)));
}

TEST(ShadowCache, NightAndNoCityGiveZeros) {
    SunSteps night;
    night.days.push_back({});
    const City city = cityOf({{{0, 0, 0}, {10, 10, 10}}});
    for (const SunSteps& sun : {night, oneDay(arc(10, 40))}) {
        ShadowCache kept = cachedOf({}, overAll({}), sun);
        ASSERT_TRUE(kept.change(city, overAll(city), silent, {}));
        EXPECT_TRUE(sameField(kept.field(), fresh(city, overAll(city), sun)));
    }
}

TEST(ChangedBuildings, AreThoseThatTheOtherCityLacks) {
    const Buildings all = cityOf(randomBoxes(1, 3)).buildings;
    const auto pick = [&](const std::vector<std::size_t>& which) {
        Buildings some;
        for (const std::size_t i : which) some.push_back(all[i]);
        return some;
    };
    const ChangedBuildings none = findChangedBuildings(pick({0, 1, 2}), pick({2, 0, 1}));
    EXPECT_TRUE(none.removed.empty() && none.added.empty());
    const ChangedBuildings shifted = findChangedBuildings(pick({0, 1, 2, 3, 5}), pick({0, 2, 3, 4, 5, 1}));
    EXPECT_TRUE(shifted.removed.empty());
    EXPECT_EQ(shifted.added, pick({4}));
    EXPECT_EQ(shifted.first, 1U);
    Buildings taken = pick({0, 1, 2, 3, 5});
    updateBuildings(taken, pick({0, 2, 3, 4, 5, 1}), shifted.first);
    EXPECT_EQ(taken, pick({0, 2, 3, 4, 5, 1}));
    const ChangedBuildings some = findChangedBuildings(pick({0, 1, 1, 2, 5}), pick({0, 3, 1, 4, 4, 5}));
    EXPECT_EQ(some.removed, pick({1, 2}));
    EXPECT_EQ(some.added, pick({3, 4, 4}));
}

}  // namespace
}  // namespace noonmark
