#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/city/meshes/surface_mesher.h"
#include "core/io/footprints/feature_value.h"
#include "core/io/footprints/field_roles.h"
#include "core/io/footprints/unknown_fields.h"

namespace noonmark {

/// What is read of CityJSON before it has a place: plain values, still in the file's coordinates.

/// A solid's shells, the outer one first and cavities after it; or the one shell of a multi-surface, which
/// may be open.
using CityJsonBody = std::vector<std::vector<Surface>>;

struct CityJsonGeometry {
    double lod = 0;
    bool solid = false;
    std::vector<CityJsonBody> bodies;  ///< one, or several of a multi- or composite solid
};

struct CityJsonObject {
    std::string id;
    std::string type;    ///< "Building", "BuildingPart", "BuildingInstallation" or "TINRelief"
    std::string parent;  ///< id; empty for none
    std::string name;
    std::string status;
    FeatureValues values;                       ///< attributes that make a height; see knownFields
    std::optional<CityJsonGeometry> body;       ///< of the level of detail that was chosen
    std::optional<CityJsonGeometry> footprint;  ///< of level of detail 0
};

/// Objects that share vertices: a whole CityJSON file, or one feature of a sequence.
struct CityJsonBlock {
    std::vector<glm::dvec3> vertices;
    std::vector<CityJsonObject> objects;  ///< the surfaces' indices are in range
};

struct CityJsonData {
    std::string crs;  ///< empty: none stated
    std::string version;
    std::string attribution;
    bool sequence = false;
    std::vector<CityJsonBlock> blocks;
    std::size_t features = 0;        ///< objects read in all, also those left out
    std::vector<KnownField> fields;  ///< attributes of buildings, by name
    UnknownFields unknown;           ///< those that mean nothing to us
    Warnings warnings;
};

}  // namespace noonmark
