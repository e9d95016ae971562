// Points of a city's facades through a year of minutes with the sun up, in wall and processor time: by
// horizons, by horizons with unbroken times, and by rays on a sample, from which errors and ratios follow.
//
//     points_bench [FILE.osm.pbf or buildings] [points] [rounds] [sample]
#include "core/engines/points/point_horizons.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/city/city_position.h"
#include "core/lab/bench/points/point_bench.h"
#include "core/receivers/point_receivers.h"
#include "tests/benchmarks/bench_scene.h"

using namespace noonmark;
using namespace noonmark::bench;

namespace {

SurfacePoints facadePoints(const City& city, std::size_t maximum) {
    std::vector<std::uint32_t> buildings(city.buildings.size());
    std::iota(buildings.begin(), buildings.end(), 0U);
    return thinOut(placeOnFacades(city, buildings, {}).value().points, maximum);
}

SunSteps yearOf(const City& city) {
    Period year{.start = CivilDate{std::chrono::year{2026}, std::chrono::January, std::chrono::day{1}},
                .days = 365,
                .window = SolarHours{},
                .zone = "America/New_York"};
    return computeSunSteps(year, placeObserver(city, {0, 0})).value();
}

void printErrors(const char* what, std::vector<double> errors) {
    std::ranges::sort(errors);
    const double mean = std::accumulate(errors.begin(), errors.end(), 0.0) / double(errors.size());
    fmt::print("  {}: mean {:.4f} %, 99th {:.4f} %, largest {:.4f} %\n", what, mean,
               errors[errors.size() * 99 / 100], errors.back());
}

// In percent of the year's minutes, and of a day for unbroken times.
void compare(const PointMonths& swept, const PointMonths& traced) {
    std::vector<double> gross, shadow, sun;
    constexpr double dayMin = 1440;
    for (std::size_t i = 0; i < traced.sunlitMin.size(); ++i) {
        gross.push_back(100 * std::abs(swept.sunlitOf(i) - traced.sunlitOf(i)) / traced.possibleMin);
        shadow.push_back(100 * std::abs(swept.longestShadowMin[i] - traced.longestShadowMin[i]) / dayMin);
        sun.push_back(100 * std::abs(swept.longestSunMin[i] - traced.longestSunMin[i]) / dayMin);
    }
    printErrors("sunlit minutes", gross);
    printErrors("longest unbroken shadow", shadow);
    printErrors("longest unbroken sun", sun);
}

}  // namespace

int main(int argc, char** argv) {
    chooseInstructionSet();
    const auto numberAt = [&](int index, std::size_t otherwise) {
        return argc > index ? std::size_t(std::stoul(argv[index])) : otherwise;
    };
    const City city = cityFrom(argc > 1 ? argv[1] : "2000");
    const SurfacePoints points = facadePoints(city, numberAt(2, 20'000));
    const SurfacePoints sample = thinOut(points, numberAt(4, 200));
    const SunSteps sun = yearOf(city);
    NoProgress quiet;
    fmt::print("{} points, {} steps\n", points.size(), sun.steps.size());
    PointMonths traced;
    const Seconds rays = secondsOf([&] { traced = tracePoints(city, sample, sun, quiet, {}).value(); });
    compare(sweepPoints(city, sample, sun, quiet, {}, {.runs = true}).value(), traced);
    const double share = double(points.size()) / double(sample.size());
    fmt::print("{:<28} {:8.2f} s wall {:8.2f} s processor (from {} points)\n", "rays", rays.wall * share,
               rays.processor * share, sample.size());
    for (const bool runs : {false, true}) {
        Seconds best;
        for (std::size_t round = 0; round < numberAt(3, 3); ++round)
            best.keepBest(secondsOf([&] {
                benchmark::DoNotOptimize(sweepPoints(city, points, sun, quiet, {}, {.runs = runs}).value());
            }));
        fmt::print("{:<28} {:8.2f} s wall {:8.2f} s processor, {:.0f} x rays, {:.1f} us a point\n",
                   runs ? "horizons, unbroken times" : "horizons", best.wall, best.processor,
                   rays.processor * share / best.processor, best.processor * 1e6 / double(points.size()));
    }
    return EXIT_SUCCESS;
}
