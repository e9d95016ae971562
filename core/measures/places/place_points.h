#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/ray/ray_scene.h"
#include "core/measures/places/place_cells.h"
#include "core/measures/places/place_receivers.h"

namespace noonmark {

/// Points of a square grid around some middles.
struct PointGrid {
    double reachM = 0;    ///< at most so far west, east, south and north of a middle
    double spacingM = 0;  ///< of the grid; points are in the middle of its squares
};

/// The shadow at single points of places: between the centres of cells, and on the strips of open ground that
/// no centre lies on. Rays tell it, from the same origins as those of the ray reference. Safe to use from
/// many threads. Cities must outlive it.
class PlacePoints {
public:
    /// `cities`: baseline, scenario, and, if there is a third, the bare ground whose own shadow does not
    /// count. `places` and `receivers` as of placeReceiversOnPlaces() for these cities; `planeZ`: local z of
    /// all points where they are measured on a plane, else they are on the ground. A scene for each city, of
    /// the buildings in reach: some 0.5 s for Midtown. Error: memory, or cancelled().
    static Result<PlacePoints> over(std::span<const City* const> cities, std::span<const Place> places,
                                    const PlaceReceivers& receivers, std::optional<float> planeZ,
                                    const SunSteps& sun, const std::stop_token& stop = {});

    /// The centre of the cell that has this bit in the place's masks.
    [[nodiscard]] glm::dvec2 centreOf(std::size_t place, std::size_t cell) const;
    /// Points around the middles, each once, that lie in the place and on open ground in both cities.
    [[nodiscard]] std::vector<glm::dvec2> around(std::size_t place, std::span<const glm::dvec2> middles,
                                                 const PointGrid& grid) const;
    /// The shadow at these points on the day of `day`; bit i of the masks is points[i].
    [[nodiscard]] PlaceShadow shade(std::span<const glm::dvec2> points, const PlaceShadow& day) const;
    [[nodiscard]] double cellM() const { return receivers_->receivers.grid.cellM; }

private:
    PlacePoints() = default;
    [[nodiscard]] bool isOpen(std::size_t place, glm::dvec2 point) const;
    [[nodiscard]] glm::vec3 originAt(glm::dvec2 point) const;

    const City* ground_ = nullptr;
    std::span<const Place> places_;
    const PlaceReceivers* receivers_ = nullptr;
    std::optional<float> planeZ_;
    std::vector<std::vector<Footprint>> built_;  // by place: findBuiltGround()
    std::vector<RayScene> scenes_;               // by city
};

}  // namespace noonmark
