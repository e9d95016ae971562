#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <set>

#include "app/cli/options/field_options.h"
#include "app/cli/project/edit_scenario.h"
#include "app/cli/project/massing_line.h"
#include "app/cli/project/project_commands.h"
#include "scenarios/edits/building_ids.h"
#include "scenarios/massing/fit_floor_area.h"
#include "scenarios/massing/lot_edits.h"
#include "scenarios/massing/massing_fields.h"
#include "scenarios/massing/tower_design.h"

namespace noonmark::cli {

namespace {

struct ExtrudeOptions : EditOptions {
    std::string lot;
    std::string on;  // a building whose footprint is the lot
    std::string id;
    bool clear = false;
    MassingSettings massing;
    Podium podium;
    std::set<std::string, std::less<>> given;  // flags of the podium
    FloorAreaTarget target;
};

MassingSettings settingsFrom(const ExtrudeOptions& options) {
    MassingSettings settings = options.massing;
    if (options.given.empty()) return settings;
    settings.podium = options.podium;
    if (!options.podium.plate.areaM2 && !options.podium.plate.shareOfLot)
        settings.podium->plate.shareOfLot = 1;
    return settings;
}

// The lot, and the edits that clear it.
struct Site {
    Footprint lot;
    std::vector<Edit> edits;
    std::string note;    // hint for the user
    std::string name{};  // of the lot; empty: a building's outline
};

Site siteOn(const Footprint& lot, const City& city, bool clear) {
    std::vector<Edit> demolitions = clearing(city, lot);
    if (clear || demolitions.empty()) return {lot, std::move(demolitions), {}};
    std::vector<std::string> staying;
    for (const Edit& edit : demolitions) staying.push_back(std::get<Demolish>(edit).building);
    return {lot, {}, fmt::format("  Stays on the lot without --clear: {}\n", fmt::join(staying, ", "))};
}

// The largest piece of a building that stands in several pieces.
Footprint groundOf(const Building& building) {
    std::vector<Footprint> pieces = computeOutline(building);
    if (pieces.empty()) return building.parts.front().footprint;
    return *std::ranges::max_element(pieces, {}, [](const Footprint& piece) { return area(piece); });
}

Result<Site> siteOf(const ExtrudeOptions& options, const Project& project, const City& city) {
    if (options.on.empty()) {
        const auto lot = findLot(project, options.lot);
        if (!lot) return tl::make_unexpected(lot.error());
        Site site = siteOn(lot->outline, city, options.clear);
        site.name = lot->name;
        return site;
    }
    const auto found = findBuilding(city, options.on);
    if (!found) return tl::make_unexpected(found.error());
    const Building& old = *city.buildings[*found];
    return Site{groundOf(old), {Demolish{old.sourceId}}, {}};
}

Result<MassingSettings> settingsOn(const Footprint& lot, const ExtrudeOptions& options) {
    const MassingSettings settings = settingsFrom(options);
    const auto wantedM2 = options.target.areaOn(lot);
    if (!wantedM2) return settings;
    return fitFloorArea(lot, settings, *wantedM2, options.target.by);
}

Result<std::string> extrude(const ExtrudeOptions& options, Project& project) {
    if (const auto known = scenarioToChange(project, options.scenario); !known)
        return tl::make_unexpected(known.error());
    const auto city = cityOf(project, options.scenario);
    if (!city) return tl::make_unexpected(city.error());
    auto site = siteOf(options, project, city->city);
    if (!site) return tl::make_unexpected(site.error());
    const auto settings = settingsOn(site->lot, options);
    if (!settings) return tl::make_unexpected(settings.error());
    const auto massing = makeMassing(site->lot, *settings);
    if (!massing) return tl::make_unexpected(massing.error());
    const auto building = buildingOf(*massing, options.id);
    if (!building) return tl::make_unexpected(building.error());
    site->edits.emplace_back(
        AddBuilding{std::make_shared<const Building>(*building),
                    std::make_shared<const TowerDesign>(TowerDesign{site->name, site->lot, *settings})});
    return withEdits(project, options.scenario, site->edits).map([&](const std::string& words) {
        return fmt::format("{}{}: {}\n{}{}", words, options.id, lineOf(massing->figures),
                           linesOf(massing->figures.uses), site->note);
    });
}

}  // namespace

void addProjectExtrude(CLI::App& project, Run& run) {
    const auto options = std::make_shared<ExtrudeOptions>();
    CLI::App* command =
        addEditCommand(project, "extrude", "Build a tower on a lot in a scenario", options, extrude, run);
    CLI::Option_group* where = command->add_option_group("where");
    where->add_option("--lot", options->lot, "A lot of the project")->type_name("NAME");
    where->add_option("--on", options->on, "A building to demolish; its outline becomes the lot")
        ->type_name("BUILDING");
    where->require_option(1);
    command->add_flag("--clear", options->clear, "Demolish the buildings on the lot");
    command->add_option("--id", options->id, "Id and name of the new building")
        ->required()
        ->type_name("NAME");
    addFieldOptions(*command, massingFields().of(options->massing));
    addFieldOptions(*command, podiumFields().of(options->podium), {.given = &options->given});
    addFieldOptions(*command, massingListFields().of(options->massing));
    addFieldOptions(*command, floorAreaFields().of(options->target));
}

}  // namespace noonmark::cli
