#include "scenarios/project/project.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "core/receivers/place_names.h"

namespace noonmark {

namespace {

constexpr auto ownName = [](const auto& one) -> const std::string& { return one.name; };
constexpr auto sharedName = [](const auto& one) -> const std::string& { return one->name; };

template <class T, class Name>
Result<T> findNamed(const std::vector<T>& list, Name nameOf, const std::string& name, const char* what) {
    const auto found = std::ranges::find(list, name, nameOf);
    if (found != list.end()) return *found;
    std::vector<std::string> names;
    for (const T& one : list) names.push_back("'" + nameOf(one) + "'");
    return failure(fmt::format("There is no such {}", what), fmt::format("{} '{}'", what, name),
                   names.empty() ? fmt::format("The project has none")
                                 : fmt::format("There are: {}", fmt::join(names, ", ")));
}

template <class Range, class Name>
Result<void> checkNames(const Range& list, Name nameOf, const char* what) {
    std::set<std::string> names;
    for (const auto& one : list) {
        if (nameOf(one).empty()) return failure(fmt::format("A {} has no name", what), "project", "Name it");
        if (!names.insert(nameOf(one)).second)
            return failure(fmt::format("Two of the project's {}s have this name", what), nameOf(one),
                           "Rename one");
    }
    return {};
}

}  // namespace

Result<NamedLot> findLot(const Project& project, const std::string& name) {
    return findNamed(project.lots, ownName, name, "lot");
}
Result<Region> findRegion(const Project& project, const std::string& name) {
    return findNamed(project.regions, ownName, name, "region");
}
Result<Place> findPlace(const Project& project, const std::string& name) {
    if (project.places.empty())
        return failure("The project has no places", "place '" + name + "'",
                       "Read them from a map: noonmark-cli project place read PROJECT FILE");
    return findPlace(project.places, name);
}

std::vector<Place> placesOfKind(const Project& project, PlaceKind kind) {
    std::vector<Place> places;
    std::ranges::copy_if(project.places, std::back_inserter(places),
                         [&](const Place& place) { return place.kind == kind; });
    return places;
}
Result<TimeWeights> findWeights(const Project& project, const std::string& name) {
    return findNamed(project.weights, ownName, name, "weight table");
}
Result<NamedPeriod> findPeriod(const Project& project, const std::string& name) {
    return findNamed(project.periods, ownName, name, "period");
}
Result<std::shared_ptr<const SavedResult>> findResult(const Project& project, const std::string& name) {
    return findNamed(project.results, sharedName, name, "saved result");
}
Result<Scenario> findScenarioByName(const Project& project, const std::string& name) {
    return findNamed(project.scenarios, ownName, name, "scenario");
}

Result<EditedCity> cityOf(const Project& project, const std::string& scenario) {
    return cityOf(*project.city, project.scenarios, scenario);
}

namespace {

Result<void> checkSize(const std::vector<std::shared_ptr<const SavedResult>>& results) {
    std::size_t cells = 0;
    for (const auto& result : results) cells += result->layers.size() * result->grid.size();
    if (cells <= maxLayerCells) return {};
    return limitReached(
        fmt::format("The saved results have {:.0f} million cells", double(cells) / 1e6), "saved results",
        fmt::format("Remove some: a project holds {:.0f} million", double(maxLayerCells) / 1e6));
}

}  // namespace

Result<void> validate(const Project& project) {
    Result<void> sound = validate(project.scenarios);
    if (sound) sound = checkNames(project.lots, ownName, "lot");
    if (sound) sound = checkNames(project.regions, ownName, "region");
    if (sound) sound = checkNames(project.places, ownName, "place");
    if (sound) sound = checkNames(project.weights, ownName, "weight table");
    if (sound) sound = checkNames(project.periods, ownName, "period");
    if (sound) sound = checkNames(project.views, ownName, "view");
    if (sound) sound = checkNames(project.results, sharedName, "result");
    if (sound) sound = checkSize(project.results);
    for (const TimeWeights& table : project.weights)
        if (sound) sound = validate(table);
    for (const SavedView& view : project.views)
        if (sound) sound = validate(view);
    if (sound) sound = validate(project.sheets.titleBlock);
    return sound;
}

}  // namespace noonmark
