#pragma once

#include <cstring>

#include "core/engines/horizon/cache/horizon_cache.h"
#include "tests/core/engines/scenes.h"

// Small cities, and caches of their horizons, for the tests of HorizonCache.
namespace noonmark::tests {

inline constexpr double cachedBinDeg = 1;

inline HorizonCache cachedOf(const City& city, const Receivers& receivers,
                             std::uint64_t memoryBytes = std::uint64_t{1} << 30U) {
    return std::move(HorizonCache::make(city, receivers, {cachedBinDeg, memoryBytes}).value());
}

inline ShadowField retimed(HorizonCache& cache, const SunSteps& sun) {
    NoProgress progress;
    return cache.computePeriod(sun, progress, {}).value();
}

inline ShadowField changed(HorizonCache& cache, const City& city, const Receivers& receivers) {
    NoProgress progress;
    return cache.change(city, receivers, progress, {}).value();
}

inline ShadowField fresh(const City& city, const Receivers& receivers, const SunSteps& sun) {
    HorizonCache cache = cachedOf(city, receivers);
    return retimed(cache, sun);
}

inline bool sameBits(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

inline bool sameField(const ShadowField& a, const ShadowField& b) {
    return sameBits(a.grossMin, b.grossMin) && sameBits(a.continuousMin, b.continuousMin);
}

inline City blocks(std::uint32_t seed, int perSide) {
    std::vector<Box3> boxes = randomBoxes(seed, perSide);
    for (Box3& box : boxes) box.low.z = 0;
    return cityOf(boxes);
}

inline Receivers smallRegion(const City& city, double cellM = 3) {
    return receiversOver(city, -10, -10, 110, 110, cellM);
}

inline SunSteps someDays(double noonDeg, int days) {
    SunSteps sun;
    for (int day = 0; day < days; ++day) addDay(sun, arc(90 + 7 * day, noonDeg + 6 * day, day % 3 == 2));
    return sun;
}

}  // namespace noonmark::tests
