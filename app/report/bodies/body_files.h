#pragma once

#include <filesystem>
#include <set>
#include <span>
#include <string>

#include "core/base/warnings.h"
#include "core/io/bodies/write_bodies.h"

namespace noonmark {

/// A format for bodies.
struct BodyFormat {
    const char* ending;  ///< of the file: ".glb"
    const char* name;    ///< the same in every language: "glTF"
};
/// Binary glTF, OBJ, DXF and GeoPackage.
std::span<const BodyFormat> bodyFormats();

enum class WrittenBuildings { all, proposed };

struct BodyFileSettings {
    WrittenBuildings which = WrittenBuildings::all;
    DrawingPlane plane = DrawingPlane::local;  ///< utm: of DXF only
};

struct WrittenBodies {
    std::size_t buildings = 0, parts = 0;
    std::string plane;  ///< in words: where (0, 0) lies; empty of a GeoPackage
    Warnings warnings;
};

/// Writes buildings of a city as bodies in the format that the file's name ends with. `proposed`: ids of
/// those that the scenario added. glTF has y upwards, as its standard says, all others z; a GeoPackage has
/// prisms in WGS84, each other format triangles. Written beside the file and renamed. Error: there is no such
/// building or format, the format has no such plane, or the file cannot be written.
Result<WrittenBodies> writeBodies(const std::filesystem::path& file, const City& city,
                                  const std::set<std::string>& proposed, const BodyFileSettings& settings);

}  // namespace noonmark
