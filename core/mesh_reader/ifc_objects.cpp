#include "core/mesh_reader/ifc_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <utility>

#include "core/io/meshes/stated_axes.h"

namespace noonmark {

namespace {

// The name between the class and the id of 22 letters, "FZK-Haus" of
// "IfcBuilding_FZK-Haus_2hQBAVPOr5VxhS3Jl0O47h"; all of it if there is none. Ids may hold underscores.
std::string plainName(const std::string& name) {
    constexpr std::size_t idLength = 22;
    const auto first = name.find('_');
    if (first == name.npos) return name;
    const bool hasId = name.size() > idLength && name[name.size() - idLength - 1] == '_';
    const auto last = hasId ? name.size() - idLength - 1 : name.rfind('_');
    return last <= first + 1 ? name : name.substr(first + 1, last - first - 1);
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

void IfcWithin::enter(const std::string& node, double elevationM) {
    const std::string_view className = IfcObjects::classOf(node);
    if (className == "IfcBuilding") {
        building = node, buildingM = elevationM;
        storey.clear();
    }
    if (className == "IfcBuildingStorey") storey = node, storeyM = elevationM;
    if (!className.empty() && className != "IfcMappedItem") element = node;
}

void IfcObjects::add(MeshObject object, const IfcWithin& within) {
    if (classOf(object.name) == "IfcMappedItem") object.name = within.element;
    const std::string_view className = classOf(object.name);
    if (isLeftOut(className)) {
        if (lastLeftOut_ != object.name) ++leftOut_[std::string(className)];
        lastLeftOut_ = object.name;
        return;
    }
    if (within.building.empty()) {
        outside_.push_back(std::move(object));
        return;
    }
    addOpening(object, within);
    MeshObject& whole = buildings_[within.building];
    whole.name = plainName(within.building);
    whole.kind = MeshObject::Kind::building;
    std::ranges::move(object.pieces, std::back_inserter(whole.pieces));
}

void IfcObjects::addOpening(const MeshObject& object, const IfcWithin& within) {
    const double storeyM = within.storeyM - within.buildingM;
    if (!within.storey.empty()) {
        auto& storeys = storeys_[within.building];
        if (std::ranges::find(storeys, storeyM) == storeys.end()) storeys.push_back(storeyM);
    }
    const std::string_view className = classOf(object.name);
    const bool isWindow = className.starts_with("IfcWindow"), isDoor = className.starts_with("IfcDoor");
    if (!isWindow && !isDoor) return;
    Opening& opening = openings_[object.name];
    opening.building = within.building;
    opening.storeyM = storeyM;
    opening.object.name = plainName(object.name);
    opening.object.parent = plainName(within.building);
    opening.object.kind = isWindow ? MeshObject::Kind::window : MeshObject::Kind::door;
    std::ranges::copy(object.pieces, std::back_inserter(opening.object.pieces));
}

// Storeys are counted from the one whose elevation is nearest to that of the building.
void IfcObjects::addOpeningsTo(std::vector<MeshObject>& objects) {
    const auto nearZero = [](double a, double b) { return std::abs(a) < std::abs(b); };
    for (auto& [name, storeys] : storeys_) std::ranges::sort(storeys);
    for (auto& [name, opening] : openings_) {
        if (const auto found = storeys_.find(opening.building); found != storeys_.end()) {
            const auto& storeys = found->second;
            const auto own = std::ranges::find(storeys, opening.storeyM);
            if (own != storeys.end())
                opening.object.floor = std::int32_t(own - std::ranges::min_element(storeys, nearZero));
        }
        objects.push_back(std::move(opening.object));
    }
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
    addOpeningsTo(objects);
    std::string note;
    for (const auto& [name, count] : leftOut_)
        note += fmt::format("{}{} ({})", note.empty() ? "" : ", ", name.empty() ? "others" : name, count);
    if (!note.empty()) objects.push_back({.name = {}, .pieces = {}, .note = note});
    return objects;
}

}  // namespace noonmark
