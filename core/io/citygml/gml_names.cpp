#include "core/io/citygml/gml_names.h"

#include <algorithm>
#include <array>

namespace noonmark {

namespace {

using namespace std::string_view_literals;

template <std::size_t count>
bool isAmong(const std::array<std::string_view, count>& names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
}

constexpr std::array gmlBuildings{"Building"sv, "BuildingPart"sv, "BuildingInstallation"sv,
                                  "BuildingConstructiveElement"sv};
constexpr std::array gmlContainers{"ReliefFeature"sv, "CityObjectGroup"sv};
constexpr std::array gmlMembers{"cityObjectMember"sv, "featureMember"sv,   "featureMembers"sv,
                                "member"sv,           "reliefComponent"sv, "groupMember"sv};
// Openings stand in the holes of walls and roofs. Surfaces of rooms are not among them.
constexpr std::array gmlBoundaries{
    "WallSurface"sv,       "RoofSurface"sv, "GroundSurface"sv,  "Window"sv,        "OuterCeilingSurface"sv,
    "OuterFloorSurface"sv, "Door"sv,        "ClosureSurface"sv, "WindowSurface"sv, "DoorSurface"sv};
constexpr std::array gmlAsides{"address"sv,           "externalReference"sv,
                               "appearance"sv,        "appearanceMember"sv,
                               "interiorRoom"sv,      "interiorBuildingInstallation"sv,
                               "interiorFurniture"sv, "buildingRoom"sv,
                               "buildingFurniture"sv, "buildingSubdivision"sv,
                               "generalizesTo"sv,     "relatedTo"sv,
                               "dynamizer"sv,         "occupancy"sv,
                               "metaDataProperty"sv};

}  // namespace

GmlObjectKind findGmlObjectKind(std::string_view name) {
    if (isAmong(gmlBuildings, name)) return GmlObjectKind::building;
    if (name == "TINRelief") return GmlObjectKind::terrain;
    return isAmong(gmlContainers, name) ? GmlObjectKind::container : GmlObjectKind::other;
}

bool isGmlMember(std::string_view name) { return isAmong(gmlMembers, name); }
bool isGmlBoundary(std::string_view name) { return isAmong(gmlBoundaries, name); }
bool isGmlOpening(std::string_view name) { return name.starts_with("Window") || name.starts_with("Door"); }
bool isGmlAside(std::string_view name) { return isAmong(gmlAsides, name); }

std::optional<LodProperty> findLodProperty(std::string_view name) {
    using Shape = LodProperty::Shape;
    if (name == "tin") return LodProperty{1, Shape::body};
    if (!name.starts_with("lod") || name.size() < 5 || name[3] < '0' || name[3] > '4') return std::nullopt;
    const double lod = name[3] - '0';
    const std::string_view shape = name.substr(4);
    if (shape == "FootPrint") return LodProperty{lod, Shape::footprint};
    if (shape == "RoofEdge") return LodProperty{lod, Shape::roofEdge};
    constexpr std::array bodies{"Solid"sv, "MultiSurface"sv, "Geometry"sv, "ImplicitRepresentation"sv,
                                "Surface"sv};
    if (!isAmong(bodies, shape)) return std::nullopt;
    return LodProperty{lod, lod < 1 ? Shape::footprint : Shape::body};
}

}  // namespace noonmark
