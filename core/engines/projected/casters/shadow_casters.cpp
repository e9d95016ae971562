#include "core/engines/projected/casters/shadow_casters.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <numeric>

#include "core/city/footprints/triangulate.h"
#include "core/city/meshes/mesh_topology.h"
#include "core/engines/ray/ray_reference.h"
#include "core/engines/ray/ray_scene.h"

namespace noonmark {

namespace {

// Positive if the path from a through b to c turns left.
double turn(glm::vec2 a, glm::vec2 b, glm::vec2 c) {
    const glm::dvec2 u = glm::dvec2(b) - glm::dvec2(a), v = glm::dvec2(c) - glm::dvec2(b);
    return u.x * v.y - u.y * v.x;
}

/// Cuts one ring into pieces, from point to point.
class RingCutter {
public:
    RingCutter(const Ring& ring, const Ring& obstacles, std::size_t maxPoints)
        : ring_(ring), obstacles_(obstacles), maxPoints_(maxPoints) {}

    void cut(std::vector<Ring>& pieces) {
        const std::size_t start = firstPoint();
        for (std::size_t at = 0; at < ring_.size();) {
            const std::size_t edges = std::min(edgesFrom(start + at), ring_.size() - at);
            Ring& piece = pieces.emplace_back();
            for (std::size_t i = 0; i <= edges; ++i) piece.push_back(point(start + at + i));
            at += edges;
        }
    }

private:
    [[nodiscard]] glm::vec2 point(std::size_t i) const { return ring_[i % ring_.size()]; }

    // A piece ends where the ring turns right. Starting at such a point avoids splitting a piece at the
    // start.
    [[nodiscard]] std::size_t firstPoint() const {
        for (std::size_t i = 0; i < ring_.size(); ++i)
            if (turn(point(i + ring_.size() - 1), point(i), point(i + 1)) < 0) return i;
        return 0;
    }

    // Number of edges that a piece can have from this point on.
    [[nodiscard]] std::size_t edgesFrom(std::size_t first) const {
        std::size_t edges = 1;
        while (edges + 2 <= std::min(maxPoints_, ring_.size()) && canGrow(first, first + edges)) ++edges;
        return edges;
    }

    // Whether the next point can be added to the piece from `first` to `last`.
    [[nodiscard]] bool canGrow(std::size_t first, std::size_t last) const {
        const glm::vec2 a = point(first), b = point(last), c = point(last + 1);
        return turn(point(last - 1), b, c) >= 0 && turn(b, c, a) >= 0 && turn(c, a, point(first + 1)) >= 0 &&
               isFree(a, b, c);
    }

    // Only points that turn right, or points of holes, can lie inside.
    [[nodiscard]] bool isFree(glm::vec2 a, glm::vec2 b, glm::vec2 c) const {
        return std::ranges::none_of(obstacles_, [&](glm::vec2 p) {
            return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
                   turn(c, a, p) >= 0;
        });
    }

    const Ring& ring_;
    const Ring& obstacles_;
    std::size_t maxPoints_;
};

Ring obstaclesIn(const Footprint& footprint) {
    Ring points;
    const Ring& ring = footprint.outer;
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (turn(ring[(i + ring.size() - 1) % ring.size()], ring[i], ring[(i + 1) % ring.size()]) < 0)
            points.push_back(ring[i]);
    for (const Ring& hole : footprint.holes) points.insert(points.end(), hole.begin(), hole.end());
    return points;
}

}  // namespace

bool isConvex(const Footprint& footprint) {
    const Ring& ring = footprint.outer;
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (turn(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]) < 0) return false;
    return footprint.holes.empty();
}

std::vector<Ring> splitIntoConvexPieces(const Footprint& footprint, std::size_t maxPoints) {
    const Ring obstacles = obstaclesIn(footprint);
    std::vector<Ring> pieces;
    RingCutter(footprint.outer, obstacles, maxPoints).cut(pieces);
    for (const Ring& hole : footprint.holes) RingCutter(hole, obstacles, maxPoints).cut(pieces);
    return pieces;
}

namespace {

using Kind = ShadowCaster::Kind;

class CasterBuilder {
public:
    CasterBuilder(const City& city, const Grid& grid) : city_(city), grid_(grid) {}

    void addBuilding(std::uint32_t building) {
        building_ = building;
        for (const Part& part : city_.buildings[building]->parts) addPart(part);
    }

    // The largest casters first, because much of what follows then falls on cells that are already shaded.
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
        else if (isConvex(part.footprint))
            addConvex(part, part.footprint.outer);
        else if (stands(part))
            addPieces(part);
        else
            addWallsAndUnderside(part);
    }

    static bool stands(const Part& part) { return !part.isOverhanging && seen(part.bottomM) == 0; }

    // A few pieces rather than many walls: each piece casts the shadow of all its walls.
    void addPieces(const Part& part) {
        for (const Ring& piece : splitIntoConvexPieces(part.footprint, ShadowCaster::maxPoints))
            addRing(piece.size() == 2 ? Kind::wall : Kind::prism, part, piece);
    }

    // Prisms with many points are cut along chords; each piece is convex and casts its own shadow.
    void addConvex(const Part& part, std::span<const glm::vec2> ring) {
        const std::size_t count = std::min(ring.size(), ShadowCaster::maxPoints);
        addRing(Kind::prism, part, Ring(ring.begin(), ring.begin() + std::ptrdiff_t(count)));
        if (count == ring.size()) return;
        Ring rest(ring.begin() + std::ptrdiff_t(count) - 1, ring.end());
        rest.push_back(ring[0]);
        addConvex(part, rest);
    }

    void addWallsAndUnderside(const Part& part) {
        addWalls(part, part.footprint.outer);
        for (const Ring& hole : part.footprint.holes) addWalls(part, hole);
        if (part.bottomM <= 0) return;
        const Triangulation under = triangulate(part.footprint);
        for (const glm::uvec3 t : under.triangles)
            addRing(Kind::flat, part, {under.points[t.x], under.points[t.y], under.points[t.z]});
    }

    void addWalls(const Part& part, const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i)
            addRing(Kind::wall, part, {ring[i], ring[(i + 1) % ring.size()]});
    }

    void addFaces(const TriangleMesh& mesh) {
        const bool open = findOpenEdges(mesh) > 0;
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
        caster.stands = kind == Kind::prism && stands(part);
        addEdges(caster);
    }

    void addEdges(ShadowCaster& caster) {
        caster.firstEdge = std::uint32_t(result_.edges.size());
        const auto points = result_.pointsOf(caster);
        for (std::size_t i = 0; i < points.size(); ++i)
            result_.edges.emplace_back(points[i], points[i + 1 == points.size() ? 0 : i + 1]);
    }

    // A receiver is at the origin of its rays: slightly above the ground, and slightly east and north of its
    // cell centre.
    static float seen(float heightM) { return std::max(0.0F, heightM - RayReferenceSettings::liftM); }

    ShadowCaster& add(Kind kind, const Ring& ring) {
        ShadowCaster caster{.kind = kind,
                            .firstPoint = std::uint32_t(result_.points.size()),
                            .pointCount = std::uint32_t(ring.size()),
                            .building = building_};
        caster.low = glm::dvec2(1e30);
        caster.high = glm::dvec2(-1e30);
        for (const glm::vec2 point : ring) {
            const glm::dvec2 cells = toCells(grid_, glm::dvec2(point) - double(RayScene::wallOffsetM));
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

}  // namespace

ShadowCasters makeShadowCasters(const City& city, std::span<const std::uint32_t> buildings,
                                const Grid& grid) {
    CasterBuilder builder(city, grid);
    for (const std::uint32_t building : buildings) builder.addBuilding(building);
    return builder.take();
}

StepOffsets computeOffsets(const SunSteps& sun, double cellM, std::size_t first, std::size_t end) {
    StepOffsets throws{{}, glm::dvec2(1e30), glm::dvec2(-1e30)};
    for (std::size_t step = first; step < std::max(end, first + stepsTogether); ++step) {
        const glm::dvec3 towardsSun(sun.steps[std::min(step, sun.steps.size() - 1)].direction);
        const glm::dvec2 thrown = shadowOffsetInCells(towardsSun, cellM);
        throws.low = glm::min(throws.low, thrown);
        throws.high = glm::max(throws.high, thrown);
        if (step - first >= stepsTogether) continue;
        throws.at.x[step - first] = thrown.x;
        throws.at.y[step - first] = thrown.y;
    }
    return throws;
}

std::vector<StepOffsets> computeOffsetsByEight(const SunSteps& sun, double cellM) {
    std::vector<StepOffsets> throws;
    for (std::size_t first = 0; first < sun.steps.size(); first += stepsTogether)
        throws.push_back(computeOffsets(sun, cellM, first, first + stepsTogether));
    return throws;
}

namespace {

ShadowCasters placeCasters(std::vector<std::shared_ptr<const Building>> buildings, const Grid& grid) {
    City city;
    city.buildings = std::move(buildings);
    std::vector<std::uint32_t> all(city.buildings.size());
    std::iota(all.begin(), all.end(), 0U);
    return makeShadowCasters(city, all, grid);
}

}  // namespace

BuildingCasters::BuildingCasters(std::vector<std::shared_ptr<const Building>> buildings, const Grid& grid)
    : ends_(buildings.size()) {
    casters_ = placeCasters(std::move(buildings), grid);
    const auto buildingOf = [&](std::uint32_t caster) { return casters_.casters[caster].building; };
    order_.resize(casters_.casters.size());
    std::iota(order_.begin(), order_.end(), 0U);
    std::ranges::stable_sort(order_, {}, buildingOf);
    for (std::uint32_t i = 0; i < ends_.size(); ++i)
        ends_[i] = std::size_t(std::ranges::upper_bound(order_, i, {}, buildingOf) - order_.begin());
}

}  // namespace noonmark
