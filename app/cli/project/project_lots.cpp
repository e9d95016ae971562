#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/cli/base/interrupt.h"
#include "app/cli/project/list_project.h"
#include "app/cli/project/project_commands.h"
#include "core/describe/command_options.h"
#include "core/io/footprints/read_parcels.h"
#include "core/io/formats/format.h"
#include "core/io/read_region.h"
#include "core/receivers/made_names.h"
#include "scenarios/edits/apply_edits.h"
#include "scenarios/massing/lot_edits.h"
#include "scenarios/scenario.h"

namespace noonmark::cli {

namespace {

struct AddOptions {
    ChangeOptions change;
    std::string name;
    std::string place;
    std::string building;  // its outline is the lot
    std::string scenario;  // the scenario of the building
};

struct RoadOptions {
    ChangeOptions change;
    std::string name;
    std::vector<std::string> roads;  // SIDE=WIDTH
};

struct ImportOptions {
    ChangeOptions change;
    std::string file;
    std::string within;
    ParcelSettings parcels;
};

std::string lineOf(const NamedLot& lot) {
    return fmt::format("{}: {:.0f} m2\n", lot.name, area(lot.outline));
}

Result<std::vector<Footprint>> outlinesOf(const AddOptions& options, const Project& project) {
    if (options.building.empty())
        return readRegion(options.place, project.city->frame).map([](const Region& region) {
            return region.polygons;
        });
    const auto city = cityOf(project, options.scenario);
    if (!city) return tl::make_unexpected(city.error());
    return findBuilding(city->city, options.building).map([&](std::size_t found) {
        return computeOutline(*city->city.buildings[found]);
    });
}

// Each polygon becomes a lot.
Result<std::string> addLots(Project& project, const std::string& name,
                            const std::vector<Footprint>& outlines) {
    std::string words;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        const NamedLot lot{numberName(name, i + 1), outlines[i]};
        if (findLot(project, lot.name))
            return failure("The project already has a lot of this name", lot.name,
                           "Choose another name, or remove that one: noonmark-cli project lot remove");
        project.lots.push_back(lot);
        words += lineOf(lot);
    }
    return words;
}

Result<std::string> add(const AddOptions& options, Project& project) {
    const auto outlines = outlinesOf(options, project);
    if (!outlines) return tl::make_unexpected(outlines.error());
    return addLots(project, options.name, *outlines);
}

// A name that no lot has yet: unnamed lots are numbered, and repeated names get a number.
std::string freeName(const Project& project, const std::string& name) {
    const std::string own = name.empty() ? "lot" : name;
    return findFreeName(own, [&](const std::string& wanted) { return findLot(project, wanted).has_value(); });
}

Result<ParcelSettings> settingsFrom(const ImportOptions& options, const Project& project) {
    ParcelSettings settings = options.parcels;
    if (options.within.empty()) {
        if (settings.names.empty()) settings.within = makeRegionFromLocalBox(bounds(*project.city));
        return settings;
    }
    auto region = findRegion(project, options.within);
    if (!region) region = readRegion(options.within, project.city->frame);
    if (!region) return tl::make_unexpected(region.error());
    settings.within = *std::move(region);
    return settings;
}

Result<std::string> import(const ImportOptions& options, Project& project) {
    const auto settings = settingsFrom(options, project);
    if (!settings) return tl::make_unexpected(settings.error());
    const Interrupt interrupt;
    const auto parcels = readParcels(options.file, *settings, project.city->frame, interrupt.token());
    if (!parcels) return tl::make_unexpected(parcels.error());
    std::string words;
    for (const Parcel& parcel : *parcels)
        for (const Footprint& outline : parcel.polygons) {
            project.lots.push_back({freeName(project, parcel.name), outline});
            words += lineOf(project.lots.back());
        }
    return words;
}

Result<std::string> setRoads(const RoadOptions& options, Project& project) {
    const auto roads = parseRoads(fmt::format("{}", fmt::join(options.roads, ",")));
    if (!roads) return tl::make_unexpected(roads.error());
    const auto found = findLot(project, options.name);
    if (!found) return tl::make_unexpected(found.error());
    std::ranges::find(project.lots, found->name, &NamedLot::name)->roads = *roads;
    return roads->empty() ? fmt::format("{}: no roads\n", found->name)
                          : fmt::format("{}: roads {}\n", found->name, formatText(*roads));
}

Listed listed(const NamedLot& lot) {
    const std::string courtyard = lot.outline.holes.empty() ? "" : ", with a courtyard";
    const std::string roads = lot.roads.empty() ? "" : ", roads " + formatText(lot.roads);
    return {lot.name,
            fmt::format("{:.0f} m2{}{}", area(lot.outline), courtyard, roads),
            {{"area_m2", area(lot.outline)},
             {"courtyards", lot.outline.holes.size()},
             {"roads", formatText(lot.roads)}}};
}

std::vector<Listed> list(const Project& project) {
    std::vector<Listed> lines;
    for (const NamedLot& lot : project.lots) lines.push_back(listed(lot));
    return lines;
}

Result<std::string> remove(const RemoveOptions& options, Project& project) {
    return removeNamed(
        project.lots, options.names, [](const NamedLot& lot) { return lot.name; },
        [&](const std::string& name) { return findLot(project, name); });
}

void addAdd(CLI::App& group, Run& run) {
    const auto options = std::make_shared<AddOptions>();
    CLI::App* command = addChangeCommand(group, "add", "Add a lot", options, add, run);
    command->add_option("name", options->name, "Name of the lot")->required()->type_name("NAME");
    CLI::Option_group* where = command->add_option_group("where");
    where
        ->add_option("place", options->place,
                     "west,south,east,north in degrees, POLYGON ((lon lat, ...)), or a polygon file")
        ->type_name("W,S,E,N|WKT|FILE");
    CLI::Option* of = where->add_option("--of", options->building, "A building whose outline becomes the lot")
                          ->type_name("BUILDING");
    where->require_option(1);
    command->add_option(flags::scenario, options->scenario, "The scenario of the building")
        ->default_val(existingCity)
        ->needs(of)
        ->type_name("NAME");
}

void addSetRoads(CLI::App& group, Run& run) {
    const auto options = std::make_shared<RoadOptions>();
    CLI::App* command = addChangeCommand(
        group, "set-roads", "State the roads, water and railways along a lot, for rules about parcels",
        options, setRoads, run);
    command->add_option("name", options->name, "Name of the lot")->required()->type_name("NAME");
    command
        ->add_option(
            "roads", options->roads,
            "Sides and widths in metres, such as south=8 east=12 (sides: north, northeast, ...); none: "
            "the lot has no roads")
        ->type_name("SIDE=M...");
}

void addImport(CLI::App& group, Run& run) {
    const auto options = std::make_shared<ImportOptions>();
    CLI::App* command =
        addChangeCommand(group, "import", "Add lots from a register of parcels", options, import, run);
    command->add_option("file", options->file, "A map: " + listNames({FileKind::footprints}))
        ->required()
        ->type_name("FILE");
    command
        ->add_option("--name-field", options->parcels.nameField,
                     "Field of the lots' names (default: name, lot, parcel, apn, bbl or id)")
        ->type_name("FIELD");
    command->add_option("--layer", options->parcels.layer, "Read this layer only")->type_name("NAME");
    command->add_option("--only", options->parcels.names, "Only lots with these names")->type_name("NAME");
    command
        ->add_option("--within", options->within,
                     "Only lots whose middle lies in a region of the project, a box or a polygon (default: "
                     "the city's extent)")
        ->type_name("REGION|W,S,E,N|WKT|FILE");
}

}  // namespace

void addProjectLot(CLI::App& project, Run& run) {
    CLI::App* group = project.add_subcommand("lot", "Ground to build on");
    group->require_subcommand(1);
    addAdd(*group, run);
    addSetRoads(*group, run);
    addImport(*group, run);
    addListCommand(*group, "List the lots", list, run);
    addRemoveCommand(*group, "Remove lots", remove, run);
}

}  // namespace noonmark::cli
