#include "scenarios/edits/building_ids.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <unordered_set>
#include <vector>

namespace noonmark {

namespace {

std::vector<std::size_t> matching(const City& city, const std::string& text, std::string Building::*field) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < city.buildings.size(); ++i)
        if ((*city.buildings[i]).*field == text) found.push_back(i);
    return found;
}

// A building whose id or name begins like `text`; empty where none does.
std::string nearOne(const City& city, const std::string& text) {
    for (std::size_t letters = text.size(); letters >= 3; --letters)
        for (const auto& building : city.buildings)
            for (const std::string& word : {building->sourceId, building->name})
                if (word.starts_with(text.substr(0, letters))) return word;
    return {};
}

// Warnings about several files name a building after its file, "town.gpkg: feature 15"; in the project the
// second of an id is "feature 15 (2)". Empty for other texts.
std::vector<std::string> idsWithoutFile(const City& city, const std::string& text) {
    const std::size_t colon = text.find(": ");
    if (colon == text.npos) return {};
    const std::string id = text.substr(colon + 2);
    std::vector<std::string> ids;
    for (const auto& building : city.buildings)
        if (building->sourceId == id || building->sourceId.starts_with(id + " ("))
            ids.push_back(building->sourceId);
    return ids;
}

}  // namespace

City makeIdsUnique(City city) {
    std::unordered_set<std::string> used;
    for (auto& building : city.buildings) {
        const std::string own = building->sourceId.empty() ? "building" : building->sourceId;
        std::string id = own;
        for (int copy = 2; !used.insert(id).second; ++copy) id = fmt::format("{} ({})", own, copy);
        if (id == building->sourceId) continue;
        Building renamed = *building;
        renamed.sourceId = id;
        building = std::make_shared<const Building>(std::move(renamed));
    }
    return city;
}

Result<std::size_t> findBuilding(const City& city, const std::string& idOrName) {
    if (const auto byId = matching(city, idOrName, &Building::sourceId); byId.size() == 1)
        return byId.front();
    const auto byName = matching(city, idOrName, &Building::name);
    if (byName.size() == 1) return byName.front();
    const auto ofFile = byName.empty() ? idsWithoutFile(city, idOrName) : std::vector<std::string>();
    if (ofFile.size() == 1) return matching(city, ofFile.front(), &Building::sourceId).front();
    if (ofFile.size() > 1)
        return failure(fmt::format("{} buildings of several files have this id", ofFile.size()), idOrName,
                       fmt::format("Give one of: {}", fmt::join(ofFile, ", ")));
    if (byName.empty()) {
        const std::string near = nearOne(city, idOrName);
        return failure("There is no such building", idOrName,
                       near.empty() ? "Give the id or the name of a building of the scenario"
                                    : fmt::format("Did you mean '{}'?", near));
    }
    std::vector<std::string> ids;
    for (const std::size_t i : byName) ids.push_back(city.buildings[i]->sourceId);
    return failure(fmt::format("{} buildings have this name", ids.size()), idOrName,
                   fmt::format("Give an id: {}", fmt::join(ids, ", ")));
}

}  // namespace noonmark
