#include "core/receivers/city_above_plane.h"

#include <algorithm>
#include <memory>

namespace noonmark {

namespace {

/// The part of a building above the plane, as seen from it; none where all of it is below.
std::shared_ptr<const Building> lowered(const Building& building, float byM) {
    Building above = building;
    std::erase_if(above.parts, [&](const Part& part) { return part.topM <= byM; });
    for (Part& part : above.parts) {
        part.topM -= byM;
        part.bottomM = std::max(0.0F, part.bottomM - byM);
        part.isOverhanging = part.isOverhanging && part.bottomM > 0;
    }
    return above.parts.empty() ? nullptr : std::make_shared<const Building>(std::move(above));
}

bool hasMesh(const Building& building) {
    return std::ranges::any_of(building.parts, [](const Part& part) { return part.mesh != nullptr; });
}

}  // namespace

std::optional<City> cutAbovePlane(const City& city, double planeM) {
    if (city.terrain) return std::nullopt;
    City above{city.frame, {}, nullptr};
    for (const auto& building : city.buildings) {
        if (hasMesh(*building)) return std::nullopt;
        if (auto part = lowered(*building, float(planeM))) above.buildings.push_back(std::move(part));
    }
    return above;
}

}  // namespace noonmark
