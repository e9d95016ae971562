#include "core/study/settle_point.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/city/city_observer.h"
#include "core/receivers/points/solid_parts.h"

namespace noonmark {

namespace {

bool touches(const Part& part, glm::dvec2 place) {
    const Box2 box = bounds(part.footprint);
    return place.x >= double(box.low.x) && place.x <= double(box.high.x) && place.y >= double(box.low.y) &&
           place.y <= double(box.high.y) && contains(part.footprint, place);
}

// The highest surface of a mesh above a place; none where it has none.
std::optional<double> topOf(const TriangleMesh& mesh, glm::dvec2 place) {
    std::optional<double> top;
    for (const glm::uvec3 t : mesh.triangles) {
        const glm::dvec3 a(mesh.vertices[t.x]), b(mesh.vertices[t.y]), c(mesh.vertices[t.z]);
        const glm::dvec2 ab(b - a), ac(c - a), ap = place - glm::dvec2(a);
        const double turn = ab.x * ac.y - ab.y * ac.x;
        if (std::abs(turn) < 1e-9) continue;
        const double u = (ap.x * ac.y - ap.y * ac.x) / turn, v = (ab.x * ap.y - ab.y * ap.x) / turn;
        if (u < 0 || v < 0 || u + v > 1) continue;
        top = std::max(top.value_or(-1e30), a.z + u * (b.z - a.z) + v * (c.z - a.z));
    }
    return top;
}

/// The building whose roof is highest above a place.
struct RoofAbove {
    double topM = -1e30;
    const Building* building = nullptr;
};

RoofAbove findRoof(const City& city, glm::dvec2 place) {
    RoofAbove roof;
    for (const auto& building : city.buildings)
        for (const Part& part : building->parts) {
            if (part.isOverhanging || !touches(part, place)) continue;
            const double top = part.mesh ? topOf(*part.mesh, place).value_or(-1e30) : double(part.topM);
            if (top > roof.topM) roof = {top, building.get()};
        }
    return roof;
}

glm::vec3 normalOf(const PointQuestion& question, const Observer& observer) {
    if (!question.facingDeg) return {0, 0, 1};
    const glm::dvec3 local = observer.frameFromPlace * toDirection({*question.facingDeg}, {0});
    return glm::vec3(glm::normalize(glm::dvec3(local.x, local.y, 0)));
}

std::string nameOf(const Building& building) {
    return building.name.empty() ? building.sourceId : building.name;
}

// The overhang that a place is in; null: none.
const Building* findOverhangAt(const City& city, glm::dvec3 place) {
    for (const auto& building : city.buildings)
        for (const Part& part : building->parts)
            if (part.isOverhanging && touches(part, glm::dvec2(place)) && isInside(part, place))
                return building.get();
    return nullptr;
}

}  // namespace

Result<SettledPoint> settlePoint(const City& city, const PointQuestion& question) {
    const glm::dvec2 place = city.frame.localFromLonLat(question.at);
    const Observer observer = placeObserver(city, place);
    const double ground = double(groundAt(city, place));
    const RoofAbove roof = findRoof(city, place);
    double height = ground + question.heightM.value_or(0);
    const bool onRoof = roof.building != nullptr && (!question.heightM || height >= roof.topM - 0.05);
    if (onRoof) height = std::max(height, roof.topM);
    if (roof.building != nullptr && !onRoof)
        return failure(
            fmt::format("The point is inside the building {}", nameOf(*roof.building)),
            fmt::format("{:.6f},{:.6f}", question.at.lonDeg, question.at.latDeg),
            fmt::format("Choose a point in front of its wall, or {:.1f} m or more above the ground",
                        roof.topM - ground));
    if (const Building* overhang = findOverhangAt(city, {place, height}))
        return failure(fmt::format("The point is inside an overhang of the building {}", nameOf(*overhang)),
                       fmt::format("{:.6f},{:.6f}", question.at.lonDeg, question.at.latDeg),
                       "Choose a height below it or above it");
    return SettledPoint{{glm::vec3(glm::dvec3(place, height)), normalOf(question, observer)}, onRoof};
}

}  // namespace noonmark
