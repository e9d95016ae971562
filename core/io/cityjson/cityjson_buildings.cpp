#include "core/io/cityjson/cityjson_load.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <memory>
#include <set>
#include <unordered_map>
#include <utility>

#include "core/base/safe_text.h"
#include "core/base/stop_scope.h"
#include "core/city/meshes/mesh_outline.h"
#include "core/city/meshes/mesh_parts.h"
#include "core/city/meshes/mesh_topology.h"
#include "core/city/terrain/tin_terrain.h"
#include "core/describe/text.h"
#include "core/geo/frame.h"
#include "core/io/heights/height_reading.h"
#include "core/io/pieces/read_part.h"

namespace noonmark {

namespace {

// The objects that make up one building; the first is the outermost.
struct Group {
    const CityJsonBlock* block;
    std::vector<const CityJsonObject*> objects;
};

using ById = std::unordered_map<std::string, const CityJsonObject*>;

const CityJsonObject* outermost(const CityJsonObject* object, const ById& byId) {
    constexpr int deepest = 16;  // limit for cycles of parents
    for (int i = 0; i < deepest && !object->parent.empty(); ++i) {
        const auto parent = byId.find(object->parent);
        if (parent == byId.end()) break;
        object = parent->second;
    }
    return object;
}

void addGroups(const CityJsonBlock& block, std::vector<Group>& groups) {
    ById byId;
    for (const CityJsonObject& object : block.objects) byId.emplace(object.id, &object);
    std::unordered_map<const CityJsonObject*, std::size_t> groupOf;
    for (const CityJsonObject& object : block.objects) {
        if (object.type == "TINRelief") continue;
        const CityJsonObject* root = outermost(&object, byId);
        const auto [place, isNew] = groupOf.try_emplace(root, groups.size());
        if (isNew) groups.push_back({&block, {root}});
        if (root != &object) groups[place->second].objects.push_back(&object);
    }
}

// Makes one building of a group and records the repairs.
class BuildingMaker {
public:
    BuildingMaker(const Group& group, const ReadSettings& settings, const Terrain* terrain,
                  const std::string& file)
        : group_(group), settings_(settings), terrain_(terrain), file_(file), root_(*group.objects.front()) {}
    Warnings warnings;
    HeightOrigins origins;  // origins of the heights of extruded objects

    // Null if nothing of it can be used.
    std::shared_ptr<const Building> make() {
        Building building{root_.id, root_.name, root_.status, {}};
        for (const CityJsonObject* object : group_.objects) addBodies(*object, building.parts);
        if (building.parts.empty())
            for (const CityJsonObject* object : group_.objects) extrude(*object, building.parts);
        if (building.parts.empty()) {
            warn(WarningKind::dropped, "has no usable geometry", root_);
            return nullptr;
        }
        markOverhangs(building.parts, findGroundUnder(building.parts));
        return std::make_shared<const Building>(std::move(building));
    }

private:
    void warn(WarningKind kind, const std::string& what, const CityJsonObject& object,
              std::size_t count = 0) {
        const std::string where = file_ + ": " + object.id;
        warnings.push_back({kind, what, count > 0 ? fmt::format("{} ({})", where, count) : where});
    }

    TriangleMesh meshOf(const std::vector<Surface>& shell, const CityJsonObject& object) {
        SurfaceMesher mesher(group_.block->vertices);
        std::size_t degenerate = 0;
        std::size_t repaired = 0;
        std::size_t tangled = 0;
        for (const Surface& surface : shell) {
            if (StopScope::isStopped()) break;
            const auto outcome = mesher.add(surface);
            degenerate += outcome == SurfaceMesher::Outcome::degenerate ? 1 : 0;
            repaired += outcome == SurfaceMesher::Outcome::repaired ? 1 : 0;
            tangled += outcome == SurfaceMesher::Outcome::tangled ? 1 : 0;
        }
        if (degenerate > 0) warn(WarningKind::dropped, "surfaces without area", object, degenerate);
        if (tangled > 0)
            warn(WarningKind::dropped, "surfaces that cross themselves too often", object, tangled);
        if (repaired > 0) warn(WarningKind::repaired, "surfaces crossed themselves", object, repaired);
        return mesher.take();
    }

    void addBodies(const CityJsonObject& object, std::vector<Part>& parts) {
        if (!object.body) return;
        for (const CityJsonBody& body : object.body->bodies) {
            if (body.empty()) continue;
            TriangleMesh mesh = meshOf(body[0], object);
            for (std::size_t i = 1; i < body.size(); ++i) {
                TriangleMesh cavity = meshOf(body[i], object);
                // The faces of a cavity point into the cavity
                if (signedVolume(cavity) > 0) turnInsideOut(cavity);
                append(mesh, cavity);
            }
            MeshParts made = partsOf(mesh, object.id, file_ + ": " + object.id);
            std::move(made.parts.begin(), made.parts.end(), std::back_inserter(parts));
            std::move(made.warnings.begin(), made.warnings.end(), std::back_inserter(warnings));
        }
    }

    // The object's own height, else that of its building.
    HeightReading heightOf(const CityJsonObject& object) {
        FeatureValues values = object.values;
        if (&object != &root_) values.insert(values.end(), root_.values.begin(), root_.values.end());
        const HeightRules rules{settings_.metresPerLevel, settings_.defaultHeightM, true};
        HeightReading reading = readHeights(values, rules, false, file_ + ": " + object.id, warnings);
        if (reading.byDefault)
            warn(WarningKind::assumed, std::string(noHeightInData) + "; the default is used", object);
        ++origins[reading.origin];
        return reading;
    }

    void extrude(const CityJsonObject& object, std::vector<Part>& parts) {
        if (!object.footprint) return;
        TriangleMesh mesh;
        for (const CityJsonBody& body : object.footprint->bodies)
            for (const auto& shell : body) append(mesh, meshOf(shell, object));
        const MeshOutline outline = computeOutline(mesh, false);
        if (outline.pieces.empty() || outline.wallsOnly) return;
        const HeightReading heights = heightOf(object);
        const float bottom =
            computeBox(mesh).low.z - (object.footprint->isAtRoof ? float(heights.topM) : 0.0F);
        for (const Footprint& piece : outline.pieces)
            parts.push_back({.sourceId = object.id,
                             .footprint = piece,
                             .bottomM = bottom,
                             .topM = bottom + float(heights.topM),
                             .heightSource = heights.source});
    }

    [[nodiscard]] std::function<float(glm::dvec2)> findGroundUnder(const std::vector<Part>& parts) const {
        float lowest = 1e30F;
        for (const Part& part : parts) lowest = std::min(lowest, part.bottomM);
        // The terrain is lowered by the earth's curvature, the parts are not yet.
        return [lowest, terrain = terrain_](glm::dvec2 at) {
            return terrain != nullptr ? std::max(lowest, elevationAt(*terrain, at) + float(earthDropM(at)))
                                      : lowest;
        };
    }

    const Group& group_;
    const ReadSettings& settings_;
    const Terrain* terrain_;
    const std::string& file_;
    const CityJsonObject& root_;
};

// CityJSON has the ground in the geometry: the walls of a building begin on it.
float lowestPoint(const Building& building) {
    float lowest = std::numeric_limits<float>::max();
    for (const Part& part : building.parts) lowest = std::min(lowest, part.bottomM);
    return lowest;
}

}  // namespace

void addTin(const CityJsonData& data, const std::string& file, FilePiece& piece) {
    TriangleMesh tin;
    for (const CityJsonBlock& block : data.blocks)
        for (const CityJsonObject& object : block.objects) {
            if (object.type != "TINRelief" || !object.body) continue;
            SurfaceMesher mesher(block.vertices);
            for (const CityJsonBody& body : object.body->bodies)
                for (const auto& shell : body)
                    for (const Surface& surface : shell) mesher.add(surface);
            append(tin, mesher.mesh());
        }
    if (tin.triangles.empty()) return;
    for (glm::vec3& vertex : tin.vertices) vertex.z -= float(earthDropM(glm::dvec2(vertex)));
    std::optional<TinTerrain> made = rasterizeTin(tin);
    if (!made) return piece.warnings.push_back({WarningKind::dropped, "the terrain has no area", file});
    if (made->filled > 0)
        piece.warnings.push_back(
            {WarningKind::repaired,
             "cells that the terrain's triangles do not cover were filled from the elevations around",
             fmt::format("{} ({} of {})", file, made->filled, countOf(made->terrain.grid.size(), "cell"))});
    made->terrain.source.file = std::filesystem::path(file).filename().string();
    piece.terrain = std::make_shared<const Terrain>(std::move(made->terrain));
}

bool addBuildings(const CityJsonData& data, const ReadSettings& settings, const std::string& file,
                  FilePiece& piece, Progress& progress, const std::stop_token& stop) {
    std::vector<Group> groups;
    for (const CityJsonBlock& block : data.blocks) addGroups(block, groups);
    std::vector<std::shared_ptr<const Building>> buildings(groups.size());
    std::vector<Warnings> warnings(groups.size());
    std::vector<HeightOrigins> origins(groups.size());
    std::atomic<std::size_t> done = 0;
    tbb::parallel_for(std::size_t(0), groups.size(), [&](std::size_t i) {
        if (stop.stop_requested()) return;
        const StopScope scope(stop);
        BuildingMaker maker(groups[i], settings, piece.terrain.get(), file);
        buildings[i] = maker.make();
        warnings[i] = std::move(maker.warnings);
        origins[i] = std::move(maker.origins);
        if (const std::size_t count = ++done; count % 64 == 0)
            progress.report(double(count) / double(groups.size()), NM_TEXT("making the buildings"));
    });
    if (stop.stop_requested()) return false;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (buildings[i]) {
            piece.groundM.push_back(lowestPoint(*buildings[i]));
            piece.buildings.push_back(std::move(buildings[i]));
        }
        std::move(warnings[i].begin(), warnings[i].end(), std::back_inserter(piece.warnings));
    }
    HeightOrigins all;
    for (const HeightOrigins& some : origins)
        for (const auto& [origin, objects] : some) all[origin] += objects;
    addHeightFacts(all, data.fields, data.unknown, file, piece.heights, piece.warnings);
    return true;
}

CityJsonTree makePlantCover(const CityJsonObject& object, TreeFacts facts) {
    CityJsonTree plants{.facts = std::move(facts)};
    for (const auto* geometry : {&object.body, &object.footprint})
        for (std::size_t i = 0; *geometry && i < (*geometry)->bodies.size(); ++i)
            for (const auto& shell : (*geometry)->bodies[i])
                plants.cover.insert(plants.cover.end(), shell.begin(), shell.end());
    for (const Surface& surface : plants.cover)
        for (const auto& ring : surface)
            plants.vertices.insert(plants.vertices.end(), ring.begin(), ring.end());
    return plants;
}

namespace {

constexpr double minPlantsM = 2;  // as of canopy rasters

// A body has walls, and a bottom below its top: each square counts once.
void addPlants(const CityJsonTree& plants, const std::vector<glm::dvec3>& vertices, const Frame& frame,
               double heightM, const std::string& file, FilePiece& piece) {
    TreeFacts facts = plants.facts;
    if (!facts.heightM && isPlausibleTreeHeight(heightM)) facts.heightM = heightM;
    if (facts.heightM && *facts.heightM < minPlantsM) {
        piece.warnings.push_back({WarningKind::leftOut, "plants lower than 2 m", facts.sourceId});
        return;
    }
    std::vector<ReadTree> columns;
    for (const Surface& surface : plants.cover) {
        std::vector<std::vector<LonLat>> rings;
        for (const auto& ring : surface) {
            rings.emplace_back();
            for (const auto vertex : ring)
                rings.back().push_back(frame.lonLatFromLocal(glm::dvec2(vertices[vertex])));
        }
        coverWithCanopy(rings, facts, columns);
    }
    std::set<std::pair<std::int64_t, std::int64_t>> squares;
    std::size_t count = 0;
    for (ReadTree& column : columns) {
        const glm::dvec2 place = frame.localFromLonLat(column.place) / std::sqrt(*column.facts.canopyCellM2);
        if (!squares.emplace(std::llround(std::floor(place.x)), std::llround(std::floor(place.y))).second)
            continue;
        piece.trees.push_back(std::move(column));
        ++count;
    }
    piece.warnings.push_back({WarningKind::assumed, std::string(woodIsClosedCanopy),
                              fmt::format("{}, {}: {}", file, facts.sourceId, countOf(count, "column"))});
}

// Where the data state no measure, that of the geometry counts.
void addTree(const CityJsonTree& tree, const std::vector<glm::dvec3>& vertices, const Frame& frame,
             const std::string& file, FilePiece& piece) {
    glm::dvec3 low(std::numeric_limits<double>::max()), high(-low);
    for (const std::size_t vertex : tree.vertices) {
        low = glm::min(low, vertices[vertex]);
        high = glm::max(high, vertices[vertex]);
    }
    const glm::dvec3 size = high - low;
    if (!std::isfinite(size.x + size.y)) return;
    if (!tree.cover.empty()) return addPlants(tree, vertices, frame, size.z, file, piece);
    ReadTree read{frame.lonLatFromLocal(glm::dvec2(low + high) / 2.0), tree.facts};
    if (!read.facts.heightM && isPlausibleTreeHeight(size.z)) read.facts.heightM = size.z;
    const double wide = std::max(size.x, size.y);
    if (!read.facts.crownDiameterM && isPlausibleCrown(wide)) read.facts.crownDiameterM = wide;
    piece.trees.push_back(std::move(read));
}

}  // namespace

void addTrees(const CityJsonData& data, const std::string& file, const Frame& frame, FilePiece& piece) {
    for (const CityJsonBlock& block : data.blocks)
        for (const CityJsonTree& tree : block.trees) addTree(tree, block.vertices, frame, file, piece);
}

namespace {

Result<FilePiece> read(const std::filesystem::path& file, const ReadSettings& settings, Progress& progress,
                       const std::stop_token& stop) {
    Result<CityJsonData> data = loadCityJson(file, settings, progress, stop);
    if (!data) return tl::make_unexpected(data.error());
    const std::string name = file.filename().string();
    const Result<Frame> frame = placeCity(*data, settings, name, stop);
    if (!frame) return tl::make_unexpected(frame.error());
    FilePiece piece{
        .warnings = std::move(data->warnings), .features = data->features, .attribution = data->attribution};
    piece.format = fmt::format("{} {}", data->sequence ? "CityJSONSeq" : "CityJSON", data->version);
    piece.crs = data->crsText;
    if (!settings.frame) piece.frame = *frame;
    addTin(*data, name, piece);
    addTrees(*data, name, *frame, piece);
    if (!addBuildings(*data, settings, name, piece, progress, stop)) return cancelled();
    if (piece.buildings.empty() && !piece.terrain)
        return failure("The file holds no usable building and no usable terrain", file.string(),
                       "Check it with a CityJSON validator");
    return piece;
}

}  // namespace

Result<FilePiece> readCityJson(const std::filesystem::path& file, const ReadSettings& settings,
                               Progress& progress, std::stop_token stop) try {
    return read(file, settings, progress, stop);
} catch (const std::exception& exception) {
    return failure(fmt::format("The city cannot be read ({})", exception.what()), file.string(),
                   "Check it with a CityJSON validator");
}

}  // namespace noonmark
