#include "core/receivers/point_receivers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "core/receivers/wall_faces.h"

namespace noonmark {

namespace {

// The sum over a mesh's faces above a place of 1 for those that face up and -1 for those that face down:
// above 0 inside a closed mesh.
int windingAt(const TriangleMesh& mesh, glm::dvec3 place) {
    int winding = 0;
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a(mesh.vertices[t.x]), b(mesh.vertices[t.y]), c(mesh.vertices[t.z]);
        const glm::dvec2 ab(b - a), ac(c - a), ap(place - a);
        const double turn = ab.x * ac.y - ab.y * ac.x;
        if (std::abs(turn) < 1e-9) continue;
        const double u = (ap.x * ac.y - ap.y * ac.x) / turn, v = (ab.x * ap.y - ab.y * ap.x) / turn;
        if (u < 0 || v < 0 || u + v > 1) continue;
        if (a.z + u * (b.z - a.z) + v * (c.z - a.z) > place.z) winding += turn > 0 ? 1 : -1;
    }
    return winding;
}

bool isInside(const Part& part, glm::dvec3 place) {
    if (place.z < double(part.bottomM) || place.z >= double(part.topM)) return false;
    if (part.mesh) return windingAt(*part.mesh, place) > 0;
    return contains(part.footprint, glm::dvec2(place));
}

/// Finds the parts around a place: all parts of a city, by squares of the plan.
class PartSquares {
public:
    explicit PartSquares(const City& city) {
        for (const auto& building : city.buildings)
            for (const Part& part : building->parts) {
                const Box2 box = bounds(part.footprint);
                for (long x = square(double(box.low.x)); x <= square(double(box.high.x)); ++x)
                    for (long y = square(double(box.low.y)); y <= square(double(box.high.y)); ++y)
                        parts_[{x, y}].push_back({&part, box});
            }
    }

    [[nodiscard]] bool isSolid(glm::dvec3 place) const {
        const auto found = parts_.find({square(place.x), square(place.y)});
        return found != parts_.end() && std::ranges::any_of(found->second, [&](const auto& entry) {
                   const Box2& box = entry.second;
                   return place.x >= double(box.low.x) && place.x <= double(box.high.x) &&
                          place.y >= double(box.low.y) && place.y <= double(box.high.y) &&
                          isInside(*entry.first, place);
               });
    }

private:
    static long square(double metres) { return long(std::floor(metres / 32)); }
    std::map<std::pair<long, long>, std::vector<std::pair<const Part*, Box2>>> parts_;
};

/// Places the receivers of one building after the other.
class FacadePlacer {
public:
    FacadePlacer(const City& city, const FacadeSettings& settings)
        : city_(city), settings_(settings), squares_(city) {}

    void addBuilding(std::uint32_t index) {
        std::vector<WallFace> faces;
        for (const Part& part : city_.buildings[index]->parts)
            for (WallFace& face : findWallFaces(part)) faces.push_back(std::move(face));
        if (faces.empty()) return;
        const double lowest = std::ranges::min_element(faces, {}, &WallFace::lowM)->lowM;
        for (std::size_t wall = 0; wall < faces.size(); ++wall) addWall(faces[wall], lowest, index, wall);
    }

    [[nodiscard]] const PointReceivers& placed() const { return placed_; }
    PointReceivers take() { return std::move(placed_); }

private:
    void addWall(const WallFace& face, double lowest, std::uint32_t building, std::size_t wall) {
        const int bays = std::max(1, int(std::lround(face.lengthM / settings_.bayM)));
        const double first = lowest + settings_.aboveFloorM;
        const int floor = std::max(0, int(std::ceil((face.lowM - first) / settings_.storeyM)));
        for (int storey = floor; first + storey * settings_.storeyM < face.highM; ++storey)
            for (int bay = 0; bay < bays; ++bay) {
                const glm::dvec2 place{(bay + 0.5) * face.lengthM / bays, first + storey * settings_.storeyM};
                if (face.covers(place) && isOpen(face, place))
                    addPoint(face, place,
                             {.id = idOf(building, wall, storey, bay),
                              .kind = ElementKind::facade,
                              .building = building,
                              .floor = storey});
            }
    }

    [[nodiscard]] bool isOpen(const WallFace& face, glm::dvec2 place) const {
        constexpr double inFrontM = 0.05;
        const glm::dvec2 front = face.start + place.x * face.along + inFrontM * face.normal();
        return place.y > double(groundAt(city_, front)) && !squares_.isSolid({front, place.y});
    }

    void addPoint(const WallFace& face, glm::dvec2 place, PointElement element) {
        placed_.points.positions.emplace_back(glm::dvec3(face.start + place.x * face.along, place.y));
        placed_.points.normals.emplace_back(glm::dvec3(face.normal(), 0));
        placed_.elements.push_back(std::move(element));
    }

    [[nodiscard]] std::string idOf(std::uint32_t building, std::size_t wall, int storey, int bay) const {
        return fmt::format("{} wall {} floor {} bay {}", city_.buildings[building]->sourceId, wall, storey,
                           bay);
    }

    const City& city_;
    const FacadeSettings& settings_;
    PartSquares squares_;
    PointReceivers placed_;
};

Result<void> checkFacades(const FacadeSettings& settings) {
    const auto inRange = [](double metres) { return metres >= 0.25 && metres <= 50; };
    if (!inRange(settings.bayM) || !inRange(settings.storeyM))
        return failure("The bays or storeys of facades are out of range", "facades", "Give 0.25 to 50 m");
    if (!(settings.aboveFloorM >= 0 && settings.aboveFloorM <= settings.storeyM))
        return failure("The receivers of facades are not within their storey", "facades",
                       "Give a height above the floor from 0 to the height of a storey");
    return {};
}

}  // namespace

Result<PointReceivers> placeOnFacades(const City& city, std::span<const std::uint32_t> buildings,
                                      const FacadeSettings& settings, const std::stop_token& stop) {
    if (const auto ok = checkFacades(settings); !ok) return tl::make_unexpected(ok.error());
    FacadePlacer placer(city, settings);
    for (const std::uint32_t building : buildings) {
        if (stop.stop_requested()) return cancelled();
        if (building >= city.buildings.size())
            return failure(fmt::format("There is no building {}", building), "facades",
                           "Choose buildings of the city");
        placer.addBuilding(building);
        if (placer.placed().size() > mostReceivers)
            return failure("There are too many receivers on facades", "facades",
                           "Choose fewer buildings, or wider bays and higher storeys");
    }
    return placer.take();
}

std::vector<std::uint32_t> findBuildingsIn(const City& city, const Region& region) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t index = 0; index < city.buildings.size(); ++index) {
        const Box2 box = bounds(*city.buildings[index]);
        const glm::dvec2 middle = (glm::dvec2(box.low) + glm::dvec2(box.high)) / 2.0;
        if (std::ranges::any_of(region.polygons, [&](const Footprint& p) { return contains(p, middle); }))
            found.push_back(index);
    }
    return found;
}

}  // namespace noonmark
