#include "core/measures/outlines/projected_polygons.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "core/city/footprints/triangulate.h"
#include "core/city/meshes/mesh_topology.h"
#include "core/engines/projected/casters/convex_pieces.h"

namespace noonmark {

namespace {

double turnOf(glm::dvec2 u, glm::dvec2 v) { return u.x * v.y - u.y * v.x; }

double twiceArea(const ConvexPolygon& ring) {
    double sum = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += turnOf(ring[i] - ring[0], ring[i + 1] - ring[0]);
    return sum;
}

/// Projects the parts of a building along the sun's direction.
class Projector {
public:
    Projector(glm::dvec2 perMetre, std::vector<ConvexPolygon>& to) : perMetre_(perMetre), to_(to) {}

    void addPart(const Part& part) {
        if (part.mesh)
            addMesh(*part.mesh);
        else if (part.topM <= 0)
            return;
        else if (isConvex(part.footprint))
            addSwept(part.footprint.outer, part);
        else if (part.bottomM <= 0)
            addPieces(part);
        else
            addWallsAndUnderside(part);
    }

private:
    // The walls of a prism on the ground cast all of its shadow outside it.
    void addPieces(const Part& part) {
        for (const Ring& piece :
             splitIntoConvexPieces(part.footprint, std::numeric_limits<std::size_t>::max()))
            addSwept(piece, part);
    }

    void addWallsAndUnderside(const Part& part) {
        addWalls(part.footprint.outer, part);
        for (const Ring& hole : part.footprint.holes) addWalls(hole, part);
        const Triangulation under = triangulate(part.footprint);
        for (const glm::uvec3 t : under.triangles)
            addSwept({under.points[t.x], under.points[t.y], under.points[t.z]}, part.bottomM, part.bottomM);
    }

    void addWalls(const Ring& ring, const Part& part) {
        for (std::size_t i = 0; i < ring.size(); ++i) addSwept({ring[i], ring[(i + 1) % ring.size()]}, part);
    }

    void addSwept(const Ring& ring, const Part& part) {
        addSwept(ring, std::max(0.0F, part.bottomM), part.topM);
    }

    // What a convex polygon (or a wall of two points) sweeps from one height to a greater one: edges that
    // face away from the sun are at the upper one's shadow, the others at the lower one's.
    void addSwept(const Ring& ring, double low, double high) {
        const auto isFar = [&](std::size_t i) {
            return turnOf(perMetre_, glm::dvec2(ring[(i + 1) % ring.size()]) - glm::dvec2(ring[i])) > 0;
        };
        ConvexPolygon swept;
        bool before = isFar(ring.size() - 1);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const bool after = isFar(i);
            swept.push_back(placed(ring[i], before ? high : low));
            if (after != before) swept.push_back(placed(ring[i], after ? high : low));
            before = after;
        }
        add(std::move(swept));
    }

    // Of a closed mesh, the faces that face the sun cast its whole shadow.
    void addMesh(const TriangleMesh& mesh) {
        const bool open = findOpenEdges(mesh) > 0;
        for (const glm::uvec3 t : mesh.triangles) {
            ConvexPolygon face = aboveGround({mesh.vertices[t.x], mesh.vertices[t.y], mesh.vertices[t.z]});
            if (open && twiceArea(face) < 0) std::ranges::reverse(face);
            add(std::move(face));
        }
    }

    // The shadow of the part of a triangle above z = 0.
    [[nodiscard]] ConvexPolygon aboveGround(const std::vector<glm::vec3>& corners) const {
        ConvexPolygon shadow;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec3 a(corners[i]), b(corners[(i + 1) % corners.size()]);
            if (a.z >= 0) shadow.push_back(placed(a, a.z));
            if ((a.z < 0) != (b.z < 0))
                shadow.push_back(glm::dvec2(a) + (glm::dvec2(b) - glm::dvec2(a)) * (a.z / (a.z - b.z)));
        }
        return shadow;
    }

    [[nodiscard]] glm::dvec2 placed(const auto& point, double heightM) const {
        return glm::dvec2(point) + perMetre_ * heightM;
    }

    void add(ConvexPolygon polygon) {
        if (polygon.size() >= 3 && twiceArea(polygon) > 0) to_.push_back(std::move(polygon));
    }

    glm::dvec2 perMetre_;
    std::vector<ConvexPolygon>& to_;
};

}  // namespace

void projectBuilding(const Building& building, glm::dvec2 perMetre, std::vector<ConvexPolygon>& to) {
    Projector projector(perMetre, to);
    for (const Part& part : building.parts) projector.addPart(part);
}

}  // namespace noonmark
