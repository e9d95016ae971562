#include "scenarios/scenario_list.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace noonmark {

namespace {

using Place = std::vector<Scenario>::iterator;

Result<Place> placeOf(std::vector<Scenario>& scenarios, const std::string& name) {
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
