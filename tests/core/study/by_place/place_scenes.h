#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "core/study/by_place/sun_by_place.h"
#include "tests/core/engines/scenes.h"

namespace noonmark::tests {

inline City loneTower() {
    City city = cityOf({{{0, 0, 0}, {20, 20, 60}}});
    city.frame = Frame({-73.98, 40.75});
    return city;
}

inline Place namedPlace(const std::string& name, float west, float south, float east, float north,
                        PlaceKind kind = PlaceKind::park) {
    return {name, kind, {{rectangle(west, south, east, north), {}}}, "made up"};
}

inline SunByPlaceSettings settingsOfDays(int days, double cellM = 2) {
    SunByPlaceSettings settings;
    settings.study.receivers.cellM = cellM;
    settings.study.period = {.start = std::chrono::year(2026) / 2 / 20,
                             .days = days,
                             .stepMinutes = 10,
                             .window = SolarHours{},
                             .zone = "America/New_York"};
    return settings;
}

inline SunByPlace measureByPlace(const City& city, const std::vector<Place>& places,
                                 const SunByPlaceSettings& settings) {
    NoProgress quiet;
    auto sun = runSunByPlace(city, places, settings, quiet, {});
    EXPECT_TRUE(sun) << (sun ? "" : sun.error().text());
    return sun ? *std::move(sun) : SunByPlace{};
}

/// A wall 60 m high along the south of the park, in one city alone.
inline City withSouthWall(const City& city) {
    City changed = city;
    changed.buildings.push_back(buildingOf(Box3{{-30, 15, 0}, {50, 18, 60}}));
    return changed;
}

inline SunOfCities compareByPlace(const std::vector<NamedCity>& cities, const std::vector<Place>& places,
                                  const SunByPlaceSettings& settings) {
    NoProgress quiet;
    auto sun = compareSunByPlace(cities, places, settings, quiet, {});
    EXPECT_TRUE(sun) << (sun ? "" : sun.error().text());
    return sun ? *std::move(sun) : SunOfCities{};
}

}  // namespace noonmark::tests
