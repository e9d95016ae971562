#pragma once

// The ray reference and everything else that traces rays. RayScene (this file) is the only interface to
// Embree (ray_scene_embree.cpp); it answers occlusion, first-hit and first-occluder queries. ray_reference.h
// is the engine that all others are measured against; surface_rays.h does the same for single points on the
// ground and for points on any surface, and ray_intervals.h for one interval of the direction graph.
// tree_rays.h adds the shade of crowns. visible_surface.h turns a camera's pixels into surface points,
// traced_view.h into a picture's depths and normals.

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/city/trees/tree.h"
#include "core/engines/common/sun_packets.h"

namespace noonmark {

/// The first intersection of a ray with the city.
struct RayHit {
    std::optional<std::uint32_t> building;  ///< index in City::buildings; none for the terrain
    glm::vec3 position;                     ///< local metres
    glm::vec3 normal;                       ///< unit, outward
    float distanceM = 0;
};

/// A building that a ray passes through. Buildings are distinguished by index, so a shared wall or edge gives
/// one hit for each building.
struct Occluder {
    float distanceM = 0;  ///< distance along the ray to the first hit on the building; 0: no occluder
    std::uint32_t building = 0;
};

/// Sixteen neighbouring rays and their first hits, as a structure of arrays.
struct alignas(64) HitPacket {
    static constexpr std::size_t lanes = 16;
    static constexpr std::uint32_t terrain = std::numeric_limits<std::uint32_t>::max() - 1;
    static constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();
    using Lanes = std::array<float, lanes>;
    Lanes originX, originY, originZ;           ///< local metres
    Lanes directionX, directionY, directionZ;  ///< of any length; distances count in lengths of the direction
    Lanes from;                                ///< nearest hit that counts, at least 0
    Lanes distance;                            ///< before: farthest hit that counts; after: of the hit
    Lanes normalX, normalY, normalZ;           ///< after: outward, not normalised
    std::array<std::uint32_t, lanes> hit;      ///< after: index in City::buildings, terrain or nothing
};

/// A crown or a trunk in a scene of them.
struct GroupedCrown {
    Crown crown;
    std::uint32_t group = 0;  ///< which hits report, as they do a building
};

/// A city prepared for ray queries: a bounding volume hierarchy over the triangles of buildings and terrain.
/// Flat ground is not included. Immutable and cheap to copy; queries may run on several threads at the same
/// time.
///
/// Coordinates are float32, in metres from the city's origin. If the centre of the buildings is more than 4
/// km away, coordinates are stored relative to that centre, so they stay as precise as the city's own: 4 mm
/// at 60 km.
///
/// Contacts: adjacent triangles leave no gap, nor do two buildings that share a wall. Rays begin
/// `wallOffsetM` east and north of the given origin; otherwise, for origins in the plane of a wall, rounding
/// would decide. Surfaces within `nearestM` of the origin are ignored: a ray that starts on a wall and leaves
/// the building is unobstructed, one that starts on a wall and enters the building is blocked where it exits.
class RayScene {
public:
    static constexpr float nearestM = 0.0001F;  ///< distance from the origin at which rays begin, metres
    /// Metres, or at least the spacing of float32 values at the coordinate. Wider than Embree's tolerance for
    /// triangles up to 500 m.
    static constexpr float wallOffsetM = 0x1p-14F;

    /// All buildings. Error if memory runs out; cancelled() soon after a stop request. About 0.5 s for 1.5
    /// million triangles.
    static Result<RayScene> over(const City& city, std::stop_token stop = {});
    /// Only the buildings with these indices; hits report the city's indices.
    static Result<RayScene> over(const City& city, std::span<const std::uint32_t> buildings,
                                 std::stop_token stop = {});

    /// Crowns instead of buildings, as exact bodies: rays meet them where they enter. Error and cancelled()
    /// as above.
    static Result<RayScene> over(std::vector<GroupedCrown> crowns, std::stop_token stop = {});

    /// Whether the ray hits anything. `direction` need not have unit length. Some 0.1 us.
    [[nodiscard]] bool occluded(glm::vec3 origin, glm::vec3 direction) const;

    /// The same for many origins and a shared set of directions: bit k of blocked[i] is set if direction k is
    /// blocked as seen from origins[i]. Both spans have the same size. The fastest query, in particular for
    /// neighbouring origins.
    void blockedLanes(std::span<const glm::vec3> origins, const DirectionPacket& directions,
                      std::span<std::uint32_t> blocked) const;

    [[nodiscard]] std::optional<RayHit> firstHit(glm::vec3 origin, glm::vec3 direction) const;

    /// The first hits of 16 neighbouring rays, from exactly the given origins. Rays whose `distance` is less
    /// than `from` hit nothing. Some 0.02 to 0.04 us per ray.
    /// `groups`: one entry a group of crowns, 1: its crowns are met; empty: all are.
    void firstHits(HitPacket& packet, std::span<const std::uint8_t> groups = {}) const;
    /// Which of 16 neighbouring rays hit anything between `from` and `distance`: bit k for ray k. Some 0.01
    /// to 0.03 us per ray.
    [[nodiscard]] std::uint32_t findBlocked(const HitPacket& packet,
                                            std::span<const std::uint8_t> groups = {}) const;

    /// The first `levels` buildings (1 to maxLevels) on up to 16 neighbouring rays of one direction (unit
    /// length), nearest first, without hits nearer than `nearestHitM`: occluders[ray * levels + k], with
    /// distance 0 after the last one. Terrain is ignored. Some 0.1 to 0.4 us per ray.
    void firstOccluders(std::span<const glm::vec3> origins, glm::vec3 direction, float nearestHitM,
                        int levels, std::span<Occluder> occluders) const;
    static constexpr int maxLevels = 8;

    [[nodiscard]] std::size_t triangleCount() const;

    /// Name and version of the ray tracing library: "Embree 3.13.5".
    static std::string backend();

private:
    struct Tree;
    explicit RayScene(std::shared_ptr<const Tree> tree);
    std::shared_ptr<const Tree> tree_;
};

}  // namespace noonmark
