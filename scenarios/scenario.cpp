#include "scenarios/scenario.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <string_view>
#include <unordered_map>

namespace noonmark {

namespace {

tl::unexpected<Error> unknown(const std::vector<Scenario>& scenarios, const std::string& name) {
    std::vector<std::string> names{existingCity};
    for (const Scenario& scenario : scenarios) names.push_back(scenario.name);
    return failure("There is no such scenario", fmt::format("scenario '{}'", name),
                   fmt::format("The scenarios are: {}", fmt::join(names, ", ")));
}

using ByName = std::unordered_map<std::string_view, const Scenario*>;

ByName byName(const std::vector<Scenario>& scenarios) {
    ByName found;
    for (const Scenario& scenario : scenarios) found.emplace(scenario.name, &scenario);
    return found;
}

// The chain of bases, from the scenario down to the one that starts from the existing city.
Result<std::vector<const Scenario*>> lineage(const std::vector<Scenario>& scenarios, const ByName& named,
                                             std::string_view name) {
    std::vector<const Scenario*> line;
    for (; !name.empty() && name != existingCity; name = line.back()->base) {
        const auto scenario = named.find(name);
        if (scenario == named.end()) return unknown(scenarios, std::string(name));
        if (std::ranges::find(line, scenario->second) != line.end())
            return failure("The scenario starts from itself", fmt::format("scenario '{}'", name),
                           "Let one of its bases start from the existing city");
        if (line.size() > maxBases)
            return failure(fmt::format("The scenario has more than {} bases", maxBases),
                           fmt::format("scenario '{}'", line.front()->name),
                           "Let it start from the existing city, or from a scenario nearer to it");
        line.push_back(scenario->second);
    }
    return line;
}

}  // namespace

const Scenario* findScenario(const std::vector<Scenario>& scenarios, const std::string& name) {
    const auto found = std::ranges::find(scenarios, name, &Scenario::name);
    return found == scenarios.end() ? nullptr : &*found;
}

Result<std::vector<Edit>> collectEdits(const std::vector<Scenario>& scenarios, const std::string& name) {
    if (name.empty()) return unknown(scenarios, name);
    const auto line = lineage(scenarios, byName(scenarios), name);
    if (!line) return tl::make_unexpected(line.error());
    std::vector<Edit> edits;
    for (auto scenario = line->rbegin(); scenario != line->rend(); ++scenario)
        edits.insert(edits.end(), (*scenario)->edits.begin(), (*scenario)->edits.end());
    return edits;
}

Result<EditedCity> cityOf(const City& existing, const std::vector<Scenario>& scenarios,
                          const std::string& name) {
    const auto edits = collectEdits(scenarios, name);
    if (!edits) return tl::make_unexpected(edits.error());
    return applyEdits(existing, *edits).map_error([&](Error error) {
        error.where = fmt::format("scenario '{}', {}", name, error.where);
        return error;
    });
}

Result<void> validate(const std::vector<Scenario>& scenarios) {
    if (scenarios.size() > maxScenarios)
        return failure(fmt::format("There are more than {} scenarios", maxScenarios), "scenarios",
                       "Move some to another project");
    const ByName named = byName(scenarios);
    for (const Scenario& scenario : scenarios) {
        if (scenario.name.empty() || scenario.name == existingCity)
            return failure(fmt::format("A scenario cannot be called '{}'", scenario.name), "scenarios",
                           "Give it another name");
        if (named.at(scenario.name) != &scenario)
            return failure("Two scenarios have this name", scenario.name, "Rename one");
        if (const auto line = lineage(scenarios, named, scenario.name); !line)
            return tl::make_unexpected(line.error());
    }
    return {};
}

namespace {

using ScenarioPlace = std::vector<Scenario>::iterator;

Result<ScenarioPlace> placeOf(std::vector<Scenario>& scenarios, const std::string& name) {
    if (name == existingCity)
        return failure("The existing city cannot be changed", "scenario 'Existing'",
                       "Name one of the project's scenarios");
    if (const auto known = collectEdits(scenarios, name); !known) return tl::make_unexpected(known.error());
    return std::ranges::find(scenarios, name, &Scenario::name);
}

// Takes over the changed list if it is valid.
Result<void> keepSound(std::vector<Scenario>& scenarios, std::vector<Scenario> changed) {
    if (const auto sound = validate(changed); !sound) return sound;
    scenarios = std::move(changed);
    return {};
}

}  // namespace

std::vector<std::string> listNames(const std::vector<Scenario>& scenarios) {
    std::vector<std::string> names{existingCity};
    for (const Scenario& scenario : scenarios) names.push_back(scenario.name);
    return names;
}

Result<void> renameScenario(std::vector<Scenario>& scenarios, const std::string& name,
                            const std::string& newName) {
    std::vector<Scenario> changed = scenarios;
    const auto place = placeOf(changed, name);
    if (!place) return tl::make_unexpected(place.error());
    (*place)->name = newName;
    for (Scenario& other : changed)
        if (other.base == name) other.base = newName;
    return keepSound(scenarios, std::move(changed));
}

Result<void> duplicateScenario(std::vector<Scenario>& scenarios, const std::string& name,
                               const std::string& newName) {
    std::vector<Scenario> changed = scenarios;
    const auto place = placeOf(changed, name);
    if (!place) return tl::make_unexpected(place.error());
    Scenario copy = **place;
    copy.name = newName;
    changed.insert(*place + 1, std::move(copy));
    return keepSound(scenarios, std::move(changed));
}

std::size_t replaceImports(std::vector<Scenario>& scenarios, const ImportMesh& edition) {
    std::size_t replaced = 0;
    for (Scenario& scenario : scenarios)
        for (Edit& edit : scenario.edits)
            if (auto* import = std::get_if<ImportMesh>(&edit);
                import != nullptr && import->shape->sourceId == edition.shape->sourceId) {
                *import = edition;
                ++replaced;
            }
    return replaced;
}

Result<void> removeScenario(std::vector<Scenario>& scenarios, const std::string& name) {
    const auto place = placeOf(scenarios, name);
    if (!place) return tl::make_unexpected(place.error());
    std::vector<std::string> others;
    for (const Scenario& other : scenarios)
        if (other.base == name) others.push_back(other.name);
    if (!others.empty())
        return failure("Other scenarios start from it", fmt::format("scenario '{}'", name),
                       fmt::format("Remove them first: {}", fmt::join(others, ", ")));
    scenarios.erase(*place);
    return {};
}

}  // namespace noonmark
