#pragma once

#include <optional>
#include <string_view>

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

}  // namespace noonmark
