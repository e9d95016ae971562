#include <fmt/format.h>

#include <memory>

#include "app/cli/options/number_range.h"
#include "app/cli/project/edit_scenario.h"
#include "app/cli/project/massing_line.h"
#include "app/cli/project/project_commands.h"
#include "core/city/terrain/building_ground.h"
#include "scenarios/massing/lot_edits.h"
#include "scenarios/massing/same_floor_area.h"

namespace noonmark::cli {

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
