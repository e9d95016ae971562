#include "app/gui/tools/massing/tower_draft.h"

#include <fmt/format.h>

#include <algorithm>

#include "scenarios/massing/lot_edits.h"
#include "scenarios/massing/tower_design.h"

namespace noonmark {

namespace {

template <class IsTaken>
std::string firstFree(const char* word, IsTaken&& isTaken) {
    for (int number = 1;; ++number)
        if (std::string name = fmt::format("{} {}", word, number); !isTaken(name)) return name;
}

// The demolitions on the lot, without that of the replaced building, of which only a corner may be on the
// lot.
std::vector<Edit> clearLot(const City& city, const TowerDraft& draft) {
    std::vector<Edit> edits = clearing(city, draft.lot.outline);
    std::erase_if(edits,
                  [&](const Edit& edit) { return std::get<Demolish>(edit).building == draft.replaces; });
    return edits;
}

}  // namespace

Result<DraftedTower> draftTower(const City& city, const TowerDraft& draft) {
    auto massing = makeMassing(draft.lot.outline, draft.settings);
    if (!massing) return tl::make_unexpected(massing.error());
    auto building = buildingOf(*massing, draft.tower);
    if (!building) return tl::make_unexpected(building.error());
    auto shape = std::make_shared<const Building>(*std::move(building));
    const auto design =
        std::make_shared<const TowerDesign>(TowerDesign{draft.lot.name, draft.lot.outline, draft.settings});
    std::vector<Edit> edits = clearLot(city, draft);
    if (draft.replaces.empty())
        edits.emplace_back(AddBuilding{std::move(shape), design});
    else
        edits.emplace_back(Replace{draft.replaces, std::move(shape), design});
    return DraftedTower{*std::move(massing), std::move(edits)};
}

std::string freeTowerName(const City& city) {
    return firstFree("Tower", [&](const std::string& name) {
        return std::ranges::any_of(city.buildings,
                                   [&](const auto& building) { return building->sourceId == name; });
    });
}

std::string freeLotName(const std::vector<NamedLot>& lots) {
    return firstFree("Lot", [&](const std::string& name) {
        return std::ranges::any_of(lots, [&](const NamedLot& lot) { return lot.name == name; });
    });
}

}  // namespace noonmark
