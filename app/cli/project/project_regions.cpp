#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "app/cli/base/terminal_text.h"
#include "app/cli/project/list_project.h"
#include "app/cli/project/project_commands.h"
#include "core/io/read_region.h"

namespace noonmark::cli {

namespace {

struct RegionOptions {
    ChangeOptions change;
    std::string name;
    std::string place;
};

Result<std::string> addRegion(const RegionOptions& options, Project& project) {
    auto region = readRegion(options.place, project.city->frame);
    if (!region) return tl::make_unexpected(region.error());
    region->name = options.name;
    project.regions.push_back(*region);
    return fmt::format("{}: {} m2\n", options.name, withCommas(std::size_t(std::llround(area(*region)))));
}

std::vector<Listed> listRegions(const Project& project) {
    std::vector<Listed> lines;
    for (const Region& region : project.regions)
        lines.push_back({region.name,
                         fmt::format("{:.0f} m2", area(region)),
                         {{"area_m2", area(region)}, {"polygons", region.polygons.size()}}});
    return lines;
}

Result<std::string> removeRegions(const RemoveOptions& options, Project& project) {
    return removeNamed(
        project.regions, options.names, [](const Region& region) { return region.name; },
        [&](const std::string& name) { return findRegion(project, name); });
}

}  // namespace

void addProjectRegion(CLI::App& project, Run& run) {
    CLI::App* group = project.add_subcommand("region", "Where shadow is measured");
    group->require_subcommand(1);
    const auto options = std::make_shared<RegionOptions>();
    CLI::App* command = addChangeCommand(*group, "add", "Add a region", options, addRegion, run);
    command->add_option("name", options->name, "Name of the region")->required()->type_name("NAME");
    command
        ->add_option("place", options->place,
                     "west,south,east,north in degrees, POLYGON ((lon lat, ...)), or a polygon file")
        ->required()
        ->type_name("W,S,E,N|WKT|FILE");
    addListCommand(*group, "List the regions", listRegions, run);
    addRemoveCommand(*group, "Remove regions", removeRegions, run);
}

}  // namespace noonmark::cli
