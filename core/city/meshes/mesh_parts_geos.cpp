#include "core/city/meshes/mesh_parts.h"

#include <geos_c.h>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "core/city/footprints/geos_shapes.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/city/footprints/triangulate.h"
#include "core/city/meshes/mesh_outline.h"
#include "core/city/meshes/mesh_topology.h"

namespace noonmark {

namespace {

using Plan = Geos::Geometry;

constexpr double minEavesM = 0.1;   // narrower ones stay with the body
constexpr double maxEavesM = 3;     // below wider roofs walls are missing
constexpr double minEavesM2 = 0.1;  // as of open air below a mesh
constexpr double eavesWithinM = 0.01;

/// A triangle in space, with its plane.
struct RoofFace {
    glm::dvec3 a, b, c;

    [[nodiscard]] glm::dvec3 doubled() const { return glm::cross(b - a, c - a); }
    [[nodiscard]] bool isUpright() const {
        constexpr double plumb = 0.1;  // within 6 degrees
        return std::abs(doubled().z) < plumb * glm::length(doubled());
    }
    [[nodiscard]] glm::dvec2 middle() const { return glm::dvec2(a + b + c) / 3.0; }
    /// Of an upright face.
    [[nodiscard]] PlanLine fromAboveAsLine() const {
        const glm::dvec2 corners[] = {glm::dvec2(a), glm::dvec2(b), glm::dvec2(c)};
        PlanLine longest{corners[0], corners[1]};
        for (int i = 1; i < 3; ++i)
            if (const PlanLine line{corners[i], corners[(i + 1) % 3]};
                glm::distance(line.a, line.b) > glm::distance(longest.a, longest.b))
                longest = line;
        return longest;
    }
    [[nodiscard]] double lowestM() const { return std::min({a.z, b.z, c.z}); }
    [[nodiscard]] double highestM() const { return std::max({a.z, b.z, c.z}); }
    [[nodiscard]] double heightAt(glm::dvec2 place) const {
        const glm::dvec3 normal = doubled();
        return a.z - glm::dot(glm::dvec2(normal), place - glm::dvec2(a)) / normal.z;
    }
    [[nodiscard]] Footprint fromAbove() const {
        Footprint plan{{glm::vec2(a), glm::vec2(b), glm::vec2(c)}, {}};
        if (doubled().z < 0) std::swap(plan.outer[1], plan.outer[2]);
        return plan;
    }
};

RoofFace faceOf(const TriangleMesh& mesh, glm::uvec3 t) {
    return {glm::dvec3(mesh.vertices[t.x]), glm::dvec3(mesh.vertices[t.y]), glm::dvec3(mesh.vertices[t.z])};
}

void addFace(const RoofFace& face, TriangleMesh& mesh) {
    append(mesh, {{glm::vec3(face.a), glm::vec3(face.b), glm::vec3(face.c)}, {{0, 1, 2}}});
}

/// A piece of a face, seen from above, back in the face's plane.
void addPiece(const RoofFace& face, const Footprint& piece, TriangleMesh& mesh) {
    const Triangulation flat = triangulate(piece);
    TriangleMesh lifted{{}, flat.triangles};
    for (const glm::vec2 point : flat.points)
        lifted.vertices.emplace_back(point, float(face.heightAt(glm::dvec2(point))));
    if (face.doubled().z < 0) turnInsideOut(lifted);
    append(mesh, lifted);
}

/// The area that walls enclose, narrower and wider too.
class WalledArea {
public:
    WalledArea(const Geos& geos, const std::vector<Footprint>& walled)
        : geos_(geos),
          walled_(uniteGeometry(geos, collection(geos, walled))),
          within_(buffered(-eavesWithinM)),
          beside_(buffered(minEavesM)),
          reach_(buffered(maxEavesM)) {}

    [[nodiscard]] bool isSound() const { return walled_ && within_ && beside_ && reach_; }
    /// Square metres that lie farther outside than the least eaves.
    [[nodiscard]] double overhang(const RoofFace& face) const {
        const Plan plan = planOf(face);
        return covers(beside_, plan) ? 0 : computeArea(geos_, subtractGeometry(geos_, plan, beside_));
    }
    [[nodiscard]] bool holds(const RoofFace& face) const { return covers(walled_, planOf(face)); }
    [[nodiscard]] bool reaches(const RoofFace& face) const { return covers(reach_, planOf(face)); }
    /// Whether a place is inside, or at a wall.
    [[nodiscard]] bool isBeside(glm::dvec2 place) const {
        const Plan point = geos_.owned(GEOSGeom_createPointFromXY_r(geos_, place.x, place.y));
        return point && GEOSIntersects_r(geos_, beside_.get(), point.get()) == 1;
    }
    [[nodiscard]] std::vector<Footprint> inside(const RoofFace& face) const {
        const Plan plan = planOf(face);
        return polygons(geos_.owned(plan ? GEOSIntersection_r(geos_, plan.get(), walled_.get()) : nullptr));
    }
    [[nodiscard]] std::vector<Footprint> outside(const RoofFace& face) const {
        return polygons(subtractGeometry(geos_, planOf(face), within_));
    }
    /// Whether a piece outside is too narrow for eaves.
    [[nodiscard]] bool isNarrow(const Footprint& piece) const {
        return covers(beside_, collection(geos_, std::vector<Footprint>{piece}));
    }

private:
    [[nodiscard]] Plan buffered(double byM) const {
        constexpr int segments = 2;
        constexpr double mitre = 5;
        return geos_.owned(walled_ ? GEOSBufferWithStyle_r(geos_, walled_.get(), byM, segments,
                                                           GEOSBUF_CAP_FLAT, GEOSBUF_JOIN_MITRE, mitre)
                                   : nullptr);
    }
    [[nodiscard]] Plan planOf(const RoofFace& face) const {
        return collection(geos_, std::vector<Footprint>{face.fromAbove()});
    }
    [[nodiscard]] bool covers(const Plan& area, const Plan& plan) const {
        return plan && GEOSCovers_r(geos_, area.get(), plan.get()) == 1;
    }
    [[nodiscard]] std::vector<Footprint> polygons(const Plan& plan) const {
        constexpr double roundingM2 = 1e-7;
        return toPolygons(geos_, plan, nullptr, roundingM2);
    }

    const Geos& geos_;
    Plan walled_, within_, beside_, reach_;
};

/// Sorts the faces of a mesh into body and eaves.
class EavesCutter {
public:
    EavesCutter(const WalledArea& walls, float lowM) : walls_(walls), lowM_(lowM) {}

    void add(const RoofFace& face) {
        if (face.isUpright())
            addUpright(face);
        else if (walls_.holds(face))
            addFace(face, cut_.body);
        else
            addCrossing(face);
    }

    CutEaves take() {
        for (TriangleMesh* mesh : {&cut_.body, &cut_.eaves}) {
            *mesh = weld(*mesh);
            removeDegenerateTriangles(*mesh);
        }
        return std::move(cut_);
    }

private:
    static double lowestOf(const RoofFace& face, const Footprint& piece) {
        double lowest = 1e30;
        for (const glm::vec2 corner : piece.outer)
            lowest = std::min(lowest, face.heightAt(glm::dvec2(corner)));
        return lowest;
    }
    [[nodiscard]] bool isInTheAir(double heightM) const { return heightM > double(lowM_ + openAirM); }

    void addUpright(const RoofFace& face) {
        const bool isOverhanging = isInTheAir(face.lowestM()) && !walls_.isBeside(face.middle());
        addFace(face, isOverhanging ? cut_.eaves : cut_.body);
    }

    void addCrossing(const RoofFace& face) {
        for (const Footprint& piece : walls_.inside(face)) addPiece(face, piece, cut_.body);
        if (face.highestM() <= double(lowM_ + levelSheetM)) return;  // the floor
        for (const Footprint& piece : walls_.outside(face)) {
            const bool isOverhanging = isInTheAir(lowestOf(face, piece)) && !walls_.isNarrow(piece);
            addPiece(face, piece, isOverhanging ? cut_.eaves : cut_.body);
        }
    }

    const WalledArea& walls_;
    float lowM_;
    CutEaves cut_;
};

std::vector<RoofFace> facesOf(const TriangleMesh& mesh) {
    std::vector<RoofFace> faces;
    for (const glm::uvec3 triangle : mesh.triangles) faces.push_back(faceOf(mesh, triangle));
    return faces;
}

std::vector<PlanLine> lowWallsOf(const std::vector<RoofFace>& faces, double highestFootM) {
    std::vector<PlanLine> lines;
    for (const RoofFace& face : faces)
        if (face.isUpright() && face.lowestM() <= highestFootM) lines.push_back(face.fromAboveAsLine());
    return lines;
}

double distanceTo(const PlanLine& line, glm::dvec2 place) {
    const glm::dvec2 along = line.b - line.a;
    const double share = glm::dot(place - line.a, along) / std::max(1e-12, glm::dot(along, along));
    return glm::distance(line.a + glm::clamp(share, 0.0, 1.0) * along, place);
}

// Whether a corner of a roof lies away from all walls: where none does, nothing overhangs.
bool leavesWalls(const std::vector<RoofFace>& faces, const std::vector<PlanLine>& walls, double aboveM) {
    const auto isAway = [&](glm::dvec3 corner) {
        return std::ranges::none_of(
            walls, [&](const PlanLine& wall) { return distanceTo(wall, glm::dvec2(corner)) <= minEavesM; });
    };
    return std::ranges::any_of(faces, [&](const RoofFace& face) {
        return face.highestM() > aboveM && !face.isUpright() &&
               (isAway(face.a) || isAway(face.b) || isAway(face.c));
    });
}

// Whether a line begins or passes at the end of another one and is not merely a part of it.
bool continues(const PlanLine& line, glm::dvec2 end, glm::dvec2 otherEnd) {
    constexpr double atM = 0.002, asideM = 0.01;
    if (distanceTo(line, end) > atM) return false;
    const glm::dvec2 inward = (otherEnd - end) / std::max(1e-12, glm::distance(otherEnd, end));
    const auto isElsewhere = [&](glm::dvec2 place) {
        const glm::dvec2 away = place - end;
        return glm::dot(away, inward) < -asideM || std::abs(away.x * inward.y - away.y * inward.x) > asideM;
    };
    return isElsewhere(line.a) || isElsewhere(line.b);
}

// A wall that nothing continues tells that another is missing, in a fraction of the time that it takes to
// find what they enclose.
bool hasLooseEnd(const std::vector<PlanLine>& walls) {
    const auto isLoose = [&](glm::dvec2 end, glm::dvec2 otherEnd) {
        return std::ranges::none_of(walls,
                                    [&](const PlanLine& wall) { return continues(wall, end, otherEnd); });
    };
    return std::ranges::any_of(
        walls, [&](const PlanLine& wall) { return isLoose(wall.a, wall.b) || isLoose(wall.b, wall.a); });
}

// Walls on a slope begin at different heights; those of dormers begin too high to bound the ground.
std::vector<Footprint> findWalled(const TriangleMesh& mesh, const std::vector<RoofFace>& faces, float lowM) {
    if (!leavesWalls(faces, lowWallsOf(faces, double(lowM + openAirM)), double(lowM + openAirM))) return {};
    std::size_t tried = 0;
    for (int storeys = 1; storeys <= 3; ++storeys) {
        const float aboveM = float(storeys) * openAirM;
        const std::vector<PlanLine> walls = lowWallsOf(faces, double(lowM + aboveM));
        if (walls.size() == std::exchange(tried, walls.size()) || hasLooseEnd(walls)) continue;
        if (auto walled = findEnclosedByWalls(mesh, aboveM); !walled.empty()) return walled;
    }
    return {};
}

// Whether all that is outside is a roof no wider than eaves. Walls on the ground outside are those of a house
// whose party walls are missing, so that they enclose only a part of it.
bool overhangs(const std::vector<RoofFace>& faces, const WalledArea& walls, double aboveM) {
    constexpr double maxOutsideM = 0.5;
    double overhangM2 = 0, outsideM = 0;
    for (const RoofFace& face : faces) {
        if (face.isUpright()) {
            const auto [from, to] = face.fromAboveAsLine();
            if (face.lowestM() <= aboveM && !walls.isBeside(face.middle()))
                outsideM += glm::distance(from, to);
        } else if (face.highestM() > aboveM) {
            if (!walls.reaches(face)) return false;
            overhangM2 += walls.overhang(face);
        }
    }
    return overhangM2 >= minEavesM2 && outsideM <= maxOutsideM;
}

}  // namespace

std::optional<CutEaves> cutEaves(const TriangleMesh& mesh) {
    const float lowM = computeBox(mesh).low.z;
    const std::vector<RoofFace> faces = facesOf(mesh);
    const std::vector<Footprint> walled = findWalled(mesh, faces, lowM);
    if (walled.empty()) return std::nullopt;
    const Geos geos;
    const WalledArea walls(geos, walled);
    if (!walls.isSound() || !overhangs(faces, walls, double(lowM + openAirM))) return std::nullopt;
    EavesCutter cutter(walls, lowM);
    for (const RoofFace& face : faces) cutter.add(face);
    CutEaves cut = cutter.take();
    if (cut.eaves.triangles.empty() || cut.body.triangles.empty()) return std::nullopt;
    return cut;
}

}  // namespace noonmark
