// Every engine of core against the ray reference over some hours of one day: first the error, then the time
// in alternating runs.
//
//     engines_bench [FILE or number of buildings] [rounds] [hours] [engines other than ray, all if none]
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <span>
#include <vector>

#include "core/engines/api/engine_registry.h"
#include "core/lab/lab_engines.h"
#include "core/measures/statistics.h"
#include "tests/benchmarks/bench_scene.h"

using namespace noonmark;
using namespace noonmark::bench;

namespace {

struct Scene {
    City city;
    Receivers receivers;
    SunSteps sun;
};

/// 800 x 800 cells of 1 m in the centre of a city; 21 March 2026, from 9:00 in New York, every minute.
Scene dayScene(const std::string& cityName, double hours) {
    Scene scene;
    scene.city = cityFrom(cityName);
    scene.receivers = placeReceiversOnGround(scene.city, findMiddle(scene.city), {1}).value();
    scene.sun =
        computeSunSteps({.hours = hours, .zone = "America/New_York"}, {.place = scene.city.frame.origin()})
            .value();
    return scene;
}

ShadowField run(const Scene& scene, std::string_view engine) {
    NoProgress progress;
    auto field = makeEngine(engine, {}, coreAndLabEngines())
                     .value()
                     ->accumulate(scene.city, scene.receivers, scene.sun, progress, {});
    if (field) return std::move(*field);
    fmt::print(stderr, "{}: {}\n", engine, field.error().text());
    std::exit(EXIT_FAILURE);
}

struct CellError {
    double areaPct = 0;   ///< difference of the shadow area / area of the receivers
    double meanPct = 0;   ///< mean difference of gross minutes / period
    double worstMin = 0;  ///< largest difference of gross minutes
};

CellError errorOf(const Scene& scene, const ShadowField& field, const ShadowField& truth) {
    CellError error;
    for (const std::uint32_t cell : scene.receivers.cells) {
        const double difference = std::abs(double(field.grossMin[cell]) - double(truth.grossMin[cell]));
        error.meanPct += difference;
        error.worstMin = std::max(error.worstMin, difference);
    }
    error.meanPct *= 100 / (double(scene.receivers.cells.size()) * field.sunlitMinutesPerDay);
    const ShadowStatistics is = computeStatistics(field), should = computeStatistics(truth);
    error.areaPct = 100 * (is.shadowAreaM2 - should.shadowAreaM2) / should.receiverAreaM2;
    return error;
}

/// The ray reference and the requested engines.
std::vector<std::string_view> engineKeys(std::span<char*> asked) {
    std::vector<std::string_view> keys;
    for (const auto& [engine, make] : coreAndLabEngines())
        if (engine.key == "ray" || asked.empty() || std::ranges::count(asked, engine.key) > 0)
            keys.push_back(engine.key);
    return keys;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
    chooseInstructionSet();
    const int rounds = argc > 2 ? std::stoi(argv[2]) : 5;
    const Scene scene = dayScene(argc > 1 ? argv[1] : "43000", argc > 3 ? std::stod(argv[3]) : 6);
    const auto keys = engineKeys(std::span(argv, std::size_t(argc)).subspan(std::size_t(std::min(argc, 4))));
    const ShadowField truth = run(scene, "ray");
    std::map<std::string_view, std::vector<double>> wall, processor;
    for (int round = 0; round < rounds; ++round)
        for (const std::string_view key : keys) {
            const Seconds seconds = secondsOf([&] { run(scene, key); });
            wall[key].push_back(seconds.wall);
            processor[key].push_back(seconds.processor);
        }
    fmt::print("{} receivers, {} steps, medians of {} rounds\n", scene.receivers.cells.size(),
               scene.sun.steps.size(), rounds);
    for (const std::string_view key : keys) {
        const ShadowField field = run(scene, key);
        const CellError error = errorOf(scene, field, truth);
        fmt::print(
            "{:10} {:7.3f} s wall {:7.3f} s processor {:6.1f} x rays | area {:+.4f} %, cell mean {:.5f} %, "
            "worst {:.0f} min\n",
            key, median(wall[key]), median(processor[key]), median(processor["ray"]) / median(processor[key]),
            error.areaPct, error.meanPct, error.worstMin);
        for (const auto& [stage, seconds] : field.cost.seconds)
            fmt::print("{:>10} {:7.3f} s {}\n", "", seconds, stage);
    }
}
