#include "app/report/bodies/body_files.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/report/bodies/writer/body_writer.h"
#include "app/report/files/helper_library.h"
#include "core/io/bodies/write_bodies.h"
#include "core/io/files/write_text.h"
#include "core/io/write_city.h"

namespace noonmark {

namespace {

struct FloatBody {
    std::vector<float> vertices;
    std::vector<unsigned> corners;
};

// glTF: x east, y up, z south.
FloatBody roundBody(const Body& body, bool hasYUp) {
    FloatBody floats;
    for (const glm::dvec3 at : body.vertices) {
        const glm::dvec3 turned = hasYUp ? glm::dvec3(at.x, at.z, -at.y) : at;
        for (const double number : {turned.x, turned.y, turned.z}) floats.vertices.push_back(float(number));
    }
    for (const glm::uvec3 triangle : body.triangles)
        for (const unsigned corner : {triangle.x, triangle.y, triangle.z}) floats.corners.push_back(corner);
    return floats;
}

Result<void> writeByAssimp(const std::filesystem::path& file, const BodySet& set, const char* format,
                           bool hasYUp) {
    const auto write = loadHelper("noonmark-body-writer", writeBodiesName, "writes buildings");
    if (!write) return tl::make_unexpected(write.error());
    std::vector<FloatBody> floats;
    std::vector<WrittenBody> bodies;
    for (const Body& body : set.bodies) floats.push_back(roundBody(body, hasYUp));
    for (std::size_t i = 0; i < floats.size(); ++i)
        bodies.push_back({set.bodies[i].name.c_str(), floats[i].vertices.data(),
                          floats[i].vertices.size() / 3, floats[i].corners.data(),
                          floats[i].corners.size() / 3});
    const char* problem =
        reinterpret_cast<WriteBodies>(*write)(file.c_str(), format, bodies.data(), bodies.size());
    if (problem == nullptr) return {};
    return failure(fmt::format("The buildings cannot be written: {}", problem), file.string(),
                   "Check that the folder exists, is writable and has space");
}

Result<void> writeGltf(const std::filesystem::path& file, const BodySet& set) {
    return writeByAssimp(file, set, "glb2", true);
}

Result<void> writeObj(const std::filesystem::path& file, const BodySet& set) {
    return writeByAssimp(file, set, "objnomtl", false);
}

struct FormatEntry : BodyFormat {
    Result<void> (*write)(const std::filesystem::path&, const BodySet&);  // null: as a city
    bool hasUtm;  // large coordinates would be too coarse for floats
};
constexpr FormatEntry formats[] = {{{".glb", "glTF"}, &writeGltf, false},
                                   {{".obj", "OBJ"}, &writeObj, false},
                                   {{".dxf", "DXF"}, &writeBodiesDxf, true},
                                   {{".gpkg", "GeoPackage"}, nullptr, false}};

Result<const FormatEntry*> findFormat(const std::filesystem::path& file) {
    const auto* found =
        std::ranges::find(formats, file.extension().string(), [](const auto& one) { return one.ending; });
    if (found != std::end(formats)) return found;
    return failure("The format of the buildings is not known", file.string(),
                   "Give a name that ends with .glb, .obj, .dxf or .gpkg");
}

std::size_t countParts(const City& city) {
    std::size_t parts = 0;
    for (const auto& building : city.buildings) parts += building->parts.size();
    return parts;
}

Result<WrittenBodies> writeAsCity(const std::filesystem::path& file, const City& city) {
    auto warnings = writeCityGeoPackage(file, city);
    if (!warnings) return tl::make_unexpected(warnings.error());
    return WrittenBodies{city.buildings.size(), countParts(city), {}, *std::move(warnings)};
}

}  // namespace

std::span<const BodyFormat> bodyFormats() {
    static const std::vector<BodyFormat> list(std::begin(formats), std::end(formats));
    return list;
}

Result<WrittenBodies> writeBodies(const std::filesystem::path& file, const City& city,
                                  const std::set<std::string>& proposed, const BodyFileSettings& settings) {
    const auto format = findFormat(file);
    if (!format) return tl::make_unexpected(format.error());
    if (settings.plane == DrawingPlane::utm && !(*format)->hasUtm)
        return failure("Only DXF is written in a UTM zone", file.string(), "Leave out --plane, or write DXF");
    const auto isProposed = [&](const Building& building) { return proposed.contains(building.sourceId); };
    City wanted = city;
    if (settings.which == WrittenBuildings::proposed)
        std::erase_if(wanted.buildings, [&](const auto& building) { return !isProposed(*building); });
    if (wanted.buildings.empty())
        return failure("There is no building to write", "scenario",
                       "Design a tower in it, or write all buildings");
    if ((*format)->write == nullptr) return writeAsCity(file, wanted);
    const auto set = collectBodies(wanted, settings.plane, isProposed);
    if (!set) return tl::make_unexpected(set.error());
    PendingFile pending(file);
    if (const auto written = (*format)->write(pending.path(), *set); !written)
        return tl::make_unexpected(written.error());
    if (const auto done = pending.commit(); !done) return tl::make_unexpected(done.error());
    return WrittenBodies{wanted.buildings.size(), countParts(wanted), set->plane, {}};
}

}  // namespace noonmark
