#include "core/io/meshes/mesh_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include "core/city/footprints/plan_overlay.h"
#include "core/city/meshes/mesh_outline.h"
#include "core/city/meshes/mesh_parts.h"
#include "core/city/meshes/mesh_sheets.h"
#include "core/city/meshes/mesh_topology.h"
#include "core/io/meshes/surface_names.h"

namespace noonmark {

namespace {

using Indices = std::vector<std::size_t>;
constexpr float touchM = 0.01F;

std::vector<Footprint> coverOf(const TriangleMesh& mesh) {
    return computeOutline(mesh, findOpenEdges(mesh) == 0).pieces;
}

class Sets {
public:
    explicit Sets(std::size_t count) : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t(0));
    }
    std::size_t of(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) {
        a = of(a), b = of(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    Indices parent_;
};

// The building that the object is a surface of, according to its name; empty if the name does not say.
std::string surfaceKey(const NamedMesh& object) {
    if (isOnlySurfaceName(object.name)) return object.parent.empty() ? "" : "in " + object.parent;
    return stemOfSurfaceName(object.name);
}

NamedMesh joinedObject(const std::vector<NamedMesh>& objects, const Indices& members) {
    const NamedMesh& first = objects[members.front()];
    const std::string stem = stemOfSurfaceName(first.name);
    NamedMesh joined{stem.empty() ? first.parent : stem, {}, first.parent};
    for (const std::size_t member : members) append(joined.mesh, objects[member].mesh);
    joined.mesh = weld(joined.mesh);
    joined.oneBuilding = true;
    return joined;
}

// The buildings of one object, and its walls that are under none of its roofs.
struct ObjectPieces {
    std::vector<TriangleMesh> buildings;
    std::vector<TriangleMesh> walls;
    std::size_t ground = 0, withoutArea = 0;  // sheets and faces that were left out
};

// Finds the level sheets that are ground.
class GroundFinder {
public:
    explicit GroundFinder(const std::vector<NamedMesh>& objects) {
        for (const NamedMesh& object : objects) lowestM_ = std::min(lowestM_, computeBox(object.mesh).low.z);
    }

    [[nodiscard]] std::vector<bool> find(const std::vector<TriangleMesh>& meshes) const {
        const std::vector<std::size_t> standing = countStanding(meshes);
        std::vector<bool> ground;
        for (std::size_t i = 0; i < meshes.size(); ++i) ground.push_back(isGround(meshes[i], standing[i]));
        return ground;
    }

private:
    [[nodiscard]] bool isGround(const TriangleMesh& mesh, std::size_t standing) const {
        if (!isLevel(mesh)) return false;
        const float heightM = computeBox(mesh).high.z;
        if (heightM <= groundSheetM) return true;
        return heightM <= lowestM_ + groundSheetM && standing >= (heightM > openAirM ? 2U : 1U);
    }

    // For each level mesh, the number of other meshes that begin on it.
    static std::vector<std::size_t> countStanding(const std::vector<TriangleMesh>& meshes) {
        std::vector<Box2> sheets(meshes.size()), middles(meshes.size());
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            const Box3 box = computeBox(meshes[i]);
            if (isLevel(meshes[i]))
                sheets[i] = {glm::vec2(box.low), glm::vec2(box.high)};
            else
                middles[i].add((glm::vec2(box.low) + glm::vec2(box.high)) / 2.0F);
        }
        std::vector<std::size_t> standing(meshes.size());
        for (const auto& [sheet, other] : findMeetingBoxes(sheets, middles))
            if (std::abs(computeBox(meshes[other]).low.z - computeBox(meshes[sheet]).low.z) <= groundSheetM)
                ++standing[sheet];
        return standing;
    }

    float lowestM_ = std::numeric_limits<float>::max();
};

std::vector<TriangleMesh> joinedByOverlap(const std::vector<TriangleMesh>& pieces) {
    std::vector<std::vector<Footprint>> outlines;
    for (const TriangleMesh& piece : pieces) outlines.push_back(coverOf(piece));
    const Indices groups = groupOverlapping(outlines);
    std::vector<TriangleMesh> meshes;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (groups[i] == meshes.size()) meshes.emplace_back();
        append(meshes[groups[i]], pieces[i]);
    }
    return meshes;
}

ObjectPieces splitIntoPieces(const NamedMesh& object, const GroundFinder& ground) {
    const TriangleMesh mesh = weld(object.mesh);
    ObjectPieces pieces;
    pieces.withoutArea = object.mesh.triangles.size() - mesh.triangles.size();
    if (object.oneBuilding) {
        pieces.buildings.push_back(mesh);
        return pieces;
    }
    std::vector<TriangleMesh> components = separateComponents(mesh, findComponents(mesh));
    const std::vector<bool> isGround = ground.find(components);
    pieces.ground = std::size_t(std::ranges::count(isGround, true));
    std::size_t next = 0;
    std::erase_if(components, [&](const TriangleMesh&) { return isGround[next++]; });
    const auto roofs = std::stable_partition(components.begin(), components.end(), isUpright);
    pieces.walls.assign(std::make_move_iterator(components.begin()), std::make_move_iterator(roofs));
    components.erase(components.begin(), roofs);
    pieces.buildings = joinedByOverlap(components);
    return pieces;
}

// An edge as the indices of its welded ends.
std::uint64_t edgeOf(std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t(std::min(a, b)) << 32U) | std::max(a, b);
}

// Divides roof faces into roofs: faces that share an edge belong together, unless a wall ends at that edge.
class RoofPartition {
public:
    RoofPartition(const std::vector<MeshUnit>& roofs, const std::vector<MeshUnit>& walls) : roofs_(roofs) {
        for (const MeshUnit& roof : roofs) append(all_, roof.mesh);
        const std::size_t roofPoints = all_.vertices.size(), roofFaces = all_.triangles.size();
        for (const MeshUnit& wall : walls) append(all_, wall.mesh);
        point_ = weldIndices(all_.vertices, touchM);
        for (std::size_t i = roofFaces; i < all_.triangles.size(); ++i)
            for (int k = 0; k < 3; ++k) wallEdges_.insert(edgeAt(i, k));
        all_.triangles.resize(roofFaces);
        all_.vertices.resize(roofPoints);
    }

    std::vector<MeshUnit> make() {
        Sets faces(all_.triangles.size());
        joinAcrossEdges(faces);
        joinWhatOverlaps(faces);
        return gathered(faces);
    }

private:
    [[nodiscard]] std::uint64_t edgeAt(std::size_t face, int side) const {
        const glm::uvec3 t = all_.triangles[face];
        return edgeOf(point_[t[side]], point_[t[(side + 1) % 3]]);
    }

    void joinAcrossEdges(Sets& faces) {
        std::unordered_map<std::uint64_t, std::size_t> faceOf;
        for (std::size_t i = 0; i < all_.triangles.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                const std::uint64_t edge = edgeAt(i, k);
                if (wallEdges_.contains(edge)) continue;
                const auto [place, isNew] = faceOf.try_emplace(edge, i);
                if (!isNew) faces.join(i, place->second);
            }
    }

    // Joins pieces of one unit that overlap in plan, such as a dormer over its roof.
    void joinWhatOverlaps(Sets& faces) {
        std::size_t first = 0;
        for (const MeshUnit& roof : roofs_) {
            const std::size_t end = first + roof.mesh.triangles.size();
            joinWhatOverlaps(faces, first, end);
            first = end;
        }
    }

    void joinWhatOverlaps(Sets& faces, std::size_t first, std::size_t end) {
        std::map<std::size_t, TriangleMesh> pieces;
        for (std::size_t i = first; i < end; ++i) addFace(pieces[faces.of(i)], i);
        if (pieces.size() < 2) return;
        std::vector<std::vector<Footprint>> outlines;
        Indices roots;
        for (const auto& [root, mesh] : pieces) outlines.push_back(coverOf(mesh)), roots.push_back(root);
        const Indices groups = groupOverlapping(outlines);
        for (std::size_t i = 0; i < groups.size(); ++i)
            faces.join(roots[std::size_t(std::ranges::find(groups, groups[i]) - groups.begin())], roots[i]);
    }

    void addFace(TriangleMesh& mesh, std::size_t face) const {
        const auto first = std::uint32_t(mesh.vertices.size());
        for (int k = 0; k < 3; ++k) mesh.vertices.push_back(all_.vertices[all_.triangles[face][k]]);
        mesh.triangles.emplace_back(first, first + 1, first + 2);
    }

    std::vector<MeshUnit> gathered(Sets& faces) {
        std::map<std::size_t, MeshUnit> units;
        std::size_t face = 0;
        for (const MeshUnit& roof : roofs_)
            for (std::size_t i = 0; i < roof.mesh.triangles.size(); ++i, ++face) {
                MeshUnit& unit = units.try_emplace(faces.of(face), MeshUnit{{}, roof.object}).first->second;
                addFace(unit.mesh, face);
            }
        std::vector<MeshUnit> made;
        for (auto& [root, unit] : units) made.push_back({weld(unit.mesh), unit.object});
        return made;
    }

    const std::vector<MeshUnit>& roofs_;
    TriangleMesh all_;
    std::vector<std::uint32_t> point_;
    std::unordered_set<std::uint64_t> wallEdges_;
};

double distanceFrom(const Ring& ring, glm::dvec2 point) {
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 a(ring[i]), along = glm::dvec2(ring[(i + 1) % ring.size()]) - a;
        const double share =
            std::clamp(glm::dot(point - a, along) / std::max(1e-12, glm::dot(along, along)), 0.0, 1.0);
        least = std::min(least, glm::distance(point, a + share * along));
    }
    return least;
}

double distanceFrom(const std::vector<Footprint>& outline, glm::dvec2 point) {
    double least = std::numeric_limits<double>::max();
    for (const Footprint& piece : outline)
        least = contains(piece, point) ? 0 : std::min(least, distanceFrom(piece.outer, point));
    return least;
}

// Assigns the faces of walls to the units above them.
class WallTaker {
public:
    enum class Under { openRoofs, anyRoof };

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
        double leastM = besideM, leastToTopM = 0;
        const glm::dvec2 middle = findMiddle(mesh, face);
        for (const std::size_t unit : near) {
            const double awayM = distanceFrom(outlines_[unit], middle);
            if (awayM > leastM + double(touchM)) continue;
            const double toTopM = distanceToPoints(units_[unit].mesh, topOf(mesh, face));
            const bool nearer = awayM < leastM - double(touchM);
            if (best != none && !nearer && toTopM >= leastToTopM) continue;
            best = unit, leastM = awayM, leastToTopM = toTopM;
        }
        return best;
    }

    static double distanceToPoints(const TriangleMesh& mesh, glm::vec3 point) {
        double least = std::numeric_limits<double>::max();
        for (const glm::vec3 vertex : mesh.vertices)
            least = std::min(least, double(glm::distance(vertex, point)));
        return least;
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

// Assigns the walls of an object to its own roofs first.
void takeOwnWalls(ObjectPieces& pieces, std::size_t object) {
    if (pieces.walls.empty() || pieces.buildings.empty()) return;
    std::vector<MeshUnit> units, walls;
    for (TriangleMesh& mesh : pieces.buildings) units.push_back({std::move(mesh), object});
    for (TriangleMesh& mesh : pieces.walls) walls.push_back({std::move(mesh), object});
    const std::vector<MeshUnit> left = WallTaker(units, WallTaker::Under::anyRoof).take(walls);
    pieces.buildings.clear();
    pieces.walls.clear();
    for (MeshUnit& unit : units) pieces.buildings.push_back(std::move(unit.mesh));
    for (const MeshUnit& wall : left) pieces.walls.push_back(wall.mesh);
}

void warn(const ObjectPieces& pieces, const std::string& where, Warnings& warnings) {
    const auto add = [&](WarningKind kind, const char* what, std::size_t count) {
        if (count > 0) warnings.push_back({kind, what, fmt::format("{} ({})", where, count)});
    };
    add(WarningKind::leftOut, "flat ground", pieces.ground);
    add(WarningKind::mended, "faces without area were left out", pieces.withoutArea);
}

// Removes ground that is an object of its own.
void removeGround(std::vector<MeshUnit>& units, const GroundFinder& ground, const std::string& file,
                  Warnings& warnings) {
    std::vector<TriangleMesh> meshes;
    for (MeshUnit& unit : units) meshes.push_back(std::move(unit.mesh));
    const std::vector<bool> isGround = ground.find(meshes);
    std::vector<MeshUnit> standing;
    for (std::size_t i = 0; i < units.size(); ++i)
        if (!isGround[i]) standing.push_back({std::move(meshes[i]), units[i].object});
    if (const std::size_t flat = units.size() - standing.size(); flat > 0)
        warnings.push_back({WarningKind::leftOut, "flat ground", fmt::format("{} ({})", file, flat)});
    units = std::move(standing);
}

std::vector<MeshUnit> withRoofsApart(std::vector<MeshUnit> units, const std::vector<MeshUnit>& walls) {
    const auto isRoof = [](const MeshUnit& unit) { return isSheet(unit.mesh); };
    const auto others = std::stable_partition(units.begin(), units.end(), isRoof);
    const std::vector<MeshUnit> roofs(std::make_move_iterator(units.begin()),
                                      std::make_move_iterator(others));
    units.erase(units.begin(), others);
    std::ranges::move(RoofPartition(roofs, walls).make(), std::back_inserter(units));
    return units;
}

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
        int most = 0;
        for (const auto& [other, count] : edges)
            if (count > most) best = other, most = count;
        return best;
    }

    // For edges that do not match: joins a unit that starts above the ground with the lower units around half
    // of its outline that reach up to its foot.
    void joinSurrounded() {
        std::vector<std::vector<Footprint>> outlines;
        std::vector<Box2> boxes, grown;
        for (const MeshUnit& unit : units_) {
            outlines.push_back(coverOf(unit.mesh));
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
        double all = 0, most = 0;
        std::size_t carrier = unit;
        for (const std::size_t other : around) {
            const double share = computeShareBeside(outlines[unit], outlines[other], double(besideM));
            all += share;
            if (share > most) most = share, carrier = other;
        }
        if (all >= surrounded) sets_.join(unit, carrier);
    }

    static constexpr float besideM = 0.1F;
    const std::vector<MeshUnit>& units_;
    Sets sets_;
    std::vector<float> lowM_;
    std::vector<std::uint32_t> point_, firstPoint_;
    std::unordered_map<std::uint64_t, std::size_t>
        lowestOf_;  // for each edge, the unit with the lowest point
};

// Walls without a roof: they join the only building of their object; otherwise each connected set of them is
// a building.
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

bool isFloorOf(const TriangleMesh& sheet, const std::vector<Footprint>& sheetOutline,
               const TriangleMesh& body, const std::vector<Footprint>& bodyOutline) {
    constexpr float belowM = 0.5F;
    const Box3 box = computeBox(body);
    const float heightM = computeBox(sheet).low.z;
    if (isLevel(body) || heightM < box.low.z - belowM || heightM > box.high.z) return false;
    double sheetM2 = 0, bodyM2 = 0;
    for (const Footprint& piece : sheetOutline) sheetM2 += area(piece);
    for (const Footprint& piece : bodyOutline) bodyM2 += area(piece);
    const double shared = computeSharedArea(sheetOutline, bodyOutline);
    return shared >= 0.9 * sheetM2 && shared >= 0.5 * bodyM2;
}

// Joins floors and ceilings that are separate meshes with the buildings that contain them.
void joinFloors(std::vector<MeshUnit>& units) {
    std::vector<std::vector<Footprint>> outlines(units.size());
    std::vector<Box2> sheets(units.size()), bodies(units.size());
    if (std::ranges::none_of(units, [](const MeshUnit& unit) { return isLevel(unit.mesh); })) return;
    for (std::size_t i = 0; i < units.size(); ++i) {
        outlines[i] = coverOf(units[i].mesh);
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

}  // namespace

std::vector<NamedMesh> joinSurfaces(const std::vector<NamedMesh>& objects) {
    std::map<std::string, Indices> membersOf;
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (const std::string key = surfaceKey(objects[i]); !key.empty()) membersOf[key].push_back(i);
    std::vector<NamedMesh> joined = objects;
    for (const auto& [key, members] : membersOf) {
        if (members.size() < 2) continue;
        NamedMesh one = joinedObject(objects, members);
        if (computeOutline(one.mesh, false).pieces.size() != 1) continue;
        for (const std::size_t member : members) joined[member].mesh = {};
        joined[members.front()] = std::move(one);
    }
    std::erase_if(joined, [](const NamedMesh& object) { return object.mesh.triangles.empty(); });
    return joined;
}

std::vector<MeshUnit> detectUnits(const std::vector<NamedMesh>& objects, const std::string& file,
                                  Warnings& warnings, const std::stop_token& stop) {
    const GroundFinder ground(objects);
    std::vector<MeshUnit> units, walls;
    for (std::size_t i = 0; i < objects.size() && !stop.stop_requested(); ++i) {
        ObjectPieces pieces = splitIntoPieces(objects[i], ground);
        warn(pieces, file + ": " + objects[i].name, warnings);
        takeOwnWalls(pieces, i);
        for (TriangleMesh& mesh : pieces.buildings) units.push_back({std::move(mesh), i});
        for (TriangleMesh& mesh : pieces.walls) walls.push_back({std::move(mesh), i});
    }
    if (!walls.empty() && !units.empty() && !stop.stop_requested()) {
        units = withRoofsApart(std::move(units), walls);
        walls = WallTaker(units, WallTaker::Under::openRoofs).take(walls);
        units = StepJoiner(units).join();
    }
    addWalls(walls, units);
    joinFloors(units);
    removeGround(units, ground, file, warnings);
    std::ranges::stable_sort(units, {}, &MeshUnit::object);
    return units;
}

}  // namespace noonmark
