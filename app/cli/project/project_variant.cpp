#include <fmt/format.h>

#include <memory>

#include "app/cli/number_range.h"
#include "app/cli/project/change_project.h"
#include "app/cli/project/massing_line.h"
#include "app/cli/project/project_commands.h"
#include "core/city/building_ground.h"
#include "scenarios/edits/building_ids.h"
#include "scenarios/massing/lot_edits.h"
#include "scenarios/massing/same_floor_area.h"

namespace noonmark::cli {

namespace {

struct VariantOptions {
    std::string file;
    std::string scenario;
    std::vector<std::string> buildings;
    std::string plate = "2";  // a factor, or "largest"
    double storeyHeightM = usualStoreyM;
};

Result<double> factorFrom(const std::string& text) {
    if (text == "largest") return largestPlate;
    double factor = 0;
    if (CLI::detail::lexical_cast(text, factor) && factor > 0) return factor;
    return failure("It is no size of a floor plate", text, "Give a factor such as 2 or 0.5, or `largest`");
}

// The lot of the building's own name, else the one that its middle lies on.
Result<Footprint> lotOf(const Project& project, const Building& building) {
    for (const NamedLot& lot : project.lots)
        if (lot.name == building.sourceId || lot.name == building.name) return lot.outline;
    for (const NamedLot& lot : project.lots)
        if (contains(lot.outline, middleOf(building))) return lot.outline;
    return failure("The project has no lot that it stands on", building.sourceId,
                   "Add one with `project new --lot`, or draw it in the layer `lots`");
}

Result<std::string> addVariant(const VariantOptions& options, double factor, const std::string& name,
                               const Project& project, Scenario& scenario) {
    const auto city = cityOf(project, scenario.name);
    if (!city) return tl::make_unexpected(city.error());
    const auto found = findBuilding(city->city, name);
    if (!found) return tl::make_unexpected(found.error());
    const Building& old = *city->city.buildings[*found];
    const auto lot = lotOf(project, old);
    if (!lot) return tl::make_unexpected(lot.error());
    const auto variant = variantOf(city->city, *found, *lot, factor, options.storeyHeightM);
    if (!variant) return tl::make_unexpected(variant.error());
    scenario.edits.emplace_back(variant->edit);
    return fmt::format("{}: {:.1f} m -> {}\n", old.sourceId, double(heightM(old, city->city)),
                       lineOf(variant->massing.figures));
}

Result<std::string> addVariants(const VariantOptions& options, Project& project) {
    const auto scenario = scenarioToChange(project, options.scenario);
    if (!scenario) return tl::make_unexpected(scenario.error());
    const auto factor = factorFrom(options.plate);
    if (!factor) return tl::make_unexpected(factor.error());
    std::string words;
    for (const std::string& building : options.buildings) {
        const auto line = addVariant(options, *factor, building, project, **scenario);
        if (!line) return line;
        words += *line;
    }
    return words;
}

}  // namespace

void addProjectVariant(CLI::App& project, Run& run) {
    const auto options = std::make_shared<VariantOptions>();
    CLI::App* command = project.add_subcommand(
        "variant", "Give buildings another shape of the same gross floor area, on their lots");
    addProjectFile(*command, options->file);
    command->add_option("buildings", options->buildings, "Their ids or names")
        ->required()
        ->type_name("BUILDING");
    command->add_option("--scenario", options->scenario, "The scenario to change")
        ->required()
        ->type_name("NAME");
    command
        ->add_option("--plate", options->plate,
                     "Floor plate: times the present one (2: shorter and wider, 0.5: slimmer and taller), or "
                     "`largest`; never "
                     "more than the lot")
        ->capture_default_str()
        ->type_name("FACTOR");
    command->add_option("--storey-height", options->storeyHeightM, "Of every storey, 2 to 10 m")
        ->capture_default_str()
        ->check(within(2, 10))
        ->type_name("M");
    command->callback([options, &run] {
        run = [options](const Console& console) {
            return changeProject(options->file, console,
                                 [&](Project& changed) { return addVariants(*options, changed); });
        };
    });
}

}  // namespace noonmark::cli
