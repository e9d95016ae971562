#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/receivers/place_names.h"
#include "core/study/provenance/provenance_texts.h"
#include "core/study/provenance/study_hash.h"
#include "scenarios/project/results/saved_answer.h"
#include "scenarios/project/results/saved_figures_json.h"
#include "scenarios/weights/time_weights.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

/// hashCity() of the scenarios of a project, each computed once.
class CityHashes {
public:
    explicit CityHashes(const Project& project) : project_(project) {}
    /// None: there is no such scenario.
    const std::optional<std::string>& of(const std::string& scenario) {
        const auto [at, isNew] = hashes_.try_emplace(scenario);
        if (!isNew) return at->second;
        if (const auto city = cityOf(project_, scenario)) at->second = hashCity(city->city);
        return at->second;
    }

private:
    const Project& project_;
    std::map<std::string, std::optional<std::string>> hashes_;
};

void compareCity(std::vector<std::string>& changes, const std::string& scenario, const std::string& hash,
                 CityHashes& hashes) {
    const auto& now = hashes.of(scenario);
    if (!now)
        changes.push_back(fmt::format("The scenario '{}' no longer exists.", scenario));
    else if (!hash.empty() && *now != hash)
        changes.push_back(
            fmt::format("'{}' has changed since: its buildings, its terrain or its water.", scenario));
}

constexpr std::size_t maxPlacesNamed = 3;

// Whatever its pieces: a file that is read again may have them in another order.
bool haveSameOutline(const Place& one, const Place& other) {
    constexpr float nearM = 0.05F;
    constexpr double share = 0.001;
    const Box2 box = bounds(one), second = bounds(other);
    return glm::distance(box.low, second.low) < nearM && glm::distance(box.high, second.high) < nearM &&
           std::abs(area(one) - area(other)) < share * (1 + area(one));
}

// Of other kinds, and of damaged results, which are refused elsewhere: none.
std::vector<Place> placesOf(const SavedResult& result) try {
    std::vector<Place> places;
    if (result.kind != "by-place") return places;
    const Json json = Json::parse(result.settings);
    const Json &listed = json.at("places"), &outlines = json.at("kept").at("places");
    for (std::size_t i = 0; i < listed.size(); ++i)
        places.push_back(parseSavedPlace(listed[i], outlines.at(i)));
    return places;
} catch (const std::exception&) {
    return {};
}

std::vector<std::string> listChanges(const SavedResult& result, const SavedOrigin& origin,
                                     const Project& project, CityHashes& hashes) {
    std::vector<std::string> changes;
    compareCity(changes, result.scenario, origin.citySha256, hashes);
    if (!result.baseline.empty()) compareCity(changes, result.baseline, origin.baselineSha256, hashes);
    for (const auto& [scenario, hash] : origin.othersSha256) compareCity(changes, scenario, hash, hashes);
    std::ranges::move(findChangedPlaces(placesOf(result), project), std::back_inserter(changes));
    if (result.inputs != inputsJson(project.inputs).dump())
        changes.emplace_back("The city has been read from other files since.");
    if (origin.citySha256.empty())
        changes.emplace_back(
            "It is not known whether buildings have changed since: the result was saved without a hash.");
    return changes;
}

}  // namespace

std::vector<std::string> findChangedPlaces(const std::vector<Place>& measured, const Project& project) {
    std::vector<Place> ofRegions;
    for (const Region& region : project.regions) ofRegions.push_back(makePlace(region));
    std::map<std::string_view, const Place*> now;
    for (const auto* places : {&project.places, &std::as_const(ofRegions)})
        for (const Place& place : *places) now.emplace(place.name, &place);
    std::vector<std::string> changes;
    std::size_t more = 0;
    for (const Place& place : measured) {
        const auto found = now.find(place.name);
        const bool isThere = found != now.end();
        if (isThere && found->second->kind == place.kind && haveSameOutline(place, *found->second)) continue;
        if (changes.size() == maxPlacesNamed) {
            ++more;
            continue;
        }
        changes.push_back(isThere
                              ? fmt::format("The place '{}' has another kind or outline since.", place.name)
                              : fmt::format("The place '{}' is gone, or has another name.", place.name));
    }
    if (more > 0) changes.push_back(fmt::format("{} more places have changed since.", more));
    return changes;
}

std::vector<std::string> findChangesSince(const SavedResult& result, const SavedOrigin& origin,
                                          const Project& project) {
    CityHashes hashes(project);
    return listChanges(result, origin, project, hashes);
}

Result<std::set<std::string>> findOutdated(const std::vector<std::shared_ptr<const SavedResult>>& results,
                                           const Project& project, const std::stop_token& stop) {
    CityHashes hashes(project);
    std::set<std::string> outdated;
    for (const auto& result : results) {
        if (stop.stop_requested()) return cancelled();
        const auto origin = readSavedOrigin(*result);
        if (!origin || !listChanges(*result, *origin, project, hashes).empty()) outdated.insert(result->name);
    }
    return outdated;
}

// The name does not matter: a table with equal intervals counts as unchanged.
std::vector<std::string> findWeightChangesSince(const SavedOrigin& origin, const Project& project) {
    if (!origin.weights) return {};
    const TimeWeights& then = *origin.weights;
    if (const auto now = findWeights(project, then.name)) {
        if (*now == then) return {};
        return {fmt::format("The weight table '{}' has changed since.", then.name)};
    }
    if (std::ranges::find(project.weights, then.intervals, &TimeWeights::intervals) != project.weights.end())
        return {};
    return {fmt::format("The weight table '{}' no longer exists.", then.name)};
}

}  // namespace noonmark
