#pragma once

// The folder core/io/cityjson reads CityJSON and CityJSONSeq. cityjson_buildings.cpp runs the steps:
// cityjson_load.cpp parses the file into the plain values of this file and chooses the level of detail;
// cityjson_place.cpp transforms them to local metres; cityjson_buildings.cpp makes buildings and terrain.
// cityjson_load.h declares these steps. CityGML (core/io/citygml) is another notation of the same model, and
// uses the same values.

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/warnings.h"
#include "core/city/meshes/surface_mesher.h"
#include "core/city/trees/tree_facts.h"
#include "core/io/heights/field_roles.h"
#include "core/io/heights/unknown_fields.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

/// A surface that a city model marks as window or door, in the coordinates of its file: easting or longitude
/// first.
struct FileOpening {
    std::string id;
    std::vector<glm::dvec3> corners;  ///< of its outer ring
};

/// Which geometry of an object to choose.
struct LodChoice {
    std::optional<double> wished;  ///< the wanted level of detail; empty: the highest that exists
};

/// Parses ReadSettings::lod. Error: not a number.
Result<LodChoice> parseLodChoice(const std::string& lod);

/// What a geometry is chosen by.
struct LodRank {
    double lod = 0;
    bool solid = false;
};

/// Whether `a` is the better choice: of the levels of detail the highest that does not exceed the wanted one,
/// else the lowest; solids before surfaces.
bool isBetter(const LodRank& a, const LodRank& b, const LodChoice& choice);

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

/// A single tree (SolitaryVegetationObject), or an area of plants (PlantCover).
struct CityJsonTree {
    TreeFacts facts;
    std::vector<std::size_t> vertices;  ///< of its geometry or its reference point, in range; at least one
    std::vector<Surface> cover;         ///< the surfaces of an area of plants
};

/// Objects that share vertices: a whole CityJSON file, or one feature of a sequence.
struct CityJsonBlock {
    std::vector<glm::dvec3> vertices;
    std::vector<CityJsonObject> objects;  ///< the surfaces' indices are in range
    std::vector<CityJsonTree> trees;
};

struct CityJsonData {
    std::string crs;      ///< empty: not stated
    std::string crsText;  ///< FilePiece::crs; set by placeCity()
    std::string version;
    std::string attribution;
    bool sequence = false;
    std::vector<CityJsonBlock> blocks;
    std::size_t features = 0;        ///< all objects read, including those left out
    std::vector<KnownField> fields;  ///< attributes of buildings, by name
    UnknownFields unknown;           ///< attributes whose names are unknown
    Warnings warnings;
};

/// An attribute of an object, as its file writes it.
struct ObjectAttribute {
    std::string name;
    std::string text;                     ///< a number in decimal; empty if it is neither text nor number
    std::optional<double> number;         ///< if the file states it as one
    std::optional<LengthUnit> unit = {};  ///< stated with the value
};

/// Finds out which attributes of the objects of a file determine heights.
class ObjectValues {
public:
    /// `settings` must outlive it.
    explicit ObjectValues(const ReadSettings& settings) : settings_(settings) {}

    /// Fills the object's values and adds to the data's fields and unknown fields. Objects may have different
    /// attributes: the meaning of a field is decided among the attributes of the same object.
    void add(const std::vector<ObjectAttribute>& attributes, CityJsonObject& object, CityJsonData& data);

private:
    void learnFields(const std::vector<ObjectAttribute>& attributes, CityJsonData& data);

    const ReadSettings& settings_;
    // Of the previous object: most have the attributes of the one before.
    std::vector<std::string> names_, unknown_;
    std::vector<KnownField> fields_;
};

}  // namespace noonmark
