#pragma once

#include <cmath>
#include <random>
#include <utility>

#include "tests/core/engines/scenes.h"

namespace noonmark::tests {

/// Square terrain around the origin, with elevation as a function of position.
template <class Elevation>
std::shared_ptr<const Terrain> terrainOf(int side, double cellM, Elevation elevation) {
    Terrain terrain{{-side * cellM / 2, -side * cellM / 2, cellM, side, side}, {}};
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            terrain.elevationM.push_back(float(elevation(terrain.grid.centre(column, row))));
    return std::make_shared<const Terrain>(std::move(terrain));
}

/// A city on terrain with 10 m cells.
template <class Elevation>
City groundOf(int side, Elevation elevation) {
    City city;
    city.terrain = terrainOf(side, 10, std::move(elevation));
    return city;
}

/// Hills of several sizes, some 25 m from the lowest to the highest point, with 10 cm of roughness.
class RandomHills {
public:
    explicit RandomHills(std::uint32_t seed) : random_(seed) {
        for (Wave& wave : waves_) {
            const double length = std::uniform_real_distribution<double>(25, 200)(random_),
                         turn = std::uniform_real_distribution<double>(0, 2 * std::numbers::pi)(random_);
            wave = {2 * std::numbers::pi / length * std::cos(turn),
                    2 * std::numbers::pi / length * std::sin(turn), turn * 3, length / 40};
        }
    }
    double operator()(glm::dvec2 place) {
        double sum = std::uniform_real_distribution<double>(0, 0.1)(random_);
        for (const Wave& wave : waves_)
            sum += wave.high * std::sin(wave.x * place.x + wave.y * place.y + wave.at);
        return sum;
    }

private:
    struct Wave {
        double x, y, at, high;
    };
    std::mt19937 random_;
    Wave waves_[6];
};

/// A box on uneven ground, from below its lowest corner to `heightM` above that corner.
inline std::shared_ptr<const Building> standingBox(const City& city, float west, float south, float east,
                                                   float north, float heightM) {
    float lowest = 1e30F;
    for (float x = west; x <= east; x += (east - west) / 8)
        for (float y = south; y <= north; y += (north - south) / 8)
            lowest = std::min(lowest, groundAt(city, {double(x), double(y)}));
    return buildingOf({rectangle(west, south, east, north), {}}, lowest - 1, lowest + heightM);
}

/// Adds the boxes of randomBoxes() on the ground of a city.
inline void addStandingBoxes(City& city, std::uint32_t seed, int perSide, double offsetM) {
    for (const Box3& box : randomBoxes(seed, perSide))
        city.buildings.push_back(standingBox(city, float(box.low.x + offsetM), float(box.low.y + offsetM),
                                             float(box.high.x + offsetM), float(box.high.y + offsetM),
                                             float(box.high.z - box.low.z)));
}

/// A house with a gabled roof along its longer side, as a closed mesh that stands on the ground at z =
/// `groundM`.
inline std::shared_ptr<const Building> gabledHouse(float west, float south, float east, float north,
                                                   float eavesM, float ridgeM, float groundM = 0) {
    const bool alongX = east - west > north - south;
    const glm::vec3 a = alongX ? glm::vec3{west, (south + north) / 2, groundM + ridgeM}
                               : glm::vec3{(west + east) / 2, south, groundM + ridgeM},
                    b = alongX ? glm::vec3{east, (south + north) / 2, groundM + ridgeM}
                               : glm::vec3{(west + east) / 2, north, groundM + ridgeM};
    const float eaves = groundM + eavesM;
    std::vector<glm::vec3> points{{west, south, groundM},
                                  {east, south, groundM},
                                  {east, north, groundM},
                                  {west, north, groundM},
                                  {west, south, eaves},
                                  {east, south, eaves},
                                  {east, north, eaves},
                                  {west, north, eaves},
                                  a,
                                  b};
    std::vector<glm::uvec3> triangles{{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {1, 2, 6},
                                      {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
    const auto roof =
        alongX ? std::vector<glm::uvec3>{{4, 5, 9}, {4, 9, 8}, {6, 7, 8}, {6, 8, 9}, {5, 6, 9}, {7, 4, 8}}
               : std::vector<glm::uvec3>{{5, 6, 9}, {5, 9, 8}, {7, 4, 8}, {7, 8, 9}, {4, 5, 8}, {6, 7, 9}};
    triangles.insert(triangles.end(), roof.begin(), roof.end());
    Part part{
        .footprint = {rectangle(west, south, east, north), {}}, .bottomM = groundM, .topM = groundM + ridgeM};
    part.mesh = std::make_shared<const TriangleMesh>(TriangleMesh{std::move(points), std::move(triangles)});
    return std::make_shared<const Building>(Building{.parts = {std::move(part)}});
}

/// Differences from the ray reference, in percent of the period.
struct Errors {
    double mean = 0, max = 0, meanContinuous = 0;
};

inline Errors errorsOf(const ShadowField& field, const ShadowField& truth, const Receivers& receivers) {
    Errors errors;
    const double whole = truth.sunlitMinutesPerDay / 100;
    for (const std::uint32_t cell : receivers.cells) {
        const double error = std::abs(double(field.grossMin[cell] - truth.grossMin[cell])) / whole;
        errors.mean += error / double(receivers.cells.size());
        errors.max = std::max(errors.max, error);
        errors.meanContinuous += std::abs(double(field.continuousMin[cell] - truth.continuousMin[cell])) /
                                 whole / double(receivers.cells.size());
    }
    return errors;
}

}  // namespace noonmark::tests
