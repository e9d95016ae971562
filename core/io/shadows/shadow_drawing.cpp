#include "core/io/shadows/shadow_drawing.h"

#include <algorithm>

#include "core/city/terrain/building_ground.h"

namespace noonmark {

namespace {

bool meet(const Box2& a, const Box2& b) {
    return !a.empty() && a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y &&
           b.low.y <= a.high.y;
}

}  // namespace

std::string_view nameOf(BuildingState state) {
    switch (state) {
        case BuildingState::unchanged:
            return "unchanged";
        case BuildingState::proposed:
            return "proposed";
        case BuildingState::removed:
            break;
    }
    return "removed";
}

void addBuildings(const City& city, BuildingState state, const Box2& area, std::vector<DrawnPart>& to) {
    for (const auto& building : city.buildings) {
        if (!meet(bounds(*building), area)) continue;
        const auto groundM = double(findGroundUnder(*building, city));
        for (const Part& part : building->parts)
            to.push_back({building->sourceId, building->name, state, part.footprint,
                          double(part.bottomM) - groundM, double(part.topM) - groundM});
    }
}

std::vector<Place> choosePlacesIn(const std::vector<Place>& places, const Box2& area) {
    std::vector<Place> chosen;
    for (const Place& place : places)
        if (std::ranges::any_of(place.polygons,
                                [&](const Footprint& polygon) { return meet(bounds(polygon), area); }))
            chosen.push_back(place);
    return chosen;
}

}  // namespace noonmark
