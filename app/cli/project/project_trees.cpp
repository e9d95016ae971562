#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <set>
#include <sstream>
#include <utility>

#include "app/cli/base/interrupt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/field_options.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/project/edit_scenario.h"
#include "app/cli/project/list_project.h"
#include "app/cli/project/project_commands.h"
#include "app/input/import_trees.h"
#include "core/base/safe_text.h"
#include "core/city/trees/tree_facts.h"
#include "core/io/read_region.h"
#include "core/io/trees/read_trees.h"
#include "core/study/text/terrain_text.h"
#include "scenarios/edits/apply_edits.h"
#include "scenarios/edits/tree_edits.h"

namespace noonmark::cli {

namespace {

struct TreeImportOptions {
    ChangeOptions change;
    std::vector<std::string> files;
    std::string crs;
    std::vector<std::string> fields;  // ROLE=FIELD:UNIT
};

// Trees of the scenario's city, by id or inside a region.
struct TreesOptions : EditOptions {
    std::vector<std::string> trees;
    std::string within;
};

struct TreeAddOptions : EditOptions {
    std::vector<std::string> at;     // LON,LAT
    std::vector<std::string> along;  // the corners of a line
    double spacingM = 8;
    TreeFacts facts;
};

struct TreeMoveOptions : TreesOptions {
    glm::dvec2 byM{0};
};

struct TreeGrowOptions : TreesOptions {
    double years = 0;
};

struct LeafOptions {
    ChangeOptions change;
    std::string on, off;  // MM-DD
};

struct TreeReplaceOptions : TreesOptions {
    TreeFacts facts;
};

Result<TreeReading> makeTreeReading(const TreeImportOptions& options) {
    TreeReading how;
    if (!options.crs.empty()) how.crs = options.crs;
    for (const std::string& text : options.fields) {
        auto choice = parseTreeFieldChoice(text);
        if (!choice) return tl::make_unexpected(choice.error());
        how.fields.push_back(*std::move(choice));
    }
    return how;
}

Result<std::string> importTreeFiles(const TreeImportOptions& options, Project& project) {
    const Interrupt interrupt;
    NoProgress progress;
    const auto how = makeTreeReading(options);
    if (!how) return tl::make_unexpected(how.error());
    auto imported =
        importTrees(project, {options.files.begin(), options.files.end()}, *how, progress, interrupt.token());
    if (!imported) return tl::make_unexpected(imported.error());
    project = std::move(imported->project);
    std::ostringstream words;
    const auto& trees = project.city->trees;
    words << fmt::format("{} read; the project has {}\n", countOf(imported->added, "tree"),
                         trees ? describeTrees(*trees) : "none");
    printWarnings(words, imported->warnings);
    return words.str();
}

std::string describeLeaves(const Tree& tree, const LeafDays& ofCity) {
    if (tree.evergreen) return "evergreen";
    if (!tree.leafOnDay && !tree.leafOffDay) return "loses its leaves";
    const LeafDays days = leafDaysOf(tree, ofCity);
    return fmt::format("in leaf from {} up to and without {}", formatDayOfYear(days.on),
                       formatDayOfYear(days.off));
}

nlohmann::json dayJson(const std::optional<int>& day) {
    return day ? nlohmann::json(formatDayOfYear(*day)) : nlohmann::json();
}

std::vector<Listed> listTrees(const Project& project) {
    std::vector<Listed> lines;
    if (!project.city->trees) return lines;
    for (const Tree& tree : project.city->trees->trees) {
        const LonLat at = project.city->frame.lonLatFromLocal(tree.place);
        lines.push_back({tree.sourceId,
                         fmt::format("{}{:.1f} m high ({}), crown {:.1f} m ({}), {}",
                                     tree.species.empty() ? "" : tree.species + ", ", tree.heightM,
                                     nameOf(tree.heightSource), tree.crownDiameterM, nameOf(tree.crownSource),
                                     describeLeaves(tree, project.city->trees->leafDays)),
                         {{"species", tree.species},
                          {"lon_deg", at.lonDeg},
                          {"lat_deg", at.latDeg},
                          {"height_m", tree.heightM},
                          {"height_source", nameOf(tree.heightSource)},
                          {"crown_diameter_m", tree.crownDiameterM},
                          {"crown_source", nameOf(tree.crownSource)},
                          {"crown_base_m", tree.crownBaseM},
                          {"shape", nameOf(tree.shape)},
                          {"evergreen", tree.evergreen},
                          {"leaf_on_day", dayJson(tree.leafOnDay)},
                          {"leaf_off_day", dayJson(tree.leafOffDay)}}});
    }
    return lines;
}

Result<glm::dvec2> parsePosition(const std::string& text, const Frame& frame) {
    return parseLonLat(text).map([&](LonLat at) { return frame.localFromLonLat(at); });
}

Result<std::vector<glm::dvec2>> parsePositions(const std::vector<std::string>& texts, const Frame& frame) {
    std::vector<glm::dvec2> places;
    for (const std::string& text : texts) {
        const auto place = parsePosition(text, frame);
        if (!place) return tl::make_unexpected(place.error());
        places.push_back(*place);
    }
    return places;
}

Result<std::vector<glm::dvec2>> placesOf(const TreeAddOptions& options, const Frame& frame) {
    auto places = parsePositions(options.at, frame);
    if (!places || options.along.empty()) return places;
    return parsePositions(options.along, frame)
        .and_then(
            [&](const std::vector<glm::dvec2>& line) { return placeTreesAlong(line, options.spacingM); })
        .map([&](const std::vector<glm::dvec2>& row) {
            places->insert(places->end(), row.begin(), row.end());
            return *places;
        });
}

Result<City> cityToChange(Project& project, const std::string& scenario) {
    if (const auto known = scenarioToChange(project, scenario); !known)
        return tl::make_unexpected(known.error());
    return cityOf(project, scenario).map([](const EditedCity& edited) { return edited.city; });
}

Result<std::string> plantTrees(const TreeAddOptions& options, Project& project) {
    const auto city = cityToChange(project, options.scenario);
    if (!city) return tl::make_unexpected(city.error());
    const auto places = placesOf(options, city->frame);
    if (!places) return tl::make_unexpected(places.error());
    if (places->empty()) return failure("No place is given", "add", "Give --at or --along");
    const auto designed = designTree(options.facts);
    if (!designed) return tl::make_unexpected(designed.error());
    return withEdits(project, options.scenario, makePlantings(*city, *designed, *places));
}

Result<std::set<std::size_t>> findInside(const std::string& within, const City& city) {
    std::set<std::size_t> inside;
    if (within.empty() || !city.trees) return inside;
    const auto region = readRegion(within, city.frame);
    if (!region) return tl::make_unexpected(region.error());
    for (std::size_t i = 0; i < city.trees->trees.size(); ++i)
        if (std::ranges::any_of(region->polygons, [&](const Footprint& area) {
                return contains(area, city.trees->trees[i].place);
            }))
            inside.insert(i);
    return inside;
}

// Each once, though it may be named and stand in the area, too.
Result<std::vector<Tree>> findTrees(const TreesOptions& options, const City& city) {
    auto chosen = findInside(options.within, city);
    if (!chosen) return tl::make_unexpected(chosen.error());
    for (const std::string& id : options.trees) {
        const auto at = findTree(city, id);
        if (!at) return tl::make_unexpected(at.error());
        chosen->insert(*at);
    }
    std::vector<Tree> found;
    for (const std::size_t at : *chosen) found.push_back(city.trees->trees[at]);
    return found;
}

// One edit for each of the trees that it changes; `make` gives none for the others.
template <class Make>
Result<std::string> editTrees(const TreesOptions& options, Project& project, Make&& make) {
    const auto city = cityToChange(project, options.scenario);
    if (!city) return tl::make_unexpected(city.error());
    const auto trees = findTrees(options, *city);
    if (!trees) return tl::make_unexpected(trees.error());
    if (trees->empty()) return failure("No tree is chosen", "trees", "Name trees, or give --within");
    std::vector<Edit> edits;
    for (const Tree& tree : *trees)
        if (std::optional<Edit> edit = make(tree)) edits.push_back(*std::move(edit));
    if (edits.empty())
        return failure("None of these trees changes", "trees",
                       "Trees of 35 m or more and cells of a canopy raster do not grow");
    return withEdits(project, options.scenario, edits);
}

Result<std::string> fellTrees(const TreesOptions& options, Project& project) {
    return editTrees(options, project, [](const Tree& tree) { return FellTree{tree.sourceId}; });
}

Result<std::string> moveTrees(const TreeMoveOptions& options, Project& project) {
    if (options.byM == glm::dvec2(0))
        return failure("The trees would stay where they are", "move", "Give --east or --north");
    return editTrees(options, project, [&](const Tree& tree) {
        return MoveTree{tree.sourceId, options.byM};
    });
}

Result<std::string> growTrees(const TreeGrowOptions& options, Project& project) {
    return editTrees(options, project, [&](const Tree& tree) { return makeGrowth(tree, options.years); });
}

Result<std::string> replaceTrees(const TreeReplaceOptions& options, Project& project) {
    return designTree(options.facts).and_then([&](const Tree& with) {
        return editTrees(options, project, [&](const Tree& tree) {
            return ReplaceTree{tree.sourceId, with};
        });
    });
}

Result<std::string> setLeafDays(const LeafOptions& options, Project& project) {
    if (!project.city->trees)
        return failure("The project has no trees", "leaves", "Read some: noonmark-cli project tree import");
    if (options.on.empty() && options.off.empty())
        return failure("No day is given", "leaves", "Give --leaf-on or --leaf-off: MM-DD");
    Trees trees = *project.city->trees;
    for (const auto& [text, day] :
         {std::pair(&options.on, &trees.leafDays.on), std::pair(&options.off, &trees.leafDays.off)}) {
        if (text->empty()) continue;
        const auto stated = parseDayOfYear(*text);
        if (!stated) return tl::make_unexpected(stated.error());
        *day = *stated;
    }
    const std::string words =
        trees.leafDays.on == trees.leafDays.off
            ? "All trees are in leaf all year\n"
            : fmt::format("Trees that lose their leaves have them from {} up to and without {}\n",
                          formatDayOfYear(trees.leafDays.on), formatDayOfYear(trees.leafDays.off));
    City city = *project.city;
    city.trees = std::make_shared<const Trees>(std::move(trees));
    project.city = std::make_shared<const City>(std::move(city));
    return words;
}

void addTrees(CLI::App& command, TreesOptions& options) {
    command.add_option("trees", options.trees, "Ids of the trees")->type_name("TREE");
    command
        .add_option("--within", options.within,
                    "All trees inside west,south,east,north in degrees, POLYGON ((lon lat, ...)), or a "
                    "polygon file")
        ->type_name("W,S,E,N|WKT|FILE");
}

void addTreeAdd(CLI::App& group, Run& run) {
    const auto options = std::make_shared<TreeAddOptions>();
    CLI::App* add = addEditCommand(group, "add", "Plant trees in a scenario", options, plantTrees, run);
    add->add_option("--at", options->at, "Where a tree is planted; may be repeated")->type_name("LON,LAT");
    add->add_option("--along", options->along, "Corners of a line along which a row is planted")
        ->type_name("LON,LAT");
    add->add_option("--spacing", options->spacingM, "Distance between the trees of a row, m")
        ->check(within(0.5, 1000))
        ->type_name("M");
    addFieldOptions(*add, treeFactFields().of(options->facts));
}

void addTreeImport(CLI::App& group, Run& run) {
    const auto options = std::make_shared<TreeImportOptions>();
    CLI::App* read = addChangeCommand(
        group, "import", "Add trees of inventories, OpenStreetMap or canopy rasters to the existing city",
        options, importTreeFiles, run);
    read->add_option("files", options->files, "The files")->required()->type_name("FILE");
    read->add_option("--crs", options->crs,
                     "Coordinate reference system of files that do not state it: EPSG:2263")
        ->type_name("CRS");
    read->add_option("--field", options->fields,
                     "Field of a measure or name in place of that found by its name, and its unit: "
                     "height=HOEHE, stem=DBH:in, crown= (none); of a canopy raster its unit: height=:ft; "
                     "may be repeated")
        ->allow_extra_args(false)
        ->type_name("ROLE=FIELD:UNIT");
}

void addTreeLeaves(CLI::App& group, Run& run) {
    const auto options = std::make_shared<LeafOptions>();
    CLI::App* leaves =
        addChangeCommand(group, "leaves",
                         "State between which days trees that lose their leaves have them (default: those "
                         "assumed for the latitude)",
                         options, setLeafDays, run);
    leaves->add_option("--leaf-on", options->on, "First day in leaf")->type_name("MM-DD");
    leaves->add_option("--leaf-off", options->off, "First day without leaves")->type_name("MM-DD");
}

void addTreeChanges(CLI::App& group, Run& run) {
    const auto felled = std::make_shared<TreesOptions>();
    addTrees(*addEditCommand(group, "remove", "Fell trees in a scenario", felled, fellTrees, run), *felled);
    const auto moved = std::make_shared<TreeMoveOptions>();
    CLI::App* move = addEditCommand(group, "move", "Move trees of a scenario", moved, moveTrees, run);
    addTrees(*move, *moved);
    move->add_option("--east", moved->byM.x, "Distance to the east, m; negative: to the west")
        ->check(within(-20000, 20000))
        ->type_name("M");
    move->add_option("--north", moved->byM.y, "Distance to the north, m; negative: to the south")
        ->check(within(-20000, 20000))
        ->type_name("M");
    const auto grown = std::make_shared<TreeGrowOptions>();
    CLI::App* grow =
        addEditCommand(group, "grow", "Let trees of a scenario grow for some years", grown, growTrees, run);
    addTrees(*grow, *grown);
    grow->add_option("--years", grown->years, "Number of years")
        ->required()
        ->check(within(0.1, 200))
        ->type_name("YEARS");
    const auto replaced = std::make_shared<TreeReplaceOptions>();
    CLI::App* replace = addEditCommand(group, "replace", "Replace trees of a scenario by others", replaced,
                                       replaceTrees, run);
    addTrees(*replace, *replaced);
    addFieldOptions(*replace, treeFactFields().of(replaced->facts));
}

}  // namespace

void addProjectTree(CLI::App& project, Run& run) {
    CLI::App* group = project.add_subcommand("tree", "Trees of the city and of scenarios");
    group->require_subcommand(1);
    addTreeImport(*group, run);
    addListCommand(*group, "List the trees of the existing city", listTrees, run);
    addTreeAdd(*group, run);
    addTreeChanges(*group, run);
    addTreeLeaves(*group, run);
}

}  // namespace noonmark::cli
