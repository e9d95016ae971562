#pragma once

// The folder core/receivers/points places receivers that are points: windows (glazing_receivers.h, which also
// finds the wall that a place is at), planes and listed points (point_list.h); facades are
// in core/receivers/point_receivers.h. SolidParts (this file) tells what is inside a building.
// facade_elevations.h has the sides of a building with their windows, for drawing.

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <utility>
#include <vector>

#include "core/city/city.h"

namespace noonmark {

/// An upright plane face of a part, outside at its right. In the face's own plane a place is (along, z):
/// metres from `start`, and local z.
struct WallFace {
    glm::dvec2 start{};
    glm::dvec2 along{};  ///< unit vector
    double lengthM = 0;
    double lowM = 0, highM = 0;
    /// The triangles that make up the face; empty: all of its rectangle.
    std::vector<std::array<glm::dvec2, 3>> triangles;

    [[nodiscard]] glm::dvec2 normal() const { return {along.y, -along.x}; }
    [[nodiscard]] bool covers(glm::dvec2 place) const;
};

/// The walls of a prism, or the faces of a mesh within 6 degrees of vertical, joined where they lie in one
/// plane (to about 1 degree and 5 cm). O(n log n).
std::vector<WallFace> findWallFaces(const Part& part);

/// Whether a place is inside a part; on its underside it is, on its top it is not. A mesh must be closed, or
/// stand on the ground; nothing is inside an overhanging sheet.
bool isInside(const Part& part, glm::dvec3 place);

/// Finds the building that is solid at a place, from all parts of a city, by squares of the plan. The city
/// must outlive it. O(parts) to make, O(parts near the place) to ask.
class SolidParts {
public:
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    explicit SolidParts(const City& city);

    /// Index in City::buildings, or none.
    [[nodiscard]] std::uint32_t buildingAt(glm::dvec3 place) const;
    [[nodiscard]] bool isSolid(glm::dvec3 place) const { return buildingAt(place) != none; }

private:
    struct Entry {
        const Part* part;
        Box2 box;
        std::uint32_t building;
    };
    std::map<std::pair<long, long>, std::vector<Entry>> squares_;
};

}  // namespace noonmark
