#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>

#include "core/io/read_city.h"
#include "core/receivers/receivers.h"
#include "core/samples/sample_city.h"
#include "core/simd/instruction_set.h"
#include "core/sun/sun_steps.h"

/// Shared by the benchmarks: a city, its central region, and a clock.
namespace noonmark::bench {

/// Wall time, and processor time of all threads; the latter is more reliable where other programs run.
struct Seconds {
    double wall = 1e9;
    double processor = 1e9;
    void keepBest(const Seconds& other) {
        wall = std::min(wall, other.wall);
        processor = std::min(processor, other.processor);
    }
};

inline Seconds secondsOf(const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t processor = std::clock();
    work();
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
            double(std::clock() - processor) / CLOCKS_PER_SEC};
}

/// By the environment variable NOONMARK_ISA.
inline void chooseInstructionSet() {
    const auto chosen = useInstructionSetOfEnvironment();
    if (chosen) return;
    fmt::print(stderr, "{}\n", chosen.error().text());
    std::exit(EXIT_FAILURE);
}

/// The value, or the end of the program.
template <class T>
T taken(Result<T> made) {
    if (made) return std::move(*made);
    fmt::print(stderr, "{}\n", made.error().text());
    std::exit(EXIT_FAILURE);
}

/// Reads a file of buildings, or makes the grid sample with this number of buildings.
inline City cityFrom(const std::string& argument) {
    NoProgress progress;
    if (std::filesystem::exists(argument)) return taken(readCity({argument}, {}, progress, {})).city;
    return taken(makeGridSample({.buildings = std::stoi(argument)}));
}

/// A square of 800 m around the centre.
inline Region findMiddle(const City& city) {
    const Box2 box = bounds(city);
    const glm::vec2 middle = (box.low + box.high) * 0.5F;
    return makeRegionFromLocalBox({middle - 400.0F, middle + 400.0F});
}

/// Eight hours of each day of a year, as New York counts them.
inline SunSteps workingYearOf(const City& city) {
    Period period;
    period.start = {std::chrono::year{2026}, std::chrono::January, std::chrono::day{1}};
    period.days = 365;
    period.hours = 8;
    period.zone = "America/New_York";
    const LonLat place = city.frame.origin();
    return taken(computeSunSteps(period, {.place = {place.lonDeg, place.latDeg}}));
}

}  // namespace noonmark::bench
