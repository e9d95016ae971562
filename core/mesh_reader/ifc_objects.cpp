#include "core/mesh_reader/ifc_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <utility>

#include "core/io/meshes/stated_axes.h"

namespace noonmark {

namespace {

// The name between the class and the id, "FZK-Haus" of "IfcBuilding_FZK-Haus_2hQBAVPOr5VxhS3Jl0O47h"; all of
// it if there is none.
std::string plainName(const std::string& name) {
    const auto first = name.find('_'), last = name.rfind('_');
    if (first == name.npos || last <= first + 1) return name;
    return name.substr(first + 1, last - first - 1);
}

}  // namespace

bool isIfc(const std::string& file) {
    std::string head(4096, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(head.data(), std::streamsize(head.size()));
    return beginsIfc(head);
}

std::string_view IfcObjects::classOf(std::string_view name) {
    if (!name.starts_with("Ifc")) return {};
    return name.substr(0, std::min(name.find('_'), name.size()));
}

bool IfcObjects::isLeftOut(std::string_view className) {
    constexpr std::array<std::string_view, 17> others{"IfcSite",
                                                      "IfcGeographicElement",
                                                      "IfcFurnishingElement",
                                                      "IfcFurniture",
                                                      "IfcVehicle",
                                                      "IfcPlant",
                                                      "IfcVirtualElement",
                                                      "IfcSpace",
                                                      "IfcAnnotation",
                                                      "IfcGrid",
                                                      "IfcOpeningElement",
                                                      "IfcZone",
                                                      "IfcSpatialZone",
                                                      "IfcSign",
                                                      "IfcProxy",
                                                      "IfcCivilElement",
                                                      "IfcSystemFurnitureElement"};
    return std::ranges::find(others, className) != others.end();
}

void IfcObjects::add(MeshObject object, const std::string& building) {
    const std::string_view className = classOf(object.name);
    if (isLeftOut(className)) {
        ++leftOut_[std::string(className)];
        return;
    }
    if (building.empty()) {
        outside_.push_back(std::move(object));
        return;
    }
    MeshObject& whole = buildings_[building];
    whole.name = plainName(building);
    whole.oneBuilding = true;
    std::ranges::move(object.pieces, std::back_inserter(whole.pieces));
}

std::vector<MeshObject> IfcObjects::take() {
    std::vector<MeshObject> objects;
    for (auto& [name, building] : buildings_) objects.push_back(std::move(building));
    for (MeshObject& object : outside_) {
        if (buildings_.empty())
            objects.push_back(std::move(object));
        else
            ++leftOut_[std::string(classOf(object.name))];
    }
    std::string note;
    for (const auto& [name, count] : leftOut_)
        note += fmt::format("{}{} ({})", note.empty() ? "" : ", ", name.empty() ? "others" : name, count);
    if (!note.empty()) objects.push_back({.name = {}, .pieces = {}, .note = note});
    return objects;
}

}  // namespace noonmark
