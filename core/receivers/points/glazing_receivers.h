#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/base/warnings.h"
#include "core/city/building_heights.h"
#include "core/city/city.h"
#include "core/receivers/point_receivers.h"
#include "core/receivers/points/glazing_pane.h"
#include "core/receivers/points/solid_parts.h"
#include "core/receivers/receivers.h"

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

/// A window as a file states it.
struct GlazingShape {
    std::string id;
    std::vector<glm::dvec3> corners;   ///< local metres; one: a point; three or more: the ring of the pane
    std::optional<double> azimuthDeg;  ///< that it faces, from true north, clockwise
    std::optional<std::int32_t> floor;
    std::string room{}, dwelling{};  ///< names; empty: not stated
};

struct GlazingSettings {
    double storeyM = defaultStoreyM;  ///< height of a storey, to number the floors of windows that state none
    bool aboveGround = false;         ///< heights are metres above the ground below the window
};

struct GlazingPlaced {
    PointReceivers receivers;
    std::vector<GlazingFacts> facts;  ///< of the receivers
    Warnings warnings;  ///< one for each window that was left out, and where something was assumed
};

/// A receiver in the middle of each window in the region, with the building and the floor that it belongs to.
/// A pane faces where its azimuth says, else away from the building; a point faces where its azimuth says,
/// else as the nearest wall within 1 m, onto which it is moved. Left out with a warning: panes without an
/// area, points at no wall that state no azimuth, what is outside the region, below the ground, or inside a
/// building (5 cm in front of it is solid). Ids that occur twice get a number. Floors are counted in storeys
/// from the lowest point of the building. Some 2 us a window, after 0.1 s for the walls of 10,000 buildings.
GlazingPlaced placeGlazing(const City& city, const Region& region, const std::vector<GlazingShape>& windows,
                           const GlazingSettings& settings, const std::stop_token& stop = {});

}  // namespace noonmark
