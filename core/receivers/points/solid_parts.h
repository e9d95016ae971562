#pragma once

// The folder core/receivers/points places receivers that are points: windows (glazing_receivers.h, which also
// finds the wall that a place is at), planes (plane_points.h) and listed points (point_list.h); facades are
// in core/receivers/point_receivers.h. SolidParts (this file) tells what is inside a building.
// facade_elevations.h has the sides of a building with their windows, for drawing.

#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <utility>
#include <vector>

#include "core/city/city.h"

namespace noonmark {

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
