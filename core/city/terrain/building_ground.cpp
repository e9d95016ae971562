#include "core/city/terrain/building_ground.h"

#include <algorithm>
#include <optional>

#include "core/city/meshes/mesh_outline.h"
#include "core/city/meshes/mesh_parts.h"

namespace noonmark {

float findGroundUnder(const Building& building, const City& city) {
    std::optional<float> lowest;
    for (const Part& part : building.parts)
        if (!part.isOverhanging) lowest = std::min(lowest.value_or(part.bottomM), part.bottomM);
    if (lowest) {  // the lowest volume of a tower may be a twisted one, which counts as an overhang
        for (const Part& part : building.parts)
            if (part.bottomM < *lowest && !part.footprint.outer.empty() &&
                reachesGround(part, groundAt(city, glm::dvec2(part.footprint.outer.front()))))
                lowest = part.bottomM;
        return *lowest;
    }
    const Box2 box = bounds(building);
    return groundAt(city, glm::dvec2(box.low + box.high) / 2.0);
}

float heightM(const Building& building, const City& city) {
    return topM(building) - findGroundUnder(building, city);
}

namespace {

constexpr float nearGroundM = 0.5F;

// A downward face runs clockwise in plan.
void addIfUnderside(const TriangleMesh& mesh, glm::uvec3 triangle, float highestM,
                    std::vector<Footprint>& contact) {
    const glm::vec3 a = mesh.vertices[triangle.x], b = mesh.vertices[triangle.y],
                    c = mesh.vertices[triangle.z];
    if (std::max({a.z, b.z, c.z}) > highestM) return;
    Ring ring{{c.x, c.y}, {b.x, b.y}, {a.x, a.y}};
    if (signedArea(ring) > 0) contact.push_back({std::move(ring), {}});
}

}  // namespace

bool reachesGround(const Part& part, float groundM) {
    return !part.isOverhanging || (part.mesh != nullptr && part.bottomM <= groundM + nearGroundM);
}

std::vector<Footprint> findGroundContact(const Part& part, float groundM) {
    if (!part.isOverhanging) return {part.footprint};
    if (!reachesGround(part, groundM)) return {};
    const float highestM = groundM + nearGroundM;
    std::vector<Footprint> contact;
    for (const glm::uvec3 triangle : part.mesh->triangles)
        addIfUnderside(*part.mesh, triangle, highestM, contact);
    if (!contact.empty()) return contact;
    contact = findEnclosedByWalls(*part.mesh, openAirM);
    if (!contact.empty()) return contact;
    const double walled = computeWalledShare(*part.mesh, part.footprint, openAirM);
    if (walled > 0 && walled < walledEnough) return {};
    return {part.footprint};
}

}  // namespace noonmark
