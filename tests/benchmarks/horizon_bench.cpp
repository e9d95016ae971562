// The horizon sweep over a year of 8 h days at one minute, over 800 x 800 m in the centre of the grid sample
// with a million triangles. First cells are compared with the ray reference on a sample of receivers. Then
// the sweep is timed, as processor time divided by the number of cores; the ray reference's time for all
// receivers is extrapolated from the sample. Last come cached horizons: with other times, and after moving a
// tower.
//
//     horizon_bench [bin width in deg] [receivers in the sample] [rounds]
#include <fmt/format.h>
#include <tbb/info.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <string>

#include "core/engines/horizon/cache/horizon_cache.h"
#include "core/engines/horizon/horizon_sweep.h"
#include "core/engines/ray/ray_reference.h"
#include "core/samples/sample_city.h"
#include "tests/benchmarks/bench_scene.h"

using namespace noonmark;
using bench::taken, bench::workingYearOf;

namespace {

struct Timed {
    ShadowField field;
    double seconds = 0;
};

/// Processor time of all threads divided by the number of cores, so that other programs do not count.
double secondsOf(const auto& work) {
    const std::clock_t start = std::clock();
    work();
    return double(std::clock() - start) / CLOCKS_PER_SEC / tbb::info::default_concurrency();
}

Timed timed(const Engine& engine, const City& city, const Receivers& receivers, const SunSteps& sun) {
    NoProgress progress;
    ShadowField field;
    const double seconds =
        secondsOf([&] { field = taken(engine.accumulate(city, receivers, sun, progress, {})); });
    return {std::move(field), seconds};
}

Receivers findMiddle(const City& city) {
    const Box2 box = bounds(city);
    const glm::vec2 middle = (box.low + box.high) * 0.5F;
    return taken(
        placeReceiversOnGround(city, makeRegionFromLocalBox({middle - 400.0F, middle + 400.0F}), {}));
}

/// The same receivers, reduced to a random sample.
Receivers sampleOf(Receivers receivers, std::size_t count) {
    std::mt19937 random(7);
    std::shuffle(receivers.cells.begin(), receivers.cells.end(), random);
    for (std::size_t i = count; i < receivers.cells.size(); ++i)
        receivers.kind[receivers.cells[i]] = CellKind::outside;
    receivers.cells.resize(std::min(count, receivers.cells.size()));
    std::ranges::sort(receivers.cells);
    return receivers;
}

struct CellErrors {
    double meanPct = 0;
    double maxPct = 0;
};

CellErrors errorsOf(const std::vector<float>& minutes, const std::vector<float>& truth,
                    const Receivers& sample, double wholeMinutes) {
    CellErrors errors;
    for (const std::uint32_t cell : sample.cells) {
        const double percent = 100 * std::abs(double(minutes[cell]) - double(truth[cell])) / wholeMinutes;
        errors.meanPct += percent / double(sample.cells.size());
        errors.maxPct = std::max(errors.maxPct, percent);
    }
    return errors;
}

void printStages(const ShadowField& field) {
    for (const auto& [stage, seconds] : field.cost.seconds) fmt::print("  {} {:.3f} s\n", stage, seconds);
}

double medianOf(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// The city with a tower of 40 x 40 x 200 m whose centre lies `eastM` east of `middle`.
City withTower(City city, glm::vec2 middle, float eastM) {
    const glm::vec2 a = middle + glm::vec2(eastM - 20, -20), b = a + 40.0F;
    Building tower;
    tower.parts.push_back({.footprint = {{{a.x, a.y}, {b.x, a.y}, {b.x, b.y}, {a.x, b.y}}, {}}, .topM = 200});
    city.buildings.push_back(std::make_shared<const Building>(std::move(tower)));
    return city;
}

/// Cached horizons, gross shadow: the same year again, one day of it, and a tower of 200 m moved by 10 m.
void benchCaches(const City& city, const Receivers& bare, const SunSteps& sun, double binDeg, int rounds) {
    NoProgress progress;
    const Box2 box = bounds(city);
    const glm::vec2 middle = (box.low + box.high) * 0.5F;
    const auto receiversOf = [&](const City& of) {
        return taken(
            placeReceiversOnGround(of, makeRegionFromLocalBox({middle - 400.0F, middle + 400.0F}), {}));
    };
    City now = withTower(city, middle, 0);
    HorizonCache kept =
        taken(HorizonCache::make(now, receiversOf(now), {.binDeg = binDeg > 0 ? binDeg : 0.5}));
    const double full = secondsOf([&] { taken(kept.computePeriod(sun, progress, {}, ShadowCounts::gross)); });
    SunSteps day = sun;
    day.days = {sun.days[100]};
    day.days[0].first = 0;
    day.steps.assign(sun.steps.begin() + sun.days[100].first,
                     sun.steps.begin() + sun.days[100].first + sun.days[100].count);
    std::vector<double> again, ofDay, edits;
    for (int round = 0; round < rounds; ++round) {
        ofDay.push_back(
            secondsOf([&] { taken(kept.computePeriod(day, progress, {}, ShadowCounts::gross)); }));
        again.push_back(
            secondsOf([&] { taken(kept.computePeriod(sun, progress, {}, ShadowCounts::gross)); }));
    }
    for (int round = 1; round <= 2 * rounds; ++round) {
        now = withTower(city, middle, round % 2 == 0 ? 0.0F : 10.0F);
        const Receivers receivers = receiversOf(now);
        ShadowField field;
        edits.push_back(secondsOf(
            [&] { field = taken(kept.change(now, receivers, progress, {}, ShadowCounts::gross)); }));
        if (round == 1) printStages(field);
    }
    fmt::print(
        "kept: full {:.3f} s, {} MB; year again {:.3f} s, a day of it {:.3f} s, tower moved {:.4f} s\n", full,
        kept.bytes() >> 20U, medianOf(again), medianOf(ofDay), medianOf(edits));
    fmt::print("retime_fraction {:.4f}\nretime_day_fraction {:.4f}\nedit_fraction {:.4f}\nedit_ms {:.1f}\n",
               medianOf(again) / full, medianOf(ofDay) / full, medianOf(edits) / full, 1e3 * medianOf(edits));
    const ShadowField edited = taken(kept.computePeriod(sun, progress, {}));
    const ShadowField fresh =
        taken(taken(HorizonCache::make(now, receiversOf(now), {.binDeg = binDeg > 0 ? binDeg : 0.5}))
                  .computePeriod(sun, progress, {}));
    for (const std::uint32_t cell : bare.cells)
        if (edited.grossMin[cell] != fresh.grossMin[cell] && fresh.grossMin[cell] == fresh.grossMin[cell])
            fmt::print("WRONG at {}\n", cell);
}

}  // namespace

int main(int argc, char** argv) {
    bench::chooseInstructionSet();
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    const double binDeg =
        argc > 1 ? std::stod(argv[1]) : HorizonSweepSettings{}.binDeg;  // 0: chosen by the error target
    const std::size_t sampleSize = argc > 2 ? std::stoul(argv[2]) : 300;
    const int rounds = argc > 3 ? std::stoi(argv[3]) : 3;
    const City city = taken(makeGridSample({.buildings = 43'000, .roundness = 7}));
    const Receivers receivers = findMiddle(city), sample = sampleOf(receivers, sampleSize);
    const SunSteps sun = workingYearOf(city);
    fmt::print("{} triangles, {} receivers of {} cells, {} steps, {} threads\n",
               meshOf(city).mesh.triangles.size(), receivers.cells.size(), receivers.grid.size(),
               sun.steps.size(), tbb::info::default_concurrency());

    const HorizonSweep sweep({.binDeg = binDeg});
    const Timed truth = timed(RayReference(), city, sample, sun), first = timed(sweep, city, receivers, sun);
    const CellErrors gross =
        errorsOf(first.field.grossMin, truth.field.grossMin, sample, first.field.sunlitMinutesPerDay);
    const CellErrors continuous =
        errorsOf(first.field.continuousMin, truth.field.continuousMin, sample, 8 * 60);
    fmt::print("{}\n", first.field.engine);
    printStages(first.field);

    std::vector<double> seconds;
    for (int round = 0; round < rounds; ++round) {
        Timed again = timed(sweep, city, receivers, sun);
        printStages(again.field);
        seconds.push_back(again.seconds);
    }
    std::ranges::sort(seconds);
    const double sweepSeconds = seconds[seconds.size() / 2];
    const double raySeconds = truth.seconds * double(receivers.cells.size()) / double(sample.cells.size());
    fmt::print("ray reference {:.0f} s ({:.1f} M rays/s), sweep {:.3f} s\n", raySeconds,
               1e-6 * double(truth.field.cost.rays) / truth.seconds, sweepSeconds);
    fmt::print("year_vs_ray {:.0f}\nyear_cell_error_mean_pct {:.4f}\nyear_cell_error_max_pct {:.4f}\n",
               raySeconds / sweepSeconds, gross.meanPct, gross.maxPct);
    fmt::print("continuous_error_mean_pct {:.4f}\ncontinuous_error_max_pct {:.4f}\n", continuous.meanPct,
               continuous.maxPct);
    benchCaches(city, receivers, sun, binDeg, rounds);
    return gross.meanPct <= 0.05 && gross.maxPct <= 0.5 ? EXIT_SUCCESS : EXIT_FAILURE;
}
