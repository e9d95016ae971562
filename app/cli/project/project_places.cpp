#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <sstream>

#include "app/cli/base/interrupt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/project_options.h"
#include "app/cli/project/list_project.h"
#include "app/cli/project/project_commands.h"
#include "app/input/load_city.h"
#include "core/base/safe_text.h"
#include "core/io/read_region.h"
#include "core/receivers/place_names.h"
#include "scenarios/edits/apply_edits.h"
#include "scenarios/massing/lot_edits.h"

namespace noonmark::cli {

namespace {

struct PlaceReadOptions {
    ChangeOptions change;
    std::vector<std::string> files;
    PlaceOptions place;
};

struct PlaceAddOptions {
    ChangeOptions change;
    std::string name;
    std::string where;
    std::string building;  // whose outline is the place
    PlaceOptions place;
};

std::string lineOf(const Place& place) {
    return fmt::format("{}: {}, {:.0f} m2\n", place.name, nameOf(place.kind), area(place));
}

// A place that was read before is replaced, so that a file can be read again.
Result<std::string> readFiles(const PlaceReadOptions& options, Project& project) {
    const Interrupt interrupt;
    NoProgress progress;
    auto read = loadPlaceFiles(options.files, options.place.settings, project.city->frame, {}, progress,
                               interrupt.token());
    if (!read) return tl::make_unexpected(read.error());
    std::size_t replaced = 0;
    for (const Place& place : read->places)
        replaced +=
            std::erase_if(project.places, [&](const Place& old) { return old.source == place.source; });
    const std::size_t count = read->places.size();
    std::ranges::move(read->places, std::back_inserter(project.places));
    makeNamesUnique(project.places);
    std::ostringstream words;
    words << fmt::format("{} read; earlier ones replaced: {}\n", countOf(count, "place"), replaced);
    printWarnings(words, read->warnings);
    return words.str();
}

Result<std::vector<Footprint>> polygonsOf(const PlaceAddOptions& options, const Project& project) {
    if (options.building.empty())
        return readRegion(options.where, project.city->frame).map([](const Region& region) {
            return region.polygons;
        });
    return findBuilding(*project.city, options.building).map([&](std::size_t found) {
        return computeOutline(*project.city->buildings[found]);
    });
}

Result<std::string> addPlace(const PlaceAddOptions& options, Project& project) {
    auto polygons = polygonsOf(options, project);
    if (!polygons) return tl::make_unexpected(polygons.error());
    const std::string name = cleanName(options.name);
    if (std::ranges::find(project.places, name, &Place::name) != project.places.end())
        return failure("The project already has a place of this name", name,
                       "Choose another name, or remove that one: noonmark-cli project place remove");
    const std::string source =
        options.building.empty() ? "drawn: " + options.where : "building " + options.building;
    project.places.push_back({name, options.place.settings.kind, *std::move(polygons), cleanName(source)});
    return lineOf(project.places.back());
}

std::vector<Listed> listPlaces(const Project& project) {
    std::vector<Listed> lines;
    for (const Place& place : project.places)
        lines.push_back({place.name,
                         fmt::format("{}, {:.0f} m2, {}", nameOf(place.kind), area(place), place.source),
                         {{"kind", nameOf(place.kind)},
                          {"area_m2", area(place)},
                          {"polygons", place.polygons.size()},
                          {"source", place.source}}});
    return lines;
}

// Names are found in any case of letters.
Result<std::string> removePlaces(const RemoveOptions& options, Project& project) {
    std::vector<std::string> names;
    for (const std::string& name : options.names) {
        const auto place = findPlace(project, name);
        if (!place) return tl::make_unexpected(place.error());
        names.push_back(place->name);
    }
    return removeNamed(
        project.places, names, [](const Place& place) { return place.name; },
        [&](const std::string& name) { return findPlace(project, name); });
}

}  // namespace

void addProjectPlace(CLI::App& project, Run& run) {
    CLI::App* group = project.add_subcommand("place", "Areas whose sunlight matters");
    group->require_subcommand(1);
    const auto reading = std::make_shared<PlaceReadOptions>();
    CLI::App* read = addChangeCommand(
        *group, "read", "Read places from OpenStreetMap or any file of polygons", reading, readFiles, run);
    read->add_option("files", reading->files, "The files")->required()->type_name("FILE");
    addPlaceOptions(*read, reading->place);
    const auto adding = std::make_shared<PlaceAddOptions>();
    CLI::App* add = addChangeCommand(*group, "add", "Add a place", adding, addPlace, run);
    add->add_option("name", adding->name, "Name of the place")->required()->type_name("NAME");
    CLI::Option* where =
        add->add_option("where", adding->where,
                        "west,south,east,north in degrees, POLYGON ((lon lat, ...)), or a polygon file");
    where->type_name("W,S,E,N|WKT|FILE");
    add->add_option("--building", adding->building, "The outline of this building, by id or name")
        ->excludes(where)
        ->type_name("BUILDING");
    addPlaceOptions(*add, adding->place);
    addListCommand(*group, "List the places", listPlaces, run);
    addRemoveCommand(*group, "Remove places", removePlaces, run);
}

}  // namespace noonmark::cli
