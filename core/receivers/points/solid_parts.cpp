#include "core/receivers/points/solid_parts.h"

#include <cmath>

#include "core/city/meshes/mesh_sheets.h"

namespace noonmark {

namespace {

constexpr double squareM = 32;
long squareOf(double metres) { return long(std::floor(metres / squareM)); }

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

}  // namespace

bool isInside(const Part& part, glm::dvec3 place) {
    if (place.z < double(part.bottomM) || place.z >= double(part.topM)) return false;
    // Below an overhanging sheet there is air
    if (part.mesh) return windingAt(*part.mesh, place) > 0 && !(part.isOverhanging && isSheet(*part.mesh));
    return contains(part.footprint, glm::dvec2(place));
}

SolidParts::SolidParts(const City& city) {
    for (std::uint32_t building = 0; building < city.buildings.size(); ++building)
        for (const Part& part : city.buildings[building]->parts) {
            const Box2 box = bounds(part.footprint);
            for (long x = squareOf(double(box.low.x)); x <= squareOf(double(box.high.x)); ++x)
                for (long y = squareOf(double(box.low.y)); y <= squareOf(double(box.high.y)); ++y)
                    squares_[{x, y}].push_back({&part, box, building});
        }
}

std::uint32_t SolidParts::buildingAt(glm::dvec3 place) const {
    const auto found = squares_.find({squareOf(place.x), squareOf(place.y)});
    if (found == squares_.end()) return none;
    for (const Entry& entry : found->second) {
        const Box2& box = entry.box;
        if (place.x >= double(box.low.x) && place.x <= double(box.high.x) && place.y >= double(box.low.y) &&
            place.y <= double(box.high.y) && isInside(*entry.part, place))
            return entry.building;
    }
    return none;
}

}  // namespace noonmark
