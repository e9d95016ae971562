#include "core/accumulate/projected/shadow_casters.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>

#include "core/accumulate/projected/cell_coordinates.h"
#include "core/accumulate/ray_reference.h"
#include "core/city/mesh_topology.h"
#include "core/city/triangulate.h"

namespace noonmark {

namespace {

using Kind = ShadowCaster::Kind;

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

bool isConvex(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 a(ring[i]), b(ring[(i + 1) % ring.size()]), c(ring[(i + 2) % ring.size()]);
        if (cross(b - a, c - b) < 0) return false;
    }
    // A ring may turn left all the way and still wind twice; repaired footprints do not.
    return true;
}

class CasterBuilder {
public:
    CasterBuilder(const City& city, const Grid& grid) : city_(city), grid_(grid) {}

    void addBuilding(std::uint32_t building) {
        building_ = building;
        for (const Part& part : city_.buildings[building]->parts) addPart(part);
    }

    // What throws most comes first: much of the rest falls where it is dark already.
    ShadowCasters take() {
        std::ranges::stable_sort(result_.casters, std::greater{}, [](const ShadowCaster& caster) {
            const glm::dvec2 size = caster.high - caster.low;
            return (size.x + size.y) * double(caster.topM - caster.bottomM);
        });
        return std::move(result_);
    }

private:
    void addPart(const Part& part) {
        if (part.mesh)
            addFaces(*part.mesh);
        else if (part.topM <= 0)
            return;
        else if (part.footprint.holes.empty() && isConvex(part.footprint.outer))
            addRing(Kind::prism, part, part.footprint.outer);
        else
            addWallsAndUnderside(part);
    }

    void addWallsAndUnderside(const Part& part) {
        addWalls(part, part.footprint.outer);
        for (const Ring& hole : part.footprint.holes) addWalls(part, hole);
        if (part.bottomM <= 0) return;
        const Triangulation under = triangulated(part.footprint);
        for (const glm::uvec3 t : under.triangles)
            addRing(Kind::flat, part, {under.points[t.x], under.points[t.y], under.points[t.z]});
    }

    void addWalls(const Part& part, const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i)
            addRing(Kind::wall, part, {ring[i], ring[(i + 1) % ring.size()]});
    }

    void addFaces(const TriangleMesh& mesh) {
        const bool open = openEdges(mesh) > 0;
        for (const glm::uvec3 t : mesh.triangles) {
            const glm::vec3 a = mesh.vertices[t.x], b = mesh.vertices[t.y], c = mesh.vertices[t.z];
            ShadowCaster& caster = add(Kind::face, {glm::vec2(a), glm::vec2(b), glm::vec2(c)});
            caster.heights = {seen(a.z), seen(b.z), seen(c.z)};
            caster.topM = seen(std::max({a.z, b.z, c.z}));
            caster.twoSided = open;
        }
    }

    void addRing(Kind kind, const Part& part, const Ring& ring) {
        ShadowCaster& caster = add(kind, ring);
        caster.bottomM = seen(part.bottomM);
        caster.topM = kind == Kind::flat ? caster.bottomM : seen(part.topM);
    }

    // A receiver stands where its rays begin: a little above the ground, a little east and north of its
    // place.
    static float seen(float heightM) { return std::max(0.0F, heightM - RayReferenceSettings::liftM); }

    ShadowCaster& add(Kind kind, const Ring& ring) {
        ShadowCaster caster{.kind = kind,
                            .firstPoint = std::uint32_t(result_.points.size()),
                            .pointCount = std::uint32_t(ring.size()),
                            .building = building_};
        caster.low = glm::dvec2(1e30);
        caster.high = glm::dvec2(-1e30);
        for (const glm::vec2 point : ring) {
            const glm::dvec2 cells =
                cellsFromLocal(grid_, glm::dvec2(point) - double(RayReferenceSettings::asideM));
            result_.points.push_back(cells);
            caster.low = glm::min(caster.low, cells);
            caster.high = glm::max(caster.high, cells);
        }
        result_.casters.push_back(caster);
        return result_.casters.back();
    }

    const City& city_;
    const Grid& grid_;
    std::uint32_t building_ = 0;
    ShadowCasters result_;
};

// The hull of a convex polygon at two places: the edges that face the way it moves are taken at the far
// place, the others at the near.
void sweep(std::span<const glm::dvec2> ring, glm::dvec2 near, glm::dvec2 far,
           std::vector<glm::dvec2>& polygon) {
    const glm::dvec2 move = far - near;
    bool before = cross(move, ring.front() - ring.back()) > 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const bool now = cross(move, ring[i + 1 < ring.size() ? i + 1 : 0] - ring[i]) > 0;
        // Where the side changes the point appears twice, joined by the edge that the corner draws.
        polygon.push_back(ring[i] + (before ? far : near));
        if (now != before) polygon.push_back(ring[i] + (now ? far : near));
        before = now;
    }
}

void sweepWall(std::span<const glm::dvec2> wall, glm::dvec2 near, glm::dvec2 far,
               std::vector<glm::dvec2>& polygon) {
    if (cross(far - near, wall[1] - wall[0]) <= 0)
        return;  // faces the sun: a wall on the other side throws this shadow
    polygon = {wall[0] + near, wall[0] + far, wall[1] + far, wall[1] + near};
}

void project(std::span<const glm::dvec2> face, const ShadowCaster& caster, glm::dvec2 throwCells,
             std::vector<glm::dvec2>& polygon) {
    for (std::size_t i = 0; i < 3; ++i) polygon.push_back(face[i] + throwCells * double(caster.heights[i]));
    const double turn = cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
    if (turn < 0 && caster.twoSided)
        std::swap(polygon[1], polygon[2]);
    else if (turn <= 0)
        polygon.clear();  // seen from behind: a face on the other side throws this shadow
}

}  // namespace

ShadowCasters shadowCasters(const City& city, std::span<const std::uint32_t> buildings, const Grid& grid) {
    CasterBuilder builder(city, grid);
    for (const std::uint32_t building : buildings) builder.addBuilding(building);
    return builder.take();
}

void shadowOf(const ShadowCasters& casters, const ShadowCaster& caster, glm::dvec2 throwCells,
              std::vector<glm::dvec2>& polygon) {
    polygon.clear();
    const auto points = casters.pointsOf(caster);
    const glm::dvec2 near = throwCells * double(caster.bottomM), far = throwCells * double(caster.topM);
    switch (caster.kind) {
        case Kind::prism:
            return sweep(points, near, far, polygon);
        case Kind::wall:
            return sweepWall(points, near, far, polygon);
        case Kind::flat:
            return sweep(points, near, near, polygon);
        case Kind::face:
            return project(points, caster, throwCells, polygon);
    }
}

}  // namespace noonmark
