#include "core/io/meshes/mesh_units.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include "core/base/stop_scope.h"
#include "core/city/footprints/plan_overlay.h"
#include "core/city/meshes/mesh_outline.h"
#include "core/city/meshes/mesh_parts.h"
#include "core/city/meshes/mesh_topology.h"
#include "core/describe/text.h"

namespace noonmark {

namespace {

using Indices = std::vector<std::size_t>;

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
            const MeshBox box = computeBox(meshes[i]);
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

// The outlines of the pieces that may overlap another one; empty for the others.
std::vector<std::vector<Footprint>> coverWhatMayOverlap(const std::vector<TriangleMesh>& pieces) {
    std::vector<Box2> boxes;
    for (const TriangleMesh& piece : pieces) {
        const MeshBox box = computeBox(piece);
        boxes.push_back({glm::vec2(box.low), glm::vec2(box.high)});
    }
    std::vector<std::vector<Footprint>> outlines(pieces.size());
    for (const auto& [a, b] : findMeetingBoxes(boxes, boxes))
        if (a != b && outlines[a].empty()) outlines[a] = computeCover(pieces[a]);
    return outlines;
}

std::vector<TriangleMesh> joinedByOverlap(const std::vector<TriangleMesh>& pieces) {
    const std::vector<std::vector<Footprint>> outlines = coverWhatMayOverlap(pieces);
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

// Assigns the walls of an object to its own roofs first.
void takeOwnWalls(ObjectPieces& pieces, std::size_t object) {
    if (pieces.walls.empty() || pieces.buildings.empty()) return;
    std::vector<MeshUnit> units, walls;
    for (TriangleMesh& mesh : pieces.buildings) units.push_back({std::move(mesh), object});
    for (TriangleMesh& mesh : pieces.walls) walls.push_back({std::move(mesh), object});
    const std::vector<MeshUnit> left = assignWalls(units, Under::anyRoof, walls);
    pieces.buildings.clear();
    pieces.walls.clear();
    for (MeshUnit& unit : units) pieces.buildings.push_back(std::move(unit.mesh));
    for (const MeshUnit& wall : left) pieces.walls.push_back(wall.mesh);
}

ObjectPieces makePieces(const NamedMesh& object, std::size_t index, const GroundFinder& ground) {
    ObjectPieces pieces = splitIntoPieces(object, ground);
    takeOwnWalls(pieces, index);
    return pieces;
}

void warn(const ObjectPieces& pieces, const std::string& where, Warnings& warnings) {
    const auto add = [&](WarningKind kind, const char* what, std::size_t count) {
        if (count > 0) warnings.push_back({kind, what, fmt::format("{} ({})", where, count)});
    };
    add(WarningKind::leftOut, "flat ground", pieces.ground);
    add(WarningKind::repaired, NM_TEXT("faces without area were left out"), pieces.withoutArea);
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
    std::vector<ObjectPieces> all(objects.size());
    tbb::parallel_for(std::size_t{0}, objects.size(), [&](std::size_t i) {
        const StopScope scope(stop);
        if (!StopScope::isStopped()) all[i] = makePieces(objects[i], i, ground);
    });
    for (std::size_t i = 0; i < objects.size(); ++i) {
        ObjectPieces& pieces = all[i];
        warn(pieces, file + ": " + objects[i].name, warnings);
        for (TriangleMesh& mesh : pieces.buildings) units.push_back({std::move(mesh), i});
        for (TriangleMesh& mesh : pieces.walls) walls.push_back({std::move(mesh), i});
    }
    if (!walls.empty() && !units.empty() && !stop.stop_requested()) {
        units = separateRoofs(std::move(units), walls);
        walls = assignWalls(units, Under::openRoofs, walls);
        units = joinSteps(units);
    }
    addWalls(walls, units);
    joinFloors(units);
    removeGround(units, ground, file, warnings);
    std::ranges::stable_sort(units, {}, &MeshUnit::object);
    return units;
}

}  // namespace noonmark
