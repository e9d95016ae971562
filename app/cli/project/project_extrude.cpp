#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>

#include "app/cli/base/terminal_text.h"
#include "app/cli/options/field_options.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/project/edit_scenario.h"
#include "app/cli/project/project_commands.h"
#include "core/base/safe_text.h"
#include "core/city/terrain/building_ground.h"
#include "scenarios/edits/apply_edits.h"
#include "scenarios/massing/copy_massing.h"
#include "scenarios/massing/fit_floor_area.h"
#include "scenarios/massing/lot_edits.h"
#include "scenarios/massing/massing.h"
#include "scenarios/massing/massing_fields.h"
#include "scenarios/massing/tower_design.h"

namespace noonmark::cli {

namespace {

/// "87 storeys, 304.5 m; gross floor area 87,696 m2, ratio 25.5, coverage 29 %"
std::string lineOf(const MassingFigures& figures) {
    return fmt::format("{}, {:.1f} m; gross floor area {} m2, ratio {:.1f}, coverage {:.0f} %",
                       countOf(std::uint64_t(figures.storeys), "storey"), figures.heightM,
                       withCommas(std::size_t(std::llround(figures.grossFloorM2))), figures.floorAreaRatio,
                       figures.coverage * 100);
}

/// "  offices: 10 storeys, 5,000 m2", a line for each use; empty where none is stated.
std::string linesOf(const std::vector<UseArea>& uses) {
    std::string lines;
    for (const UseArea& area : uses)
        lines += fmt::format("  {}: {}, {} m2\n", area.use.empty() ? "use not stated" : area.use,
                             countOf(std::uint64_t(area.storeys), "storey"),
                             withCommas(std::size_t(std::llround(area.grossFloorM2))));
    return lines;
}

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

namespace {

struct VariantOptions : BuildingsOptions {
    std::string plate = "2";  // a factor, or "largest"
    double storeyHeightM = defaultStoreyM;
};

Result<double> factorFrom(const std::string& text) {
    if (text == "largest") return largestPlate;
    double factor = 0;
    if (CLI::detail::lexical_cast(text, factor) && factor > 0) return factor;
    return failure("It is not a size of a floor plate", text, "Give a factor such as 2 or 0.5, or `largest`");
}

// The lot with the building's name, otherwise the lot that contains the building's centroid.
Result<Footprint> lotOf(const Project& project, const Building& building) {
    for (const NamedLot& lot : project.lots)
        if (lot.name == building.sourceId || lot.name == building.name) return lot.outline;
    for (const NamedLot& lot : project.lots)
        if (contains(lot.outline, findMiddle(building))) return lot.outline;
    return failure("The building does not stand on a lot of the project", building.sourceId,
                   "Add one: noonmark-cli project lot add");
}

Result<MadeEdit> makeVariant(const VariantOptions& options, double factor, const Project& project,
                             const FoundBuilding& found) {
    const Building& old = found.building();
    const auto lot = lotOf(project, old);
    if (!lot) return tl::make_unexpected(lot.error());
    const double oldM = double(heightM(old, found.city));
    return noonmark::makeVariant(found.city, found.index, *lot, factor, options.storeyHeightM)
        .map([&](const Variant& variant) {
            return MadeEdit{variant.edit, fmt::format("{}: {:.1f} m -> {}", old.sourceId, oldM,
                                                      lineOf(variant.massing.figures))};
        });
}

Result<std::string> addVariants(const VariantOptions& options, Project& project) {
    const auto factor = factorFrom(options.plate);
    if (!factor) return tl::make_unexpected(factor.error());
    return editBuildings(options, project, [&](const FoundBuilding& found) {
        return makeVariant(options, *factor, project, found);
    });
}

}  // namespace

void addProjectVariant(CLI::App& project, Run& run) {
    const auto options = std::make_shared<VariantOptions>();
    CLI::App* command =
        addEditCommand(project, "variant", "Reshape buildings on their lots at the same gross floor area",
                       options, addVariants, run);
    addBuildings(*command, *options);
    command
        ->add_option("--plate", options->plate,
                     "Floor plate as a multiple of the present one (2: lower and wider, 0.5: taller and "
                     "slimmer), or `largest`; at most the lot")
        ->capture_default_str()
        ->type_name("FACTOR");
    command->add_option("--storey-height", options->storeyHeightM, "Height of a storey, 2 to 10 m")
        ->capture_default_str()
        ->check(within(2, 10))
        ->type_name("M");
}

}  // namespace noonmark::cli
