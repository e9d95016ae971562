#include "core/lab/inverse/sources/projected_source_finder.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/city/meshes/mesh_topology.h"
#include "core/engines/projected/casters/ring_lines.h"
#include "core/engines/projected/casters/shadow_casters.h"

namespace noonmark {

namespace {

constexpr CellBox everywhere{glm::dvec2(-1e30), glm::dvec2(1e30)};

class FacetBuilder {
public:
    FacetBuilder(const City& city, const Grid& grid, double nearestHitM)
        : city_(city), grid_(grid), nearestHitM_(nearestHitM) {}

    void addBuilding(std::uint32_t building) {
        building_ = building;
        for (const Part& part : city_.buildings[building]->parts) addPart(part);
    }

    SurfaceFacets take() { return std::move(result_); }

private:
    void addPart(const Part& part) {
        if (part.topM <= 0) return;
        if (part.mesh) return addMesh(part);
        fromBehind_ = insideOf(part);
        const double bottom = std::max(0.0F, part.bottomM), top = part.topM;
        addWalls(part.footprint.outer, bottom, top);
        for (const Ring& hole : part.footprint.holes) addWalls(hole, bottom, top);
        addLevel(part.footprint, top, 1);
        if (bottom > 0) addLevel(part.footprint, bottom, -1);
    }

    // A ray hits a closed part from behind first only if it starts inside the part or too close to it.
    [[nodiscard]] CellBox insideOf(const Part& part) const {
        if (double(part.bottomM) > nearestHitM_) return {};
        const Box2 box = bounds(part.footprint);
        const double aside = nearestHitM_ / grid_.cellM + 0.01;
        return {toCells(grid_, glm::dvec2(box.low)) - aside, toCells(grid_, glm::dvec2(box.high)) + aside};
    }

    void addWalls(const Ring& ring, double bottom, double top) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const glm::dvec2 a = place(ring[i]), b = place(ring[(i + 1) % ring.size()]);
            begin({b.y - a.y, a.x - b.x, 0}, {a, bottom}, true);
            addLoop(std::array{glm::dvec3(a, bottom), glm::dvec3(b, bottom), glm::dvec3(b, top),
                               glm::dvec3(a, top)});
        }
    }

    void addLevel(const Footprint& footprint, double z, double up) {
        begin({0, 0, up}, {0, 0, z}, isConvex(footprint));
        addRing(footprint.outer, z);
        for (const Ring& hole : footprint.holes) addRing(hole, z);
    }

    void addRing(const Ring& ring, double z) {
        std::vector<glm::dvec3> loop;
        for (const glm::vec2 point : ring) loop.emplace_back(place(point), z);
        addLoop(loop);
    }

    void addMesh(const Part& part) {
        const TriangleMesh& mesh = *part.mesh;
        fromBehind_ = findOpenEdges(mesh) > 0 ? everywhere : insideOf(part);
        for (const glm::uvec3 t : mesh.triangles) {
            const std::array corners{placed(mesh.vertices[t.x]), placed(mesh.vertices[t.y]),
                                     placed(mesh.vertices[t.z])};
            begin(glm::cross(corners[1] - corners[0], corners[2] - corners[0]), corners[0], true);
            addLoop(corners);
        }
    }

    void begin(glm::dvec3 normal, glm::dvec3 point, bool convex) {
        result_.facets.push_back({.normal = normal,
                                  .offset = glm::dot(normal, point),
                                  .firstEdge = std::uint32_t(result_.edges.size()),
                                  .building = building_,
                                  .convex = convex,
                                  .fromBehind = fromBehind_});
    }

    void addLoop(std::span<const glm::dvec3> loop) {
        for (std::size_t i = 0; i < loop.size(); ++i)
            result_.edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
        result_.facets.back().edgeCount += std::uint32_t(loop.size());
    }

    [[nodiscard]] glm::dvec2 place(glm::vec2 point) const { return toCells(grid_, glm::dvec2(point)); }
    [[nodiscard]] glm::dvec3 placed(glm::vec3 point) const { return {place(glm::vec2(point)), point.z}; }

    const City& city_;
    const Grid& grid_;
    double nearestHitM_;
    std::uint32_t building_ = 0;
    CellBox fromBehind_;
    SurfaceFacets result_;
};

}  // namespace

SurfaceFacets makeSurfaceFacets(const City& city, std::span<const std::uint32_t> buildings, const Grid& grid,
                                double nearestHitM) {
    FacetBuilder builder(city, grid, nearestHitM);
    for (const std::uint32_t building : buildings) builder.addBuilding(building);
    return builder.take();
}

}  // namespace noonmark
