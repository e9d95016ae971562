#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/common/sun_packets.h"

namespace noonmark {

/// Where a ray first meets the city.
struct RayHit {
    std::optional<std::uint32_t> building;  ///< index in City::buildings; none: the terrain
    glm::vec3 position;                     ///< local metres
    glm::vec3 normal;                       ///< unit, outward
    float distanceM = 0;
};

/// A building on a ray's way. Buildings are told apart by index, so a shared wall or edge is one hit a
/// building.
struct Occluder {
    float distanceM = 0;  ///< along the ray to where it first meets the building; 0 = there is none
    std::uint32_t building = 0;
};

/// A city ready for rays: bounding volumes over every triangle of buildings and terrain. A flat ground is not
/// in it. Immutable; cheap to copy; all queries may run on several threads at a time.
///
/// Coordinates are float32, metres from the city's origin; inside they count from the middle of the buildings
/// where that is more than 4 km away. So far from the origin they are as fine as the city's: 4 mm at 60 km.
///
/// Touching: neighbouring triangles leave no gap, and neither do two buildings that share a wall. Rays begin
/// `asideM` east and north of the origin that is given, or in planes of walls rounding would decide. What
/// lies within `nearestM` of the origin is not seen: a ray that starts on a wall and leaves it is free, one
/// that starts on a wall and enters the building is blocked by what it meets on the way out.
class RayScene {
public:
    static constexpr float nearestM = 0.0001F;  ///< where rays begin, metres from their origin
    /// Metres, or at least one grain of the coordinate. Wider than Embree's tolerance on triangles up to 500
    /// m.
    static constexpr float asideM = 0x1p-14F;

    /// All buildings. Error when memory runs out; cancelled() soon after a stop request. About 0.5 s for 1.5
    /// M triangles.
    static Result<RayScene> over(const City& city, std::stop_token stop = {});
    /// Only the buildings with these indices; hits keep the city's numbering.
    static Result<RayScene> over(const City& city, std::span<const std::uint32_t> buildings,
                                 std::stop_token stop = {});

    /// Whether anything lies on the ray. `direction` need not have unit length. Some 0.1 us.
    [[nodiscard]] bool occluded(glm::vec3 origin, glm::vec3 direction) const;

    /// The same from many origins in the same directions: bit k of blocked[i] is set where direction k is
    /// blocked as seen from origins[i]. Both spans have the same size. The fast way, faster still where
    /// origins are neighbours.
    void blockedLanes(std::span<const glm::vec3> origins, const DirectionPacket& directions,
                      std::span<std::uint32_t> blocked) const;

    [[nodiscard]] std::optional<RayHit> firstHit(glm::vec3 origin, glm::vec3 direction) const;

    /// The first `levels` buildings (1 to maxLevels) on up to 16 neighbouring rays of one direction (unit
    /// length), nearest first, hits nearer than `nearestHitM` left out: occluders[ray * levels + k], distance
    /// 0 from the last on. Terrain is not looked at. Some 0.1 to 0.4 us a ray.
    void firstOccluders(std::span<const glm::vec3> origins, glm::vec3 direction, float nearestHitM,
                        int levels, std::span<Occluder> occluders) const;
    static constexpr int maxLevels = 8;

    [[nodiscard]] std::size_t triangleCount() const;

    /// Name and version of the library at work: "Embree 3.13.5".
    static std::string backend();

private:
    struct Tree;
    explicit RayScene(std::shared_ptr<const Tree> tree);
    std::shared_ptr<const Tree> tree_;
};

}  // namespace noonmark
