#include "app/gui/session/project/project_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "core/receivers/place_names.h"
#include "scenarios/scenario.h"

namespace noonmark {

namespace {

// Calls `work` with the list of parts of this kind. Results are shared pointers and handled separately.
template <class Work>
void inList(Project& project, ProjectPart part, Work&& work) {
    switch (part) {
        case ProjectPart::lot:
            return work(project.lots);
        case ProjectPart::region:
            return work(project.regions);
        case ProjectPart::place:
            return work(project.places);
        case ProjectPart::scenario:
            return work(project.scenarios);
        case ProjectPart::weights:
            return work(project.weights);
        case ProjectPart::period:
            return work(project.periods);
        case ProjectPart::view:
            return work(project.views);
        case ProjectPart::result:
            return;
    }
}

std::vector<std::string> namesOf(Project project, ProjectPart part) {
    std::vector<std::string> names;
    inList(project, part, [&](auto& list) {
        for (auto& one : list) names.push_back(one.name);
    });
    if (part == ProjectPart::result)
        for (const auto& result : project.results) names.push_back(result->name);
    return names;
}

Scenario* scenarioIn(Project& project, const std::string& name) {
    const auto found = std::ranges::find(project.scenarios, name, &Scenario::name);
    return found == project.scenarios.end() ? nullptr : &*found;
}

void renameResult(Project& project, const std::string& from, const std::string& to) {
    for (auto& result : project.results) {
        if (result->name != from) continue;
        auto copy = std::make_shared<SavedResult>(*result);
        copy->name = to;
        result = std::move(copy);
    }
}

}  // namespace

std::string nextProposal(const std::vector<Scenario>& scenarios) {
    for (int i = 0;; ++i) {
        const std::string name =
            i < 26 ? fmt::format("Proposal {}", char('A' + i)) : fmt::format("Proposal {}", i + 1);
        if (findScenario(scenarios, name) == nullptr) return name;
    }
}

std::string freeName(const Project& project, ProjectPart part, const std::string& name) {
    const std::vector<std::string> names = namesOf(project, part);
    return findFreeName(
        name, [&](const std::string& wanted) { return std::ranges::find(names, wanted) != names.end(); });
}

Project withScenario(Project project, const std::string& name, const std::string& base) {
    project.scenarios.push_back({name, base == existingCity ? std::string() : base, {}});
    return project;
}

Result<Project> renameIn(Project project, ProjectPart part, const std::string& from, const std::string& to) {
    if (part == ProjectPart::scenario)
        return renameScenario(project.scenarios, from, to).map([&] { return std::move(project); });
    inList(project, part, [&](auto& list) {
        for (auto& one : list)
            if (one.name == from) one.name = to;
    });
    if (part == ProjectPart::result) renameResult(project, from, to);
    return project;
}

Result<Project> without(Project project, ProjectPart part, const std::string& name) {
    if (part == ProjectPart::scenario)
        return removeScenario(project.scenarios, name).map([&] { return std::move(project); });
    inList(project, part,
           [&](auto& list) { std::erase_if(list, [&](auto& one) { return one.name == name; }); });
    if (part == ProjectPart::result)
        std::erase_if(project.results, [&](const auto& one) { return one->name == name; });
    return project;
}

Project duplicate(Project project, ProjectPart part, const std::string& name, std::string& made) {
    made = part == ProjectPart::scenario ? nextProposal(project.scenarios) : freeName(project, part, name);
    inList(project, part, [&](auto& list) {
        const auto found = std::ranges::find_if(list, [&](auto& one) { return one.name == name; });
        if (found == list.end()) return;
        auto copy = *found;
        copy.name = made;
        list.insert(found + 1, std::move(copy));
    });
    return project;
}

Project rebase(Project project, const std::string& scenario, const std::string& base) {
    if (Scenario* found = scenarioIn(project, scenario))
        found->base = base == existingCity ? std::string() : base;
    return project;
}

Project withOutline(Project project, const std::string& lot, Footprint outline) {
    for (NamedLot& one : project.lots)
        if (one.name == lot) one.outline = std::move(outline);
    return project;
}

Project withRoads(Project project, const std::string& lot, const std::vector<RoadFront>& roads) {
    for (NamedLot& one : project.lots)
        if (one.name == lot) one.roads = roads;
    return project;
}

Project withPlaceKind(Project project, const std::string& place, PlaceKind kind) {
    for (Place& one : project.places)
        if (one.name == place) one.kind = kind;
    return project;
}

namespace {

using PlacesBySource = std::map<std::string, std::size_t>;

PlacesBySource findSources(const std::vector<Place>& places) {
    PlacesBySource bySource;
    for (std::size_t i = 0; i < places.size(); ++i)
        if (!places[i].source.empty()) bySource.emplace(places[i].source, i);
    return bySource;
}

}  // namespace

// A name that the user has given stays with a place that is read again.
Project withPlaces(Project project, std::vector<Place> places, PlacesAdded& added) {
    added = {};
    const PlacesBySource bySource = findSources(project.places);
    for (Place& place : places) {
        const auto before = bySource.find(place.source);
        if (before == bySource.end()) {
            project.places.push_back(std::move(place));
            ++added.added;
            continue;
        }
        place.name = project.places[before->second].name;
        project.places[before->second] = std::move(place);
        ++added.replaced;
    }
    makeNamesUnique(project.places);
    return project;
}

// Another file may have the same name, and so the same sources: its outlines tell.
Project withMorePlaces(Project project, std::vector<Place> places, PlacesAdded& added) {
    added = {};
    const PlacesBySource bySource = findSources(project.places);
    for (Place& place : places) {
        const auto before = bySource.find(place.source);
        const bool isThere =
            before != bySource.end() && project.places[before->second].polygons == place.polygons;
        if (!isThere) project.places.push_back(std::move(place));
        ++(isThere ? added.same : added.added);
    }
    makeNamesUnique(project.places);
    return project;
}

Project withoutEdit(Project project, const std::string& scenario, std::size_t position) {
    Scenario* found = scenarioIn(project, scenario);
    if (found && position < found->edits.size())
        found->edits.erase(found->edits.begin() + std::ptrdiff_t(position));
    return project;
}

}  // namespace noonmark
