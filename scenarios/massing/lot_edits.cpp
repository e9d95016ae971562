#include "scenarios/massing/lot_edits.h"

#include <algorithm>

#include "core/city/footprints/plan_overlay.h"
#include "core/city/terrain/building_ground.h"
#include "core/city/terrain/ground_contact.h"
#include "scenarios/edits/placed_building.h"
#include "scenarios/massing/same_floor_area.h"

namespace noonmark {

std::vector<Footprint> computeOutline(const Building& building) {
    constexpr MinPiece least{.areaM2 = 1, .widthM = 0};
    const auto lowest = std::ranges::min_element(building.parts, {}, &Part::bottomM);
    std::vector<Footprint> standing, all;
    for (const Part& part : building.parts) {
        all.push_back(part.footprint);
        if (reachesGround(part, lowest->bottomM)) standing.push_back(part.footprint);
    }
    return cutPiecesOutside(standing.empty() ? all : standing, {}, least);
}

std::vector<Edit> clearing(const City& city, const Footprint& lot) {
    const Box2 box = bounds(lot);
    std::vector<Edit> edits;
    for (const auto& building : city.buildings) {
        const Box2 other = bounds(*building);
        const bool near = other.low.x < box.high.x && box.low.x < other.high.x && other.low.y < box.high.y &&
                          box.low.y < other.high.y;
        if (near && contains(lot, findMiddle(*building))) edits.emplace_back(Demolish{building->sourceId});
    }
    return edits;
}

Result<Variant> makeVariant(const City& city, std::size_t building, const Footprint& lot, double plateFactor,
                            double storeyHeightM) {
    const Building& old = *city.buildings[building];
    const auto given = givenBy(old, double(findGroundUnder(old, city)), storeyHeightM);
    if (!given) return tl::make_unexpected(given.error());
    auto massing = findSameFloorArea(lot, *given, plateFactor);
    if (!massing) return failure(massing.error().what, old.sourceId, massing.error().advice);
    auto made = buildingOf(*massing, old.sourceId);
    if (!made) return tl::make_unexpected(made.error());
    made->name = old.name;
    auto shape = std::make_shared<const Building>(*std::move(made));
    return Variant{{old.sourceId, std::move(shape)}, *std::move(massing), given->grossFloorM2};
}

}  // namespace noonmark
