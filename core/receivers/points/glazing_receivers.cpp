#include "core/receivers/points/glazing_receivers.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <limits>

#include "core/receivers/points/solid_parts.h"

namespace noonmark {

namespace {

constexpr double wallSquareM = 16;
long wallSquareOf(double metres) { return long(std::floor(metres / wallSquareM)); }

// The place of the face's rectangle that is nearest; of a mesh's face, only where the face is.
std::optional<glm::dvec3> footOn(const WallFace& face, glm::dvec3 place) {
    const double along = std::clamp(glm::dot(glm::dvec2(place) - face.start, face.along), 0.0, face.lengthM);
    const double height = std::clamp(place.z, face.lowM, face.highM);
    if (!face.covers({along, height})) return std::nullopt;
    return glm::dvec3(face.start + along * face.along, height);
}

}  // namespace

WallFinder::WallFinder(const City& city) {
    for (std::uint32_t building = 0; building < city.buildings.size(); ++building)
        for (const Part& part : city.buildings[building]->parts)
            for (WallFace& face : findWallFaces(part)) add(std::move(face), building);
}

// In all squares of the box around the wall, as wide as walls are found.
void WallFinder::add(WallFace face, std::uint32_t building) {
    const glm::dvec2 a = face.start, b = face.start + face.lengthM * face.along;
    const glm::dvec2 low = glm::min(a, b) - farthestM, high = glm::max(a, b) + farthestM;
    for (long x = wallSquareOf(low.x); x <= wallSquareOf(high.x); ++x)
        for (long y = wallSquareOf(low.y); y <= wallSquareOf(high.y); ++y)
            squares_[{x, y}].push_back(std::uint32_t(walls_.size()));
    walls_.push_back({std::move(face), building});
}

std::optional<NearWall> WallFinder::nearest(glm::dvec3 place) const {
    std::optional<NearWall> best;
    const auto square = squares_.find({wallSquareOf(place.x), wallSquareOf(place.y)});
    if (square == squares_.end()) return best;
    for (const std::uint32_t index : square->second) {
        const Wall& wall = walls_[index];
        const auto foot = footOn(wall.face, place);
        if (!foot) continue;
        const double distance = glm::length(*foot - place);
        if (distance <= (best ? best->distanceM : farthestM))
            best = NearWall{wall.building, *foot, wall.face.normal(), distance};
    }
    return best;
}

namespace {

constexpr double inFrontM = 0.05;  // where a window needs open air

/// Where a window is and where it faces; no direction: it faces where its wall does.
struct Pane {
    glm::dvec3 middle{};
    std::optional<glm::dvec3> normal;
    double areaM2 = 0;
};

// Twice the area, along the normal of the ring (Newell's formula).
glm::dvec3 doubleArea(const std::vector<glm::dvec3>& ring) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < ring.size(); ++i)
        sum += glm::cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
    return sum;
}

// The centre of the area of a plane ring, which need not be convex.
Pane paneOf(const std::vector<glm::dvec3>& ring) {
    if (ring.size() == 1) return {ring[0], std::nullopt, 0};
    const glm::dvec3 whole = doubleArea(ring);
    const double size = glm::length(whole);
    if (!(size > 0)) return {ring[0], std::nullopt, 0};
    const glm::dvec3 normal = whole / size;
    glm::dvec3 middle(0);
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
        const double part = glm::dot(glm::cross(ring[i] - ring[0], ring[i + 1] - ring[0]), normal) / size;
        middle += part * (ring[0] + ring[i] + ring[i + 1]) / 3.0;
    }
    return {middle, normal, size / 2};
}

class GlazingPlacer {
public:
    GlazingPlacer(const City& city, const Region& region, const GlazingSettings& settings)
        : city_(city), region_(region), settings_(settings), solids_(city), walls_(city) {}

    void add(const GlazingShape& window) {
        Pane pane = paneOf(window.corners);
        if (settings_.aboveGround) pane.middle.z += double(groundAt(city_, glm::dvec2(pane.middle)));
        if (window.corners.size() > 1 && pane.areaM2 < 1e-4)
            return leaveOut(window, WarningKind::dropped, "the window's pane has no area");
        if (!isInRegion(pane.middle))
            return leaveOut(window, WarningKind::leftOut, "the window is outside the region");
        const auto wall = walls_.nearest(pane.middle);
        if (!pane.normal) {
            if (!window.azimuthDeg && !wall)
                return leaveOut(window, WarningKind::dropped,
                                "the window has no azimuth, and no wall is within 1 m of it");
            if (!window.azimuthDeg) moveOnto(*wall, window, pane);
        }
        const auto normal = facing(window, pane, wall);
        if (!normal)
            return leaveOut(window, WarningKind::dropped,
                            "the window is inside a building or below the ground");
        place(window, pane.middle, *normal, wall);
    }

    GlazingPlaced take() { return std::move(placed_); }

private:
    void leaveOut(const GlazingShape& window, WarningKind kind, const char* why) {
        placed_.warnings.push_back({kind, why, window.id});
    }

    // A window in a wall along the region's edge, as around a city, counts: panes lie a little before or
    // behind their wall.
    [[nodiscard]] bool isInRegion(glm::dvec3 place) const {
        constexpr double edgeM = 0.05;
        constexpr glm::dvec2 offsets[]{
            {0, 0}, {edgeM, edgeM}, {edgeM, -edgeM}, {-edgeM, edgeM}, {-edgeM, -edgeM}};
        return std::ranges::any_of(region_.polygons, [&](const Footprint& polygon) {
            return std::ranges::any_of(
                offsets, [&](glm::dvec2 offset) { return contains(polygon, glm::dvec2(place) + offset); });
        });
    }

    void moveOnto(const NearWall& wall, const GlazingShape& window, Pane& pane) {
        if (wall.distanceM > inFrontM)
            placed_.warnings.push_back({WarningKind::assumed,
                                        "the window is off its wall; it was moved onto the nearest wall",
                                        window.id});
        pane.middle = wall.foot;
        pane.normal = glm::dvec3(wall.normal, 0);
    }

    [[nodiscard]] bool isOpen(glm::dvec3 middle, glm::dvec3 normal) const {
        const glm::dvec3 front = middle + inFrontM * normal;
        return front.z > double(groundAt(city_, glm::dvec2(front))) && !solids_.isSolid(front);
    }

    [[nodiscard]] glm::dvec3 towards(double azimuthDeg, glm::dvec3 place) const {
        const double azimuth = Degrees{azimuthDeg}.radians().value;
        const glm::dmat2 turn =
            city_.frame.localFromEastNorth(city_.frame.lonLatFromLocal(glm::dvec2(place)));
        return {glm::normalize(turn * glm::dvec2(std::sin(azimuth), std::cos(azimuth))), 0};
    }

    // A pane may have been drawn from either side: it faces its azimuth, else open air, else as its wall
    // does.
    [[nodiscard]] std::optional<glm::dvec3> facing(const GlazingShape& window, const Pane& pane,
                                                   const std::optional<NearWall>& wall) const {
        glm::dvec3 normal = pane.normal ? *pane.normal : towards(*window.azimuthDeg, pane.middle);
        if (pane.normal && window.azimuthDeg && std::abs(normal.z) < 0.99 &&
            glm::dot(normal, towards(*window.azimuthDeg, pane.middle)) < 0)
            normal = -normal;
        const bool settled = !pane.normal || (window.azimuthDeg && std::abs(normal.z) < 0.99);
        const bool open = isOpen(pane.middle, normal), back = isOpen(pane.middle, -normal);
        if (settled || (open && !back)) return open ? std::optional(normal) : std::nullopt;
        if (!open) return back ? std::optional(-normal) : std::nullopt;
        const glm::dvec3 outward = wall ? glm::dvec3(wall->normal, 0) : glm::dvec3(0, 0, 1);
        return glm::dot(normal, outward) < 0 ? -normal : normal;
    }

    void place(const GlazingShape& window, glm::dvec3 middle, glm::dvec3 normal,
               const std::optional<NearWall>& wall) {
        std::uint32_t building = solids_.buildingAt(middle - 0.3 * normal);
        if (building == SolidParts::none && wall) building = wall->building;
        placed_.receivers.points.positions.emplace_back(middle);
        placed_.receivers.points.normals.emplace_back(normal);
        placed_.receivers.elements.push_back({.id = uniqueId(window.id),
                                              .kind = ElementKind::window,
                                              .building = building,
                                              .floor = window.floor.value_or(floorOf(building, middle))});
        placed_.facts.push_back({sizeOf(window.corners, middle, normal), window.room, window.dwelling});
        placed_.receivers.panes.push_back(placed_.facts.back().pane);
    }

    // Corners may be metres above the ground, which the middle no longer is.
    static PaneSize sizeOf(const std::vector<glm::dvec3>& corners, glm::dvec3 middle, glm::dvec3 normal) {
        PaneSize size;
        if (corners.size() < 3) return size;
        const PaneAxes axes = findPaneAxes(normal);
        const double raised = middle.z - paneOf(corners).middle.z;
        for (const glm::dvec3& corner : corners) {
            const glm::dvec3 offset = corner + glm::dvec3(0, 0, raised) - middle;
            const glm::dvec2 place(glm::dot(offset, axes.along), glm::dot(offset, axes.up));
            size.low = glm::min(size.low, place);
            size.high = glm::max(size.high, place);
        }
        return size;
    }

    [[nodiscard]] std::int32_t floorOf(std::uint32_t building, glm::dvec3 middle) const {
        if (building >= city_.buildings.size()) return 0;
        float lowest = std::numeric_limits<float>::max();
        for (const Part& part : city_.buildings[building]->parts) lowest = std::min(lowest, part.bottomM);
        return std::int32_t(std::floor((middle.z - double(lowest)) / settings_.storeyM));
    }

    std::string uniqueId(const std::string& id) {
        int& uses = uses_[id];
        if (++uses == 1) return id;
        placed_.warnings.push_back(
            {WarningKind::assumed, "the id of the window occurs again; it was numbered", id});
        return fmt::format("{} ({})", id, uses);
    }

    const City& city_;
    const Region& region_;
    const GlazingSettings& settings_;
    SolidParts solids_;
    WallFinder walls_;
    GlazingPlaced placed_;
    std::map<std::string, int> uses_;
};

}  // namespace

GlazingPlaced placeGlazing(const City& city, const Region& region, const std::vector<GlazingShape>& windows,
                           const GlazingSettings& settings, const std::stop_token& stop) {
    GlazingPlacer placer(city, region, settings);
    for (const GlazingShape& window : windows) {
        if (stop.stop_requested()) break;
        placer.add(window);
    }
    return placer.take();
}

}  // namespace noonmark
