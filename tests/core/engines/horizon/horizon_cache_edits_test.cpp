#include <gtest/gtest.h>

#include "core/receivers/roof_receivers.h"
#include "tests/core/engines/horizon_cache_scenes.h"
#include "tests/core/engines/random_edits.h"

// Whatever is edited, a cache returns the bits of a fresh computation.
namespace noonmark {
namespace {

using namespace tests;

/// Edits a city at random and compares the field with a new one from time to time.
template <class ReceiversOf>
void expectFreshFields(City city, int edits, bool overhanging, const ReceiversOf& receiversOf) {
    std::mt19937 random(11);
    HorizonCache cache = cachedOf(city, receiversOf(city));
    const std::vector<SunSteps> periods{someDays(25, 2), someDays(50, 2)};
    retimed(cache, periods[0]);
    for (int edit = 0; edit < edits; ++edit) {
        for (std::uint32_t i = 0; i <= random() % 3; ++i) editAnything(city, random, overhanging);
        const Receivers receivers = receiversOf(city);
        const std::size_t period = std::size_t(edit) / 40 % 2;
        ShadowField field = changed(cache, city, receivers);
        if (edit % 40 == 0) field = retimed(cache, periods[period]);
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
    HorizonCache cache = cachedOf(city, coarseRegion(city), memoryBytes);
    retimed(cache, periods[0]);
    for (int drag = 0; drag < 60; ++drag) {
        if (drag % 3 == 0) city.buildings.push_back(anyBuilding());
        if (drag % 5 == 4) city.buildings.erase(city.buildings.begin() + std::ptrdiff_t(random() % 5));
        const std::size_t which = random() % city.buildings.size();
        for (std::uint32_t move = 0; move < 2 + random() % 6; ++move) {
            city.buildings[which] = anyBuilding();
            if (drag % 4 == 1) city.buildings.back() = anyBuilding();
            changed(cache, city, coarseRegion(city));
        }
        const SunSteps& sun = periods[std::size_t(drag) / 7 % periods.size()];
        ASSERT_TRUE(sameField(retimed(cache, sun), fresh(city, coarseRegion(city), sun))) << drag;
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

}  // namespace
}  // namespace noonmark
