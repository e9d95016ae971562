#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/citygml/gml_geometry.h"
#include "core/io/cityjson/cityjson_model.h"

namespace noonmark {

/// What an element of CityGML is, by its name without prefix; the same in versions 1.0, 2.0 and 3.0.
enum class GmlObjectKind {
    other,      ///< left out, with its name
    building,   ///< Building, BuildingPart, BuildingInstallation, BuildingConstructiveElement
    terrain,    ///< TINRelief
    container,  ///< of objects: ReliefFeature, CityObjectGroup
};
GmlObjectKind findGmlObjectKind(std::string_view name);

/// Whether an element is one around objects: cityObjectMember, featureMembers.
bool isGmlMember(std::string_view name);

/// Whether an element is a surface of a building, or an opening in one, with geometries of its own.
bool isGmlBoundary(std::string_view name);

/// Whether such a surface is a window or a door.
bool isGmlOpening(std::string_view name);

/// Whether a property holds what shades nothing or is no part of the object: rooms, addresses, appearances.
bool isGmlAside(std::string_view name);

/// What the name of a property says of the geometry in it.
struct LodProperty {
    enum class Shape { body, footprint, roofEdge };
    double lod = 0;
    Shape shape = Shape::body;
};

/// "lod2Solid", "lod0FootPrint", "tin". Nothing for properties with curves, points or no geometry.
std::optional<LodProperty> findLodProperty(std::string_view name);

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
/// geometries (cityjson_model.h; of a building and its parts only those of the best level of detail), and
/// keeps the points that they use. `areDegrees`: offsets in metres are turned into degrees.
CityJsonBlock makeBlock(std::vector<GmlObject>& objects, const GmlGeometryReader& reader,
                        const LodChoice& choice, bool areDegrees, const std::string& file,
                        Warnings& warnings);

/// The windows and doors of an object, of the highest level of detail that has some.
std::vector<FileOpening> findOpenings(const GmlObject& object, const GmlGeometryReader& reader);

}  // namespace noonmark
