#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "core/city/city.h"
#include "core/receivers/wall_faces.h"

namespace noonmark {

/// A wall next to a place.
struct NearWall {
    std::uint32_t building = 0;  ///< index in City::buildings
    glm::dvec3 foot{};           ///< the place of the wall that is nearest, local metres
    glm::dvec2 normal{};         ///< unit vector, outward
    double distanceM = 0;
};

/// Finds the wall that a place is at. O(points of the parts) to make.
class WallFinder {
public:
    static constexpr double farthestM = 1;  ///< walls farther away are not found

    explicit WallFinder(const City& city);

    /// The nearest wall within farthestM, in front of the place or behind it; none where there is none.
    [[nodiscard]] std::optional<NearWall> nearest(glm::dvec3 place) const;

private:
    struct Wall {
        WallFace face;
        std::uint32_t building;
    };
    void add(WallFace face, std::uint32_t building);

    std::vector<Wall> walls_;
    std::map<std::pair<long, long>, std::vector<std::uint32_t>> squares_;
};

}  // namespace noonmark
