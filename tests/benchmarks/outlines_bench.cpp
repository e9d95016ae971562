// Outlines of the shadows of a square kilometre in the middle of a city, of the baseline and with a tower of
// 300 m in the middle, for several positions of the sun.
//
//     outlines_bench FILE.osm.pbf
#include <fmt/format.h>

#include "core/measures/shadow_outlines.h"
#include "tests/benchmarks/bench_scene.h"
#include "tests/core/engines/scenes.h"

using namespace noonmark;
using namespace noonmark::bench;

namespace {

std::size_t pointsOf(const std::vector<Footprint>& polygons) {
    std::size_t points = 0;
    for (const Footprint& polygon : polygons) {
        points += polygon.outer.size();
        for (const Ring& hole : polygon.holes) points += hole.size();
    }
    return points;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) return 1;
    const City before = cityFrom(argv[1]);
    const glm::vec2 middle = [&] {
        const Box2 box = bounds(findMiddle(before));
        return (box.low + box.high) / 2.0F;
    }();
    City after = before;
    after.buildings.push_back(tests::buildingOf(
        {tests::rectangle(middle.x - 20, middle.y - 20, middle.x + 20, middle.y + 20), {}}, 0, 300));
    const Box2 area{middle - 500.0F, middle + 500.0F};
    fmt::print("{} buildings\n", before.buildings.size());
    for (const tests::Sun sun : {tests::Sun{180, 72}, {180, 45}, {135, 30}, {235, 15}, {125, 5}}) {
        const SunStep step = tests::oneDay({sun}).steps.front();
        NoProgress quiet;
        ShadowOutlines outlines;
        Seconds seconds;
        for (int round = 0; round < 3; ++round)
            seconds.keepBest(secondsOf(
                [&] { outlines = outlineShadows(before, &after, step, {area}, quiet, {}).value(); }));
        fmt::print(
            "sun at {:3.0f}, {:2.0f} deg: {:5.2f} s wall, {:5.2f} s processor; {:7.0f} m2 in {} polygons of "
            "{} "
            "points, incremental {:6.0f} m2\n",
            sun.azimuthDeg, sun.altitudeDeg, seconds.wall, seconds.processor,
            noonmark::area(outlines.baseline), outlines.baseline.size(), pointsOf(outlines.baseline),
            noonmark::area(outlines.incremental));
    }
    return 0;
}
