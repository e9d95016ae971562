#include "scenarios/edits/read_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "core/io/files/plain_file.h"
#include "core/io/meshes/ifc_site.h"
#include "core/io/settings/read_settings.h"
#include "core/io/terrain/standing.h"

namespace noonmark {

namespace {

// What a user states of one file: the project knows the rest.
void copyStated(const ReadSettings& from, ReadSettings& to) {
    to.upAxis = from.upAxis;
    to.meshUnit = from.meshUnit;
    to.stand = from.stand;
    to.crs = from.crs;
    to.lod = from.lod;
}

std::string formatReading(const ReadSettings& settings) {
    ReadSettings chosen;
    copyStated(settings, chosen);
    return formatText(chosen);
}

Building joinBuildings(const City& city, const std::string& id) {
    Building whole{.sourceId = id, .name = id};
    for (const auto& building : city.buildings)
        whole.parts.insert(whole.parts.end(), building->parts.begin(), building->parts.end());
    return whole;
}

double lowestM(const Building& building) {
    float lowest = 1e30F;
    for (const Part& part : building.parts) lowest = std::min(lowest, part.bottomM);
    return double(lowest);
}

// A mesh that begins above its own zero, or lies mostly below it, has elevations. The user may scale it
// later, so that only the proportions of a basement are known.
bool isLowered(const Building& mesh, Stand wanted) {
    if (wanted != Stand::automatic) return wanted == Stand::terrain;
    const double low = lowestM(mesh);
    return !countsFromZero(low) && (low > 0 || -low > double(topM(mesh)));
}

Warning describeLowered(const Building& mesh, const std::filesystem::path& file) {
    return {
        WarningKind::assumed,
        fmt::format(
            "the mesh does not begin at its own zero: its lowest point was set on the ground ({} leaves it)",
            readOption("stand", "absolute")),
        fmt::format("{} ({:.1f} m)", file.filename().string(), lowestM(mesh))};
}

}  // namespace

void applyReading(const ImportMesh& import, ReadSettings& settings) {
    copyStated(readSettingsFrom(import.reading).value_or(ReadSettings{}), settings);
    settings.meshScale = import.readScale;
}

ImportMesh asEditionOf(ImportMesh edition, const ImportMesh& earlier) {
    Building shape = *edition.shape;
    shape.sourceId = earlier.shape->sourceId;
    shape.name = earlier.shape->name;
    edition.shape = std::make_shared<const Building>(std::move(shape));
    return edition;
}

Result<ImportMesh> readShape(const std::filesystem::path& file, const std::string& id,
                             const ReadSettings& settings, const Frame& frame, Warnings& warnings,
                             Progress& progress, std::stop_token stop) {
    const auto kind = detectFileKind(file);
    if (!kind) return tl::make_unexpected(kind.error());
    ReadSettings here = settings;
    here.frame = Frame(frame.origin());  // heights are the shape's own
    here.stand = Stand::absolute;        // its parts keep their places to each other
    here.terrainFromBases = TerrainFromBases::never;
    // The user places it; only one in map coordinates has a place of its own.
    if (*kind == FileKind::mesh) here.meshAnchor = here.crs ? std::nullopt : std::optional(frame.origin());
    auto read = readCity({file}, here, progress, std::move(stop));
    if (!read) return tl::make_unexpected(read.error());
    std::ranges::copy_if(read->warnings, std::back_inserter(warnings),
                         [](const Warning& warning) { return warning.what != originAsAnchor; });
    Building whole = joinBuildings(read->city, id);
    if (whole.parts.empty())
        return failure("The file contains no building", file.string(),
                       "Export the building as a closed solid");
    if (*kind != FileKind::mesh || isLowered(whole, settings.stand)) {
        if (*kind == FileKind::mesh) warnings.push_back(describeLowered(whole, file));
        const double footM = lowestM(whole);  // before the building is moved from: arguments have no order
        whole = liftBuilding(std::move(whole), -footM);
        redetectOverhangs(whole, [](glm::dvec2) { return 0.0F; });
    }
    return ImportMesh{.shape = std::make_shared<const Building>(std::move(whole)),
                      .placement = {},
                      .file = file.filename().string(),
                      .reading = formatReading(settings),
                      .readScale = settings.meshScale};
}

OwnPlace findOwnPlace(const std::filesystem::path& file, const Frame& frame, const std::stop_token& stop) {
    const auto format = detectFormat(file);
    if (!format || !(*format)->name.starts_with("IFC")) return {};
    const IfcSite site = readIfcSite(file, stop);
    const auto place = findPlace(site);
    if (!place) return {site.trueNorthDeg ? std::optional(-*site.trueNorthDeg) : std::nullopt};
    constexpr double nearM = 20'000;
    const glm::dvec2 origin = frame.localFromLonLat(place->origin);
    if (glm::length(origin) >= nearM) return {place->northDeg};
    return {place->northDeg, origin, place->words};
}

}  // namespace noonmark
