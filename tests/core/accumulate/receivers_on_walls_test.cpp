#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/accumulate/engine_list.h"
#include "tests/core/accumulate/scenes.h"

namespace noonmark {
namespace {

using namespace tests;

/// Boxes with walls in whole and half metres, some wall to wall: on a grid of 1 m many receivers stand exactly on one.
std::vector<Box3> boxesOnCellCentres(std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<Box3> boxes;
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 5; ++column) {
            const double west = column * 20 + 0.5, south = row * 20 + 0.5;
            const double wide = random() % 3 == 0 ? 20 : 6 + double(random() % 10);
            boxes.push_back(
                {{west, south, 0}, {west + wide, south + 5 + double(random() % 10), 4 + double(random() % 40)}});
        }
    return boxes;
}

bool isOnAWall(const std::vector<Box3>& boxes, glm::dvec2 place) {
    for (const Box3& box : boxes) {
        const bool within = place.x >= box.low.x && place.x <= box.high.x && place.y >= box.low.y &&
                            place.y <= box.high.y;
        const bool inside = place.x > box.low.x && place.x < box.high.x && place.y > box.low.y &&
                            place.y < box.high.y;
        if (within && !inside) return true;
    }
    return false;
}

TEST(ReceiversOnWalls, areThoseOfTheRaysForEveryEngine) {
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        const std::vector<Box3> boxes = boxesOnCellCentres(seed);
        const City city = cityOf(boxes);
        const Receivers receivers = receiversOver(city, -20, -20, 120, 120);
        const SunSteps sun = oneDay(arc(60, 30 + 10 * seed));
        const ShadowField truth = traced(city, receivers, sun);
        for (const char* engine : {"projected", "horizon"}) {
            NoProgress progress;
            const auto made = makeAccumulator(engine, engine == std::string("horizon") ? EngineSettings{{"bin", 0.1}} : EngineSettings{}, coreEngines());
            const ShadowField field = made.value()->accumulate(city, receivers, sun, progress, {}).value();
            std::size_t walls = 0, off = 0, elsewhere = 0;
            double most = 0;
            for (const std::uint32_t cell : receivers.cells) {
                const bool differs = std::abs(field.grossMin[cell] - truth.grossMin[cell]) > 1e-3F;
                const bool wall = isOnAWall(boxes, glm::dvec2(receivers.position(cell)));
                walls += wall, off += wall && differs, elsewhere += !wall && differs;
                if (wall && differs) {
                    most = std::max(most, double(std::abs(field.grossMin[cell] - truth.grossMin[cell])));
                    if (off <= 6) { const auto p = receivers.position(cell); std::printf("%s seed %u at %g %g: %g, rays %g\n", engine, seed, p.x, p.y, field.grossMin[cell], truth.grossMin[cell]); }
                }
            }
            std::printf("%s: %zu of %zu on walls off, up to %g; elsewhere %zu of %zu\n", engine, off, walls, most, elsewhere, receivers.cells.size());
            EXPECT_GT(walls, 300U);
            EXPECT_EQ(off, 0U) << engine;
        }
    }
}

}  // namespace
}  // namespace noonmark
