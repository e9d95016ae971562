#pragma once

#include <cmath>
#include <random>

#include "tests/core/engines/scenes.h"
#include "tests/core/engines/terrain_scenes.h"

// Random edits of a city, for tests that compare what is cached with a fresh computation.
namespace noonmark::tests {

/// Creates random buildings in or around the region.
class AnyBuilding {
public:
    AnyBuilding(std::mt19937& random, City ground, bool overhanging)
        : random_(random), ground_(std::move(ground)), overhanging_(overhanging) {}

    /// Some are rotated, some not convex, some share walls with others. With overhangs also slabs, towers on
    /// stilts, bridges between two houses of the same building, and general meshes.
    std::shared_ptr<const Building> operator()() {
        const float x = between(-40, 120), y = between(-40, 120);
        const glm::vec2 corner(random_() % 3 == 0 ? std::floor(x) : x, y);
        footM_ = groundAt(ground_, glm::dvec2(corner)) - (ground_.terrain ? 8.0F : 0.0F);
        const std::uint32_t kind = std::uint32_t(random_() % (overhanging_ ? 6 : 2));
        if (kind == 0) return built({part(box(corner, between(3, 25), between(3, 25)), 0, between(2, 80))});
        if (kind == 1) return built({part(turned(corner), 0, between(2, 80))});
        if (kind == 2)
            return built({slab(turned(corner)), slab(box(corner, between(3, 60), between(3, 25)))});
        if (kind == 3) return built({slab(box(corner, between(5, 40), between(5, 40)), 60)});
        return kind == 4 ? bridge(corner) : mesh(corner);
    }

private:
    float between(double low, double high) {
        return float(std::uniform_real_distribution<double>(low, high)(random_));
    }
    static Footprint box(glm::vec2 corner, float a, float b) {
        return {rectangle(corner.x, corner.y, corner.x + a, corner.y + b), {}};
    }
    Footprint turned(glm::vec2 at) {
        const float a = between(3, 25), b = between(3, 25), turn = between(0, 1.5F), c = std::cos(turn),
                    s = std::sin(turn);
        const auto corner = [&](float u, float v) { return at + glm::vec2(c * u - s * v, s * u + c * v); };
        return {{corner(0, 0), corner(a, 0), corner(a, b), corner(a / 2, b / 3), corner(0, b)}, {}};
    }
    Part part(Footprint footprint, float bottomM, float topM, bool isOverhanging = false) const {
        return {.footprint = std::move(footprint),
                .bottomM = footM_ + bottomM,
                .topM = footM_ + topM,
                .isOverhanging = isOverhanging};
    }
    Part slab(Footprint footprint, float maxM = 12) {
        const float bottom = 8 + between(2, 40);
        return part(std::move(footprint), bottom, bottom + between(0.5, maxM), true);
    }
    std::shared_ptr<const Building> bridge(glm::vec2 corner) {
        const float high = between(20, 60);
        return built({part(box(corner, 8, 20), 0, high), part(box(corner + glm::vec2(30, 0), 8, 20), 0, high),
                      part(box(corner + glm::vec2(8, 7), 22, 5), high / 2, high / 2 + 4, true)});
    }
    std::shared_ptr<const Building> mesh(glm::vec2 corner) {
        Part solid = random_() % 2 == 0 ? part(turned(corner), 0, between(2, 60)) : slab(turned(corner));
        solid.mesh = std::make_shared<const TriangleMesh>(meshOf(solid));
        return built({std::move(solid)});
    }
    static std::shared_ptr<const Building> built(std::vector<Part> parts) {
        return std::make_shared<const Building>(Building{.parts = std::move(parts)});
    }

    std::mt19937& random_;
    City ground_;
    bool overhanging_;
    float footM_ = 0;
};

/// Adds, removes, replaces, swaps or doubles a building.
inline void editAnything(City& city, std::mt19937& random, bool overhanging = false) {
    constexpr std::size_t maxBuildings = 40;
    AnyBuilding anyBuilding(random, {.terrain = city.terrain}, overhanging);
    const std::uint32_t kind = std::uint32_t(random() % 4);
    if (kind == 0 || city.buildings.size() < 5) {
        city.buildings.push_back(anyBuilding());
    } else if ((kind == 1 && city.buildings.size() > 12) || city.buildings.size() > maxBuildings) {
        city.buildings.erase(city.buildings.begin() + std::ptrdiff_t(random() % city.buildings.size()));
    } else if (kind == 2) {
        city.buildings[random() % city.buildings.size()] = anyBuilding();
    } else {
        std::swap(city.buildings.front(), city.buildings[random() % city.buildings.size()]);
        city.buildings.push_back(city.buildings[random() % city.buildings.size()]);  // the same one twice
    }
}

}  // namespace noonmark::tests
