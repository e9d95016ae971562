// Projected shadows on one day of 6 h: 800 x 800 m in the middle of a city, by processor time. Where cells
// differ from rays (with "check") each is told with what each engine says.
//
//     projected_bench [FILE or number of buildings] [rounds] [check]
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <vector>

#include "core/accumulate/projected_shadows.h"
#include "core/accumulate/ray_reference.h"
#include "tests/benchmarks/bench_scene.h"

using namespace noonmark;
using namespace noonmark::bench;

namespace {

ShadowField fieldOf(const Accumulator& engine, const City& city, const Receivers& receivers,
                    const SunSteps& sun) {
    NoProgress progress;
    return engine.accumulate(city, receivers, sun, progress, {}).value();
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

void compare(const Receivers& receivers, const ShadowField& field, const ShadowField& truth) {
    std::map<int, int> counts;  // cells by minutes that differ
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
}

}  // namespace

int main(int argc, char** argv) {
    const std::string name = argc > 1 ? argv[1] : "43000";
    const City city = std::filesystem::exists(name)
                          ? cityFrom(name)
                          : taken(gridSample({.buildings = std::stoi(name), .roundness = 7}),
                                  [](City&& made) { return std::move(made); });
    const Receivers receivers = receiversOnGround(city, middleOf(city), {1}).value();
    const SunSteps sun = sunSteps({.zone = "America/New_York"}, {.place = city.frame.origin()}).value();
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
    if (argc > 3) compare(receivers, field, fieldOf(RayReference(), city, receivers, sun));
}
