#pragma once

// The folder core/io/cityjson reads CityJSON and CityJSONSeq. read_cityjson.cpp runs the steps:
// cityjson_load.h parses the file into the plain values of this file, with cityjson_geometry.h choosing the
// level of detail; cityjson_place.h transforms them to local metres; cityjson_buildings.h makes buildings and
// terrain. CityGML (core/io/citygml) is another notation of the same model, and uses the same values.

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/warnings.h"
#include "core/city/meshes/surface_mesher.h"
#include "core/city/trees/tree_facts.h"
#include "core/io/heights/feature_value.h"
#include "core/io/heights/field_roles.h"
#include "core/io/heights/unknown_fields.h"

namespace noonmark {

/// CityJSON as plain values, still in the file's coordinates.

/// The shells of a solid: the outer one first, then cavities. For a multi-surface its one shell, which may be
/// open.
using CityJsonBody = std::vector<std::vector<Surface>>;

struct CityJsonGeometry {
    double lod = 0;
    bool solid = false;
    std::vector<CityJsonBody> bodies;  ///< one, or several for a multi- or composite solid
    bool isAtRoof = false;             ///< a footprint whose z is that of the roof's edge
};

struct CityJsonObject {
    std::string id;
    std::string type;    ///< "Building", "BuildingPart", "BuildingInstallation" or "TINRelief"
    std::string parent;  ///< id; empty for none
    std::string name;
    std::string status;
    FeatureValues values;                       ///< attributes that determine heights; see knownFields
    std::optional<CityJsonGeometry> body;       ///< geometry of the chosen level of detail
    std::optional<CityJsonGeometry> footprint;  ///< geometry of level of detail 0
};

/// A single tree (SolitaryVegetationObject).
struct CityJsonTree {
    TreeFacts facts;
    std::vector<std::size_t> vertices;  ///< of its geometry or its reference point, in range; at least one
};

/// Objects that share vertices: a whole CityJSON file, or one feature of a sequence.
struct CityJsonBlock {
    std::vector<glm::dvec3> vertices;
    std::vector<CityJsonObject> objects;  ///< the surfaces' indices are in range
    std::vector<CityJsonTree> trees;
};

struct CityJsonData {
    std::string crs;       ///< empty: not stated
    std::string crsWords;  ///< FilePiece::crs; set by placeCity()
    std::string version;
    std::string attribution;
    bool sequence = false;
    std::vector<CityJsonBlock> blocks;
    std::size_t features = 0;        ///< all objects read, including those left out
    std::vector<KnownField> fields;  ///< attributes of buildings, by name
    UnknownFields unknown;           ///< attributes whose names are unknown
    Warnings warnings;
};

}  // namespace noonmark
