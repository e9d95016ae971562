#pragma once

#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/city/city.h"
#include "core/city/meshes/mesh_parts.h"

namespace noonmark::tests {

/// A house with walls, a floor and a saddle roof of two sheets that overhang the walls on all sides. The
/// ridge runs along the length, from west to east before the building is turned.
struct EavesHouse {
    glm::dvec2 at{0, 0};  ///< the south-west corner of the walls
    double turnDeg = 0;   ///< counter-clockwise about that corner
    double lengthM = 10, depthM = 8;
    double wallM = 5;    ///< height of the walls under the eaves
    double slope = 0.5;  ///< rise of the roof per metre
    double overhangM = 1;

    [[nodiscard]] double roofAt(double y) const { return wallM + slope * std::min(y, depthM - y); }
    [[nodiscard]] glm::dvec3 inCity(glm::dvec3 own) const {
        const double turn = turnDeg * 0.017453292519943295;
        return {at.x + own.x * std::cos(turn) - own.y * std::sin(turn),
                at.y + own.x * std::sin(turn) + own.y * std::cos(turn), own.z};
    }
};

/// Its convex surfaces, counter-clockwise from outside: the floor, the four walls, the two sheets of the
/// roof.
inline std::vector<std::vector<glm::dvec3>> surfacesOf(const EavesHouse& house) {
    const double l = house.lengthM, d = house.depthM, w = house.wallM, o = house.overhangM, m = d / 2;
    const double low = house.roofAt(-o), ridge = house.roofAt(m);
    std::vector<std::vector<glm::dvec3>> surfaces{
        {{0, 0, 0}, {0, d, 0}, {l, d, 0}, {l, 0, 0}},
        {{0, 0, 0}, {l, 0, 0}, {l, 0, w}, {0, 0, w}},
        {{l, d, 0}, {0, d, 0}, {0, d, w}, {l, d, w}},
        {{0, d, 0}, {0, 0, 0}, {0, 0, w}, {0, m, ridge}, {0, d, w}},
        {{l, 0, 0}, {l, d, 0}, {l, d, w}, {l, m, ridge}, {l, 0, w}},
        {{-o, -o, low}, {l + o, -o, low}, {l + o, m, ridge}, {-o, m, ridge}},
        {{-o, m, ridge}, {l + o, m, ridge}, {l + o, d + o, low}, {-o, d + o, low}}};
    for (auto& surface : surfaces)
        for (glm::dvec3& corner : surface) corner = house.inCity(corner);
    return surfaces;
}

inline TriangleMesh meshOf(const EavesHouse& house) {
    TriangleMesh mesh;
    for (const auto& surface : surfacesOf(house)) {
        const auto first = std::uint32_t(mesh.vertices.size());
        for (const glm::dvec3 corner : surface) mesh.vertices.emplace_back(corner);
        for (std::uint32_t i = 2; i < surface.size(); ++i)
            mesh.triangles.emplace_back(first, first + i - 1, first + i);
    }
    return mesh;
}

inline City cityOf(const std::vector<EavesHouse>& houses) {
    City city;
    city.frame = Frame({8.5, 47.4});
    for (std::size_t i = 0; i < houses.size(); ++i) {
        const std::string id = "house " + std::to_string(i);
        MeshParts made = partsOf(meshOf(houses[i]), id, id);
        markOverhangs(made.parts, [](glm::dvec2) { return 0.0F; });
        city.buildings.push_back(std::make_shared<const Building>(Building{id, {}, {}, made.parts}));
    }
    return city;
}

/// Whether a ray from the ground outside of an unturned house meets it.
inline bool shades(const EavesHouse& house, glm::dvec2 place, glm::dvec3 sun) {
    const double x = place.x - house.at.x, y = place.y - house.at.y;
    const double l = house.lengthM, d = house.depthM, w = house.wallM, o = house.overhangM, k = house.slope;
    const auto isAt = [&](double t, double west, double east, double south, double north, double topM) {
        const double px = x + t * sun.x, py = y + t * sun.y;
        return t > 0 && px >= west && px <= east && py >= south && py <= north && t * sun.z <= topM;
    };
    const double toSouthRoof = (w + k * y) / (sun.z - k * sun.y);
    const double toNorthRoof = (w + k * (d - y)) / (sun.z + k * sun.y);
    if (isAt(toSouthRoof, -o, l + o, -o, d / 2, 1e9) || isAt(toNorthRoof, -o, l + o, d / 2, d + o, 1e9))
        return true;
    for (const double wallX : {0.0, l}) {
        const double t = (wallX - x) / sun.x;
        if (isAt(t, -1e9, 1e9, 0, d, house.roofAt(y + t * sun.y))) return true;
    }
    for (const double wallY : {0.0, d})
        if (isAt((wallY - y) / sun.y, 0, l, -1e9, 1e9, w)) return true;
    return false;
}

/// Forty-nine houses of all sizes, turned at random, with eaves of half a metre to one and a half.
inline std::vector<EavesHouse> village() {
    std::mt19937 random(16);
    const auto between = [&](double low, double high) {
        return low + (high - low) * double(random()) / 4294967296.0;
    };
    std::vector<EavesHouse> houses;
    for (int row = 0; row < 7; ++row)
        for (int column = 0; column < 7; ++column) {
            EavesHouse house{.at = {24.0 * column, 24.0 * row}};
            house.turnDeg = between(-30, 30);
            house.lengthM = between(8, 14);
            house.depthM = between(6, 10);
            house.wallM = between(4.5, 9);
            house.slope = between(0.2, 1);
            house.overhangM = between(0.5, 1.5);
            houses.push_back(house);
        }
    return houses;
}

}  // namespace noonmark::tests
