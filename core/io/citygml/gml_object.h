#pragma once

#include <string>
#include <vector>

#include "core/io/citygml/gml_geometry.h"
#include "core/io/citygml/gml_names.h"
#include "core/io/cityjson/cityjson_model.h"
#include "core/io/cityjson/file_opening.h"
#include "core/io/cityjson/lod_choice.h"
#include "core/io/cityjson/object_values.h"

namespace noonmark {

/// An object of CityGML as it is read: a building, a part of one, a terrain.
struct GmlObject {
    /// What a geometry belongs to.
    enum class Owner { object, surface, opening };
    struct Lod {
        LodProperty property;
        Owner owner;  ///< surface: collected from walls, roofs and openings; opening: from openings alone
        GmlGeometry geometry;
    };
    struct Opening {
        std::string id;  ///< may be empty
        bool isWindow;
        double lod;
        GmlGeometry geometry;
    };
    CityJsonObject object;  ///< without geometry and values
    std::vector<Lod> lods;
    std::vector<ObjectAttribute> attributes;
    std::vector<Opening> openings;

    /// Adds a geometry; those of walls, roofs and openings of the same level of detail become one.
    void add(const LodProperty& property, Owner owner, GmlGeometry geometry);
    /// Adds an attribute; the first of a name stays. "9.3" is a number.
    void add(std::string name, std::string_view text, std::string_view unit);
};

/// Makes a block of the objects that one top-level object contains, the outermost first: chooses their
/// geometries (lod_choice.h; of a building and its parts only those of the best level of detail), and keeps
/// the points that they use. `areDegrees`: offsets in metres are turned into degrees.
CityJsonBlock makeBlock(std::vector<GmlObject>& objects, const GmlGeometryReader& reader,
                        const LodChoice& choice, bool areDegrees, const std::string& file,
                        Warnings& warnings);

/// The windows and doors of an object, of the highest level of detail that has some.
std::vector<FileOpening> findOpenings(const GmlObject& object, const GmlGeometryReader& reader);

}  // namespace noonmark
