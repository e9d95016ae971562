#include "core/io/meshes/mesh_units.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <iterator>
#include <memory>

#include "core/base/stop_scope.h"
#include "core/city/meshes/mesh_parts.h"
#include "core/city/meshes/mesh_topology.h"
#include "core/city/meshes/surface_mesher.h"
#include "core/describe/text.h"
#include "core/geo/lon_lat.h"
#include "core/io/files/plain_file.h"
#include "core/io/formats/format.h"
#include "core/io/heights/height_text.h"
#include "core/io/meshes/ifc_site.h"
#include "core/io/meshes/mesh_placement.h"
#include "core/io/meshes/mesh_reader_process.h"
#include "core/io/meshes/stated_axes.h"
#include "core/io/pieces/read_part.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

namespace {

// Adds units to a piece as buildings.
class BuildingAdder {
public:
    BuildingAdder(const std::vector<NamedMesh>& objects, const std::string& file, FilePiece& piece)
        : objects_(objects), file_(file), piece_(piece) {}

    void add(const std::vector<MeshUnit>& units, Progress& progress, const std::stop_token& stop) {
        std::vector<std::size_t> ofObject(objects_.size());
        for (const MeshUnit& unit : units) ++ofObject[unit.object];
        std::vector<std::size_t> number(objects_.size());
        std::vector<std::string> ids;
        for (const MeshUnit& unit : units) {
            const std::string& name = objects_[unit.object].name;
            const std::string id = name.empty() ? "mesh" : name;
            const std::size_t n = ++number[unit.object];
            ids.push_back(ofObject[unit.object] == 1 ? id : fmt::format("{} {}", id, n));
        }
        std::vector<MeshParts> made = makeParts(units, ids, progress, stop);
        for (std::size_t i = 0; i < units.size() && !stop.stop_requested(); ++i)
            add(std::move(made[i]), objects_[units[i].object].name, ids[i]);
    }

private:
    [[nodiscard]] std::vector<MeshParts> makeParts(const std::vector<MeshUnit>& units,
                                                   const std::vector<std::string>& ids, Progress& progress,
                                                   const std::stop_token& stop) const {
        std::vector<MeshParts> made(units.size());
        std::atomic<std::size_t> done = 0;
        tbb::parallel_for(std::size_t{0}, units.size(), [&](std::size_t i) {
            const StopScope scope(stop);
            if (StopScope::isStopped()) return;
            made[i] = partsOf(units[i].mesh, ids[i], file_ + ": " + ids[i]);
            progress.report(double(++done) / double(units.size()), NM_TEXT("finding the buildings"));
        });
        return made;
    }

    void add(MeshParts made, const std::string& name, const std::string& id) {
        std::ranges::move(made.warnings, std::back_inserter(piece_.warnings));
        if (made.parts.empty()) return;
        markOverhangs(made.parts, [](glm::dvec2) { return 0.0F; });
        for (Part& part : made.parts) closeToTheGround(part);
        piece_.buildings.push_back(
            std::make_shared<const Building>(Building{id, name, {}, std::move(made.parts)}));
    }

    // A deck: every engine treats it as solid down to the ground.
    static void closeToTheGround(Part& part) {
        const bool isSlab = !part.mesh && part.topM - part.bottomM < 2 * levelSheetM;
        if (isSlab && !part.isOverhanging && part.bottomM > 0 && part.bottomM <= openAirM) part.bottomM = 0;
    }

    const std::vector<NamedMesh>& objects_;
    const std::string& file_;
    FilePiece& piece_;
};

// The lowest point of each building is its base.
void stateBases(FilePiece& piece) {
    piece.ownZero = true;
    for (const auto& building : piece.buildings)
        piece.groundM.emplace_back(std::ranges::min_element(building->parts, {}, &Part::bottomM)->bottomM);
}

}  // namespace

bool addBuildings(const std::vector<NamedMesh>& objects, const std::string& file, FilePiece& piece,
                  Progress& progress, const std::stop_token& stop) {
    progress.report(0, NM_TEXT("finding the buildings"));
    const std::vector<NamedMesh> joined = joinSurfaces(objects);
    BuildingAdder adder(joined, file, piece);
    adder.add(detectUnits(joined, file, piece.warnings, stop), progress, stop);
    stateBases(piece);
    return !stop.stop_requested();
}

namespace {

constexpr const char* ifcFormat = "IFC";

struct FaceCounts {
    std::size_t broken = 0;  // corners with invalid indices, as in broken files; Assimp does not always check
    std::size_t degenerate = 0;  // faces without area
    std::size_t tangled = 0;     // faces that cross themselves too often
    void add(SurfaceMesher::Outcome outcome) {
        degenerate += outcome == SurfaceMesher::Outcome::degenerate ? 1 : 0;
        tangled += outcome == SurfaceMesher::Outcome::tangled ? 1 : 0;
    }
};

FaceCounts addFaces(const MeshPiece& piece, SurfaceMesher& mesher) {
    FaceCounts counts;
    auto corner = piece.corners.begin();
    for (const std::uint32_t count : piece.cornerCounts) {
        std::vector<std::uint32_t> ring(corner, corner + count);
        corner += count;
        if (*std::max_element(ring.begin(), ring.end()) >= piece.points.size())
            ++counts.broken;
        else
            counts.add(mesher.add({std::move(ring)}));
    }
    return counts;
}

struct SceneReader {
    const MeshPlacement& placement;
    std::string file;
    bool ifc = false;
    double outlineHeightM = 0;
    std::vector<NamedMesh> objects;
    Warnings warnings;

    void add(const MeshObject& read) {
        if (!read.note.empty())
            warnings.push_back({WarningKind::leftOut,
                                ifc ? "objects of the IFC that belong to no building"
                                    : "drawing entities that are no masses",
                                fmt::format("{}: {}", file, read.note)});
        if (read.isOpening()) return;
        if (read.kind == MeshObject::Kind::outlines) return addOutlines(read);
        NamedMesh object{read.name, {}, read.parent};
        object.oneBuilding = read.kind == MeshObject::Kind::building;
        for (const MeshPiece& piece : read.pieces) addPiece(piece, object);
        if (!object.mesh.triangles.empty()) objects.push_back(std::move(object));
    }

    // A building for each.
    void addOutlines(const MeshObject& read) {
        for (const MeshPiece& piece : read.pieces) {
            const std::vector<glm::dvec3> points = placement.local(piece);
            auto corner = piece.corners.begin();
            for (const std::uint32_t count : piece.cornerCounts) {
                std::vector<std::uint32_t> ring(corner, corner + count);
                corner += count;
                NamedMesh object{read.name, {}, read.parent};
                object.oneBuilding = true;
                if (std::ranges::max(ring) < points.size()) extrude(ring, points, object);
                if (!object.mesh.triangles.empty()) objects.push_back(std::move(object));
            }
        }
    }

    void extrude(const std::vector<std::uint32_t>& ring, const std::vector<glm::dvec3>& points,
                 NamedMesh& object) const {
        std::vector<glm::dvec3> corners;
        for (const double heightM : {0.0, outlineHeightM})
            for (const std::uint32_t i : ring) corners.push_back(points[i] + glm::dvec3(0, 0, heightM));
        const auto count = std::uint32_t(ring.size());
        std::vector<std::uint32_t> low(count), high(count);
        SurfaceMesher mesher(corners);
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t next = (i + 1) % count;
            low[count - 1 - i] = i, high[i] = count + i;
            mesher.add({{i, next, count + next, count + i}});
        }
        mesher.add({low});
        mesher.add({high});
        append(object.mesh, mesher.mesh());
    }

    void addPiece(const MeshPiece& piece, NamedMesh& object) {
        const std::vector<glm::dvec3> points = placement.local(piece);
        SurfaceMesher mesher(points);
        const FaceCounts counts = addFaces(piece, mesher);
        append(object.mesh, mesher.mesh());
        warn(WarningKind::dropped, "faces with missing corners", object.name, counts.broken);
        warn(WarningKind::dropped, "faces that cross themselves too often", object.name, counts.tangled);
        warn(WarningKind::repaired, "faces without area were left out", object.name, counts.degenerate);
    }

    void warn(WarningKind kind, const char* what, const std::string& object, std::size_t count) {
        if (count > 0) warnings.push_back({kind, what, fmt::format("{}: {} ({})", file, object, count)});
    }
};

// Most of a mesh lies near its own origin; of one in map coordinates near the middle of the other files.
Result<void> checkDistance(const std::vector<NamedMesh>& objects, const std::filesystem::path& file,
                           const MeshPlacement& placement, double farAwayM) {
    std::vector<double> distances;
    const glm::dvec2 origin = placement.origin();
    for (const NamedMesh& object : objects)
        for (const glm::vec3 vertex : object.mesh.vertices)
            distances.push_back(std::hypot(double(vertex.x) - origin.x, double(vertex.y) - origin.y));
    std::erase_if(distances, [](double distance) { return !std::isfinite(distance); });
    if (distances.empty()) return failure("The file holds no triangles", file.string(), trianglesAdvice);
    const auto middle = distances.begin() + std::ptrdiff_t(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    if (*middle <= farAwayM) return {};
    if (placement.isOnMap())
        return failure(fmt::format("The mesh lies {:.0f} km from the other files", *middle / 1000),
                       file.string(),
                       fmt::format("Check its coordinate reference system ({})", readOption("crs")));
    return failure(fmt::format("The mesh lies {:.0f} km from its own origin", *middle / 1000), file.string(),
                   fmt::format("Check its unit; if its coordinates are those of a map, state their "
                               "coordinate reference system ({})",
                               readOption("crs", "EPSG:number")));
}

// Drops triangles with a corner beyond the range of a Frame, as in broken files.
void dropFarTriangles(SceneReader& reader) {
    constexpr float maxM = 1e6F;  // limit of a Frame
    for (NamedMesh& object : reader.objects) {
        const auto isFar = [&](const glm::uvec3& corners) {
            for (int i = 0; i < 3; ++i)
                if (!glm::all(glm::lessThan(glm::abs(object.mesh.vertices[corners[i]]), glm::vec3(maxM))))
                    return true;
            return false;
        };
        const std::size_t dropped = std::erase_if(object.mesh.triangles, isFar);
        reader.warn(WarningKind::dropped, "triangles more than 1,000 km away", object.name, dropped);
    }
}

// Decided by the content, whatever the file's name.
std::string formatOf(const std::filesystem::path& file) {
    const auto format = detectFormat(file);
    const bool isMesh = format && (*format)->reader.kind == FileKind::mesh;
    return isMesh ? std::string((*format)->nameInResults()) : "mesh";
}

void warnOfUnusedPlace(const IfcSite& site, const ReadSettings& settings, SceneReader& reader) {
    const auto place = findPlace(site);
    if (place && settings.meshAnchor == place->origin) return;
    if (const std::string words = describe(site); !words.empty())
        reader.warnings.push_back(
            {WarningKind::leftOut, fmt::format("{}: {}", unusedIfcPlace, words), reader.file});
}

// A house is set on the ground with its cellar below, unless elevations are asked for.
double zeroOf(const IfcSite& site, const ReadSettings& settings) {
    const auto place = settings.stand == Stand::absolute ? findPlace(site) : std::nullopt;
    return place ? place->elevationM : 0;
}

// Of a drawing that holds nothing but outlines, which may be those of lots.
Result<void> checkOutlines(const MeshScene& scene, const std::filesystem::path& file,
                           const ReadSettings& settings, Warnings& warnings) {
    const auto isOutlines = [](const MeshObject& object) {
        return object.kind == MeshObject::Kind::outlines;
    };
    if (std::ranges::none_of(scene, isOutlines)) return {};
    std::string others;
    for (const MeshObject& object : scene)
        if (!object.note.empty()) others += (others.empty() ? "" : ", ") + object.note;
    if (settings.defaultHeightM == ReadSettings{}.defaultHeightM)
        return failure(
            "The DXF holds no mass, only " + others, file.string(),
            fmt::format("State the height of its outlines ({}), give them a thickness, or draw masses "
                        "as 3D faces or meshes",
                        readOption("default_height_m", "METRES")));
    warnings.push_back({WarningKind::assumed,
                        fmt::format("outlines without a thickness are {:g} m high ({})",
                                    settings.defaultHeightM, readOption("default_height_m")),
                        file.filename().string()});
    return {};
}

Warning describeUnit(const StatedAxes& stated, const std::string& file) {
    if (!stated.metresPerUnit)
        return {WarningKind::assumed, "the DXF states no unit; that of the reading settings is used", file};
    return {WarningKind::assumed, fmt::format("the coordinates are in {}, as the file states", stated.unit),
            file};
}

}  // namespace

Result<FilePiece> describeScenePiece(const MeshScene& scene, const std::filesystem::path& file,
                                     const ReadSettings& settings, Progress& progress,
                                     const std::stop_token& stop) {
    const auto stated = findStatedAxes(file);
    Warnings assumed;
    const std::string format = formatOf(file);
    const IfcSite site = format == ifcFormat ? readIfcSite(file, stop) : IfcSite{};
    const MeshFile described{file.string(), file.filename().string(), format, stated, zeroOf(site, settings)};
    const auto placement = MeshPlacement::of(scene, described, settings, assumed);
    if (!placement) return tl::make_unexpected(placement.error());
    if (const auto checked = checkOutlines(scene, file, settings, assumed); !checked)
        return tl::make_unexpected(checked.error());
    SceneReader reader{*placement, described.name,    format == ifcFormat, settings.defaultHeightM,
                       {},         std::move(assumed)};
    if (stated) reader.warnings.push_back(describeUnit(*stated, reader.file));
    if (reader.ifc) warnOfUnusedPlace(site, settings, reader);
    for (const MeshObject& object : scene) {
        if (stop.stop_requested()) return cancelled();
        reader.add(object);
    }
    if (const auto near = checkDistance(reader.objects, file, *placement, settings.farAwayM); !near)
        return tl::make_unexpected(near.error());
    dropFarTriangles(reader);
    FilePiece result{
        .warnings = std::move(reader.warnings), .format = format, .features = reader.objects.size()};
    if (placement->isOnMap()) result.crs = describeCrs(placement->crsName(), CrsSource::user);
    if (!settings.frame) result.frame = placement->frame();
    if (!settings.meshAnchor && !placement->isOnMap())
        result.warnings.push_back({WarningKind::assumed, std::string(originAsAnchor), reader.file});
    if (!addBuildings(reader.objects, reader.file, result, progress, stop)) return cancelled();
    if (result.buildings.empty())
        return failure("The file holds no building: its meshes are flat ground or have no area",
                       file.string(), trianglesAdvice);
    return result;
}

namespace {

// Where an IFC states its place, and the user none.
std::optional<IfcPlace> ownPlace(const std::filesystem::path& file, const ReadSettings& settings,
                                 const std::stop_token& stop) {
    if (settings.meshAnchor || settings.crs || formatOf(file) != ifcFormat) return std::nullopt;
    auto place = findPlace(readIfcSite(file, stop));
    const bool isFar = place && settings.frame &&
                       computeGreatCircleM(place->origin, settings.frame->origin()) > settings.farAwayM;
    return isFar ? std::nullopt : std::move(place);
}

constexpr std::string_view plyFormat = "PLY";

void addOffset(MeshScene& scene, glm::dvec3 offset) {
    for (MeshObject& object : scene)
        for (MeshPiece& piece : object.pieces) piece.origin += offset;
}

Warning describeOffset(glm::dvec3 offset, const std::filesystem::path& file) {
    return {WarningKind::assumed,
            fmt::format("its points count from the offset in a comment of the file, {:.10g} {:.10g} {:.10g}",
                        offset.x, offset.y, offset.z),
            file.filename().string()};
}

Warning describePlace(const IfcPlace& place, const std::filesystem::path& file) {
    return {WarningKind::assumed,
            fmt::format("it stands where it states ({}): {} {:.6f},{:.6f}, {} {:.4g}", place.words,
                        readOption("mesh_anchor"), place.origin.lonDeg, place.origin.latDeg,
                        readOption("mesh_north_deg"), place.northDeg),
            file.filename().string()};
}

}  // namespace

Result<FilePiece> readMesh(const std::filesystem::path& file, const ReadSettings& given, Progress& progress,
                           std::stop_token stop) try {
    ReadSettings settings = given;
    const auto own = ownPlace(file, given, stop);
    if (own) {
        settings.meshAnchor = own->origin;
        if (settings.meshNorthDeg == 0) settings.meshNorthDeg = own->northDeg;
    }
    if (!settings.frame && !settings.meshAnchor && !settings.crs)
        return failure("The mesh has no position", file.string(), anchorAdvice());
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(file, error);
    if (error)
        return failure("The file cannot be opened", file.string(),
                       "Check that it is a plain file, and that you have permission to read it");
    progress.report(0, NM_TEXT("reading the mesh"));
    auto scene = readMeshScene(file, meshReaderLimits(bytes), stop);
    if (!scene) return tl::make_unexpected(scene.error());
    std::optional<glm::dvec3> offset;
    if (settings.crs && !settings.meshAnchor && formatOf(file) == plyFormat) offset = readPlyOffset(file);
    if (offset) addOffset(*scene, *offset);
    auto piece = describeScenePiece(*scene, file, settings, progress, stop);
    if (piece && own) piece->warnings.push_back(describePlace(*own, file));
    if (piece && offset) piece->warnings.push_back(describeOffset(*offset, file));
    return piece;
} catch (const std::exception& exception) {
    return failure(fmt::format("The mesh cannot be read ({})", exception.what()), file.string(),
                   "Export it again");
}

}  // namespace noonmark
