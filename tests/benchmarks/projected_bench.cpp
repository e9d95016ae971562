// Projected shadows on one day of 6 h: 800 x 800 m in the centre of a city, in processor time. With "check"
// it lists each cell that differs from rays with the values of both engines; with "edit" it moves a tower
// with cached shadows.
//
//     projected_bench [FILE or number of buildings] [rounds] [check|edit]
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <vector>

#include "core/engines/projected/filling/bit_raster.h"
#include "core/engines/projected/projected_shadows.h"
#include "core/engines/ray/ray_reference.h"
#include "core/engines/ray/ray_scene.h"
#include "core/lab/bench/horizon/horizon_bench.h"
#include "tests/benchmarks/bench_scene.h"

using namespace noonmark;
using namespace noonmark::bench;

namespace {

ShadowField fieldOf(const Engine& engine, const City& city, const Receivers& receivers, const SunSteps& sun) {
    NoProgress progress;
    return engine.accumulate(city, receivers, sun, progress, {}).value();
}

// A checksum over the bits of all cells, to compare versions of the engine.
std::uint64_t checksum(const ShadowField& field) {
    std::uint64_t sum = 0;
    for (const auto* minutes : {&field.grossMin, &field.continuousMin})
        for (const float value : *minutes)
            sum = (sum ^ (std::isnan(value) ? 1U : std::bit_cast<std::uint32_t>(value))) * 0x100000001b3U;
    return sum;
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

std::uint32_t compare(const Receivers& receivers, const ShadowField& field, const ShadowField& truth) {
    std::map<int, int> counts;  // number of cells by difference in minutes
    std::uint32_t worst = 0;
    const auto off = [&](std::uint32_t cell) {
        return int(std::abs(field.grossMin[cell] - truth.grossMin[cell]));
    };
    for (const std::uint32_t cell : receivers.cells) {
        ++counts[off(cell)];
        if (off(cell) > off(worst)) worst = cell;
    }
    for (const auto& [minutes, cells] : counts) fmt::print("{:4} min off: {} cells\n", minutes, cells);
    fmt::print("worst: cell {} {}, {} min by polygons, {} min by rays\n",
               worst % std::uint32_t(receivers.grid.columns), worst / std::uint32_t(receivers.grid.columns),
               field.grossMin[worst], truth.grossMin[worst]);
    return worst;
}

// Prints the values of both engines at one cell, the steps at which they differ, and the surroundings.
void explain(const City& city, const Receivers& receivers, const SunSteps& sun, std::uint32_t cell) {
    const auto rasters = computeShadowRasters(city, receivers, sun).value();
    const BitLayout layout(receivers.grid);
    const auto scene = RayScene::over(city).value();
    const glm::vec3 origin = placeRayOrigin(receivers.position(cell));
    fmt::print("ray origin {:.6f} {:.6f} {:.6f}\n", origin.x, origin.y, origin.z);
    const int column = int(cell) % layout.columns, row = int(cell) / layout.columns;
    for (std::size_t step = 0; step < sun.steps.size(); ++step) {
        const bool filled = layout.at(std::span(rasters).subspan(step * layout.words()), column, row);
        if (filled != scene.occluded(origin, sun.steps[step].direction))
            fmt::print("  step {} azimuth {:.4f} altitude {:.4f}: polygons {}\n", step,
                       sun.steps[step].azimuthDeg, sun.steps[step].altitudeDeg, filled);
    }
    for (const auto& building : city.buildings)
        for (const Part& part : building->parts)
            for (std::size_t i = 0; i < part.footprint.outer.size(); ++i) {
                const glm::vec2 a = part.footprint.outer[i],
                                b = part.footprint.outer[(i + 1) % part.footprint.outer.size()];
                const glm::dvec2 d = glm::dvec2(b) - glm::dvec2(a), p = glm::dvec2(origin) - glm::dvec2(a);
                const double length = glm::length(d), aside = (d.x * p.y - d.y * p.x) / length,
                             along = glm::dot(d, p) / length;
                if (std::abs(aside) < 0.01 && along > -0.01 && along < length + 0.01)
                    fmt::print(
                        "  wall {:.6f} {:.6f} to {:.6f} {:.6f}, {} to {} m: {:.7f} m to its left, {:.6f} "
                        "along\n",
                        a.x, a.y, b.x, b.y, part.bottomM, part.topM, aside, along);
            }
}

void moveTower(const City& city, int rounds) {
    NoProgress progress;
    const Finding finding = benchDayEdits({.city = city}, {.runs = rounds}, {progress, {}}).value();
    fmt::print("{}\n", finding.text);
    for (const auto& row : finding.comparisons[0].rows)
        fmt::print("  {}: {} ms, {} to {}\n", row[0], row[1], row[2], row[3]);
}

}  // namespace

int main(int argc, char** argv) {
    chooseInstructionSet();
    const std::string name = argc > 1 ? argv[1] : "43000";
    const City city = std::filesystem::exists(name)
                          ? cityFrom(name)
                          : taken(makeGridSample({.buildings = std::stoi(name), .roundness = 7}));
    const Receivers receivers = placeReceiversOnGround(city, findMiddle(city), {1}).value();
    const SunSteps sun =
        computeSunSteps({.zone = "America/New_York"}, {.place = city.frame.origin()}).value();
    std::map<std::string, std::vector<double>> stages;
    std::vector<double> processor;
    ShadowField field;
    const int rounds = argc > 2 ? std::stoi(argv[2]) : 9;
    for (int round = 0; round < rounds; ++round) {
        processor.push_back(
            secondsOf([&] { field = fieldOf(ProjectedShadows(), city, receivers, sun); }).processor);
        for (const auto& [stage, seconds] : field.cost.seconds) stages[stage].push_back(seconds);
    }
    fmt::print("{} receivers, {} steps: {:.4f} s processor, median of {}\n", receivers.cells.size(),
               sun.steps.size(), median(processor), rounds);
    for (const auto& [stage, seconds] : stages) fmt::print("  {} {:.4f} s wall\n", stage, median(seconds));
    fmt::print("  checksum of the field {:016x}\n", checksum(field));
    const std::string more = argc > 3 ? argv[3] : "";
    if (more == "check")
        explain(city, receivers, sun,
                compare(receivers, field, fieldOf(RayReference(), city, receivers, sun)));
    if (more == "edit") moveTower(city, rounds);
}
