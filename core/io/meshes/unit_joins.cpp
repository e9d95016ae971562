#include "core/io/meshes/mesh_units.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <unordered_map>

#include "core/city/footprints/plan_overlay.h"
#include "core/city/meshes/mesh_parts.h"
#include "core/city/meshes/mesh_topology.h"

namespace noonmark {

namespace {

using Indices = std::vector<std::size_t>;

// Joins units whose lowest edges lie on the edges of a lower unit: a higher roof and the walls that rise to
// it from the surrounding roof.
class StepJoiner {
public:
    explicit StepJoiner(const std::vector<MeshUnit>& units) : units_(units), sets_(units.size()) {
        TriangleMesh all;
        for (const MeshUnit& unit : units) {
            append(all, unit.mesh);
            lowM_.push_back(computeBox(unit.mesh).low.z);
        }
        point_ = weldIndices(all.vertices, touchM);
        std::uint32_t first = 0;
        for (const MeshUnit& unit : units) {
            firstPoint_.push_back(first);
            first += std::uint32_t(unit.mesh.vertices.size());
        }
    }

    std::vector<MeshUnit> join() {
        findLowestOfEdges();
        for (std::size_t i = 0; i < units_.size(); ++i)
            if (const std::size_t carrier = carrierOf(i); carrier != i) sets_.join(i, carrier);
        joinSurrounded();
        std::map<std::size_t, MeshUnit> joined;
        for (std::size_t i = 0; i < units_.size(); ++i) {
            MeshUnit& unit = joined.try_emplace(sets_.of(i), MeshUnit{{}, units_[i].object}).first->second;
            append(unit.mesh, units_[i].mesh);
        }
        std::vector<MeshUnit> made;
        for (auto& [root, unit] : joined) made.push_back(std::move(unit));
        return made;
    }

private:
    void findLowestOfEdges() {
        for (std::size_t i = 0; i < units_.size(); ++i)
            for (const glm::uvec3 t : units_[i].mesh.triangles)
                for (int k = 0; k < 3; ++k) {
                    std::size_t& lowest = lowestOf_.try_emplace(edgeAt(i, t, k), i).first->second;
                    if (lowM_[i] < lowM_[lowest]) lowest = i;
                }
    }

    [[nodiscard]] std::uint64_t edgeAt(std::size_t unit, glm::uvec3 t, int side) const {
        return edgeOf(point_[firstPoint_[unit] + t[side]], point_[firstPoint_[unit] + t[(side + 1) % 3]]);
    }

    // The unit that holds most of a unit's lowest edges; itself if none does.
    [[nodiscard]] std::size_t carrierOf(std::size_t unit) const {
        constexpr float lowestEdgesM = 0.1F, lowerM = 0.5F;
        const TriangleMesh& mesh = units_[unit].mesh;
        std::map<std::size_t, int> edges;
        for (const glm::uvec3 t : mesh.triangles)
            for (int k = 0; k < 3; ++k) {
                if (std::max(mesh.vertices[t[k]].z, mesh.vertices[t[(k + 1) % 3]].z) >
                    lowM_[unit] + lowestEdgesM)
                    continue;
                const std::size_t other = lowestOf_.at(edgeAt(unit, t, k));
                if (lowM_[other] < lowM_[unit] - lowerM) ++edges[other];
            }
        std::size_t best = unit;
        int maximum = 0;
        for (const auto& [other, count] : edges)
            if (count > maximum) best = other, maximum = count;
        return best;
    }

    // For edges that do not match: joins a unit that starts above the ground with the lower units around half
    // of its outline that reach up to its foot.
    void joinSurrounded() {
        std::vector<std::vector<Footprint>> outlines;
        std::vector<Box2> boxes, grown;
        for (const MeshUnit& unit : units_) {
            outlines.push_back(computeCover(unit.mesh));
            boxes.emplace_back();
            for (const Footprint& piece : outlines.back()) boxes.back().add(bounds(piece));
            grown.push_back({boxes.back().low - besideM, boxes.back().high + besideM});
        }
        std::vector<Indices> around(units_.size());
        for (const auto& [unit, other] : findMeetingBoxes(boxes, grown))
            if (mayCarry(other, unit)) around[unit].push_back(other);
        for (std::size_t i = 0; i < units_.size(); ++i) joinSurrounded(i, around[i], outlines);
    }

    [[nodiscard]] bool mayCarry(std::size_t other, std::size_t unit) const {
        constexpr float reachM = 0.5F;
        return lowM_[other] + openAirM < lowM_[unit] &&
               computeBox(units_[other].mesh).high.z + reachM > lowM_[unit];
    }

    void joinSurrounded(std::size_t unit, const Indices& around,
                        const std::vector<std::vector<Footprint>>& outlines) {
        constexpr double surrounded = 0.5;
        double all = 0, maximum = 0;
        std::size_t carrier = unit;
        for (const std::size_t other : around) {
            const double share = computeShareBeside(outlines[unit], outlines[other], double(besideM));
            all += share;
            if (share > maximum) maximum = share, carrier = other;
        }
        if (all >= surrounded) sets_.join(unit, carrier);
    }

    static constexpr float besideM = 0.1F;
    const std::vector<MeshUnit>& units_;
    DisjointSets sets_;
    std::vector<float> lowM_;
    std::vector<std::uint32_t> point_, firstPoint_;
    std::unordered_map<std::uint64_t, std::size_t>
        lowestOf_;  // for each edge, the unit with the lowest point
};

bool isFloorOf(const TriangleMesh& sheet, const std::vector<Footprint>& sheetOutline,
               const TriangleMesh& body, const std::vector<Footprint>& bodyOutline) {
    constexpr float belowM = 0.5F;
    const MeshBox box = computeBox(body);
    const float heightM = computeBox(sheet).low.z;
    if (isLevel(body) || heightM < box.low.z - belowM || heightM > box.high.z) return false;
    const double sheetM2 = area(sheetOutline), bodyM2 = area(bodyOutline);
    const double shared = computeSharedArea(sheetOutline, bodyOutline);
    return shared >= 0.9 * sheetM2 && shared >= 0.5 * bodyM2;
}

}  // namespace

std::vector<MeshUnit> joinSteps(const std::vector<MeshUnit>& units) { return StepJoiner(units).join(); }

void joinFloors(std::vector<MeshUnit>& units) {
    std::vector<std::vector<Footprint>> outlines(units.size());
    std::vector<Box2> sheets(units.size()), bodies(units.size());
    if (std::ranges::none_of(units, [](const MeshUnit& unit) { return isLevel(unit.mesh); })) return;
    for (std::size_t i = 0; i < units.size(); ++i) {
        outlines[i] = computeCover(units[i].mesh);
        for (const Footprint& piece : outlines[i])
            (isLevel(units[i].mesh) ? sheets : bodies)[i].add(bounds(piece));
    }
    for (const auto& [sheet, body] : findMeetingBoxes(sheets, bodies)) {
        if (units[sheet].mesh.triangles.empty() ||
            !isFloorOf(units[sheet].mesh, outlines[sheet], units[body].mesh, outlines[body]))
            continue;
        append(units[body].mesh, units[sheet].mesh);
        units[sheet].mesh = {};
    }
    std::erase_if(units, [](const MeshUnit& unit) { return unit.mesh.triangles.empty(); });
}

namespace {

double distanceFrom(const std::vector<Footprint>& outline, glm::dvec2 point) {
    double minimum = std::numeric_limits<double>::max();
    for (const Footprint& piece : outline)
        minimum = contains(piece, point) ? 0 : std::min(minimum, distanceTo(piece.outer, point));
    return minimum;
}

// Assigns the faces of walls to the units above them.
class WallTaker {
public:
    WallTaker(std::vector<MeshUnit>& units, Under under) : units_(units) {
        for (const MeshUnit& unit : units) {
            const bool open = findOpenEdges(unit.mesh) > 0;
            outlines_.push_back(open || under == Under::anyRoof ? computeOutline(unit.mesh, !open).pieces
                                                                : std::vector<Footprint>{});
            boxes_.emplace_back();
            for (const Footprint& piece : outlines_.back()) boxes_.back().add(bounds(piece));
            if (boxes_.back().empty()) continue;
            boxes_.back().low -= float(besideM);
            boxes_.back().high += float(besideM);
        }
        taken_.resize(units.size());
    }

    // The walls that remain.
    std::vector<MeshUnit> take(const std::vector<MeshUnit>& walls) {
        const std::vector<Indices> near = nearEachFace(walls);
        std::vector<MeshUnit> left;
        std::size_t face = 0;
        for (const MeshUnit& wall : walls) {
            MeshUnit rest{{}, wall.object};
            for (const glm::uvec3 t : wall.mesh.triangles) {
                const std::size_t unit = unitOver(wall.mesh, t, near[face++]);
                addFace(unit == none ? rest.mesh : taken_[unit], wall.mesh, t);
            }
            if (!rest.mesh.triangles.empty()) left.push_back(std::move(rest));
        }
        addTaken();
        return left;
    }

private:
    static constexpr double besideM = 0.25;
    static constexpr std::size_t none = ~std::size_t(0);

    void addTaken() {
        for (std::size_t i = 0; i < units_.size(); ++i) {
            if (taken_[i].triangles.empty()) continue;
            append(units_[i].mesh, taken_[i]);
            units_[i].mesh = weld(units_[i].mesh);
        }
    }

    // For each face, the units whose boxes contain its centre.
    [[nodiscard]] std::vector<Indices> nearEachFace(const std::vector<MeshUnit>& walls) const {
        std::vector<Box2> middles;
        for (const MeshUnit& wall : walls)
            for (const glm::uvec3 t : wall.mesh.triangles) {
                middles.emplace_back();
                middles.back().add(glm::vec2(findMiddle(wall.mesh, t)));
            }
        std::vector<Indices> near(middles.size());
        for (const auto& [face, unit] : findMeetingBoxes(middles, boxes_)) near[face].push_back(unit);
        return near;
    }

    static glm::dvec2 findMiddle(const TriangleMesh& mesh, glm::uvec3 t) {
        const auto at = [&](std::uint32_t i) { return glm::dvec2(glm::vec2(mesh.vertices[i])); };
        const glm::dvec2 a = at(t.x), b = at(t.y), c = at(t.z);
        // Midpoint of the line in plan: between the two corners that are farthest apart.
        const double ab = glm::distance(a, b), bc = glm::distance(b, c), ca = glm::distance(c, a);
        if (ab >= bc && ab >= ca) return (a + b) / 2.0;
        return bc >= ca ? (b + c) / 2.0 : (c + a) / 2.0;
    }

    static glm::vec3 topOf(const TriangleMesh& mesh, glm::uvec3 t) {
        glm::vec3 top = mesh.vertices[t.x];
        for (const std::uint32_t i : {t.y, t.z})
            if (mesh.vertices[i].z > top.z) top = mesh.vertices[i];
        return top;
    }

    [[nodiscard]] std::size_t unitOver(const TriangleMesh& mesh, glm::uvec3 face, const Indices& near) const {
        std::size_t best = none;
        double minM = besideM, minToTopM = 0;
        const glm::dvec2 middle = findMiddle(mesh, face);
        for (const std::size_t unit : near) {
            const double awayM = distanceFrom(outlines_[unit], middle);
            if (awayM > minM + double(touchM)) continue;
            const double toTopM = distanceToPoints(units_[unit].mesh, topOf(mesh, face));
            const bool nearer = awayM < minM - double(touchM);
            if (best != none && !nearer && toTopM >= minToTopM) continue;
            best = unit, minM = awayM, minToTopM = toTopM;
        }
        return best;
    }

    static double distanceToPoints(const TriangleMesh& mesh, glm::vec3 point) {
        double minimum = std::numeric_limits<double>::max();
        for (const glm::vec3 vertex : mesh.vertices)
            minimum = std::min(minimum, double(glm::distance(vertex, point)));
        return minimum;
    }

    static void addFace(TriangleMesh& to, const TriangleMesh& from, glm::uvec3 face) {
        const auto first = std::uint32_t(to.vertices.size());
        for (int k = 0; k < 3; ++k) to.vertices.push_back(from.vertices[face[k]]);
        to.triangles.emplace_back(first, first + 1, first + 2);
    }

    std::vector<MeshUnit>& units_;
    std::vector<std::vector<Footprint>> outlines_;
    std::vector<Box2> boxes_;
    std::vector<TriangleMesh> taken_;
};

}  // namespace

std::vector<MeshUnit> assignWalls(std::vector<MeshUnit>& units, Under under,
                                  const std::vector<MeshUnit>& walls) {
    return WallTaker(units, under).take(walls);
}

void addWalls(const std::vector<MeshUnit>& walls, std::vector<MeshUnit>& units) {
    std::map<std::size_t, Indices> unitsOf;
    for (std::size_t i = 0; i < units.size(); ++i) unitsOf[units[i].object].push_back(i);
    for (const MeshUnit& wall : walls) {
        const TriangleMesh mesh = weld(wall.mesh);
        if (const auto own = unitsOf.find(wall.object); own != unitsOf.end() && own->second.size() == 1) {
            append(units[own->second.front()].mesh, mesh);
            continue;
        }
        for (TriangleMesh& one : separateComponents(mesh, findComponents(mesh)))
            units.push_back({std::move(one), wall.object});
    }
}

}  // namespace noonmark
