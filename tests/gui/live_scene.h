#pragma once

#include <cmath>
#include <cstring>

#include "app/gui/tools/live/live_shadow.h"
#include "core/engines/horizon/cache/horizon_cache.h"
#include "core/receivers/roof_receivers.h"
#include "tests/gui/small_city.h"

/// The small city on level ground or on a slope, and a tower to edit in it.
namespace noonmark::test {

inline Period spring(int days, double stepMinutes) {
    Period period;
    period.start = std::chrono::year(2026) / 4 / 20;
    period.days = days;
    period.from = std::chrono::hours(8);
    period.hours = 3;
    period.stepMinutes = stepMinutes;
    period.zone = "America/New_York";
    return period;
}

inline SunQuestion sunOf(const Period& period) { return {period, {{-73.98, 40.76}, 0}}; }

/// Terrain that rises to the north-east, with a bump.
inline std::shared_ptr<const Terrain> slope() {
    Terrain terrain{{-600, -600, 20, 60, 60}, {}};
    for (int row = 0; row < 60; ++row)
        for (int column = 0; column < 60; ++column) {
            const glm::dvec2 place = terrain.grid.centre(column, row);
            terrain.elevationM.push_back(
                float(20 + 0.05 * place.x + 0.03 * place.y + 4 * std::sin(place.x / 40)));
        }
    return std::make_shared<const Terrain>(std::move(terrain));
}

inline City smallCityOnASlope() {
    City city = smallCity();
    city.terrain = slope();
    for (auto& building : city.buildings) {
        Building raised = *building;
        const float ground = groundAt(city, glm::dvec2(raised.parts[0].footprint.outer[0]));
        raised.parts[0].bottomM += ground - 5;
        raised.parts[0].topM += ground;
        building = std::make_shared<const Building>(std::move(raised));
    }
    return city;
}

/// A tower of 30 x 30 x 120 m, `eastM` further east than its first place.
inline LiveReceivers::Shape tower(float eastM = 0, float bottomM = 0) {
    Building building{.sourceId = "Tower 1"};
    building.parts.push_back(
        {.footprint = square({20 + eastM, -30}, 30), .bottomM = bottomM, .topM = bottomM + 120});
    return {std::make_shared<const Building>(building)};
}

inline LivePlace placeIn(const City& city) { return {city, {{{20, -30}, {50, 0}}, 120}, 200}; }

inline City with(City city, const LiveReceivers::Shape& shape) {
    city.buildings.insert(city.buildings.end(), shape.begin(), shape.end());
    return city;
}

/// The shadow from newly computed horizons, without a cache.
inline ShadowField freshHorizons(const City& city, const Receivers& receivers, const Period& period) {
    NoProgress progress;
    auto cache = HorizonCache::make(city, receivers, {SharedHorizonCache::binDeg}).value();
    const SunQuestion question = sunOf(period);
    return cache.computePeriod(computeSunSteps(question.period, question.observer).value(), progress, {})
        .value();
}

inline bool sameBits(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

}  // namespace noonmark::test
