#include <fmt/format.h>

#include <memory>
#include <sstream>

#include "app/cli/base/interrupt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/field_options.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/project/edit_scenario.h"
#include "app/cli/project/project_commands.h"
#include "core/io/files/plain_file.h"
#include "core/io/meshes/ifc_site.h"
#include "core/io/settings/read_settings.h"
#include "scenarios/edits/apply_edits.h"
#include "scenarios/edits/read_shape.h"

namespace noonmark::cli {

namespace {

std::string shapeFormats() { return listNames({FileKind::mesh, FileKind::cityJson}); }

// A building's shape from a file, and its placement.
struct ShapeOptions : EditOptions {
    std::string mesh;
    std::string id;
    ReadSettings read;
    std::optional<LonLat> at;        // centre of its outline
    std::optional<LonLat> originAt;  // the mesh's own origin
    double eastM = 0;
    double northM = 0;
    std::optional<double> scale, clockwiseDeg;
    std::string replaced;                      // the building to replace
    bool reload = false;                       // the file's next edition
    std::set<std::string, std::less<>> given;  // flags of settings of reading
};

struct Shape {
    ImportMesh import;
    Warnings warnings;
    bool hasPlace = false;  // CityJSON contains its position
    OwnPlace own{};         // of an IFC
};

Result<Shape> shapeFrom(const ShapeOptions& options, const std::string& id, const Frame& frame) {
    const auto kind = detectFileKind(options.mesh);
    if (!kind) return tl::make_unexpected(kind.error());
    if (*kind != FileKind::mesh && *kind != FileKind::cityJson)
        return failure("The file is the map of a city, not one building", options.mesh,
                       "Give a file of one of these formats: " + shapeFormats());
    Shape shape{.hasPlace = *kind != FileKind::mesh};
    const Interrupt interrupt;
    NoProgress progress;
    ReadSettings read = options.read;
    // Before the limits of what a building can be
    if (!shape.hasPlace && options.scale) read.meshScale = *options.scale;
    auto import = readShape(options.mesh, id, read, frame, shape.warnings, progress, interrupt.token());
    if (!import) return tl::make_unexpected(import.error());
    shape.import = *std::move(import);
    shape.own = findOwnPlace(options.mesh, frame, interrupt.token());
    return shape;
}

bool standsWhereItStates(const ShapeOptions& options, const Shape& shape) {
    return !options.at && !options.originAt && options.replaced.empty() && shape.own.originM.has_value();
}

// Instead of what the reader says of a place that it was not asked for.
void warnOfOwnPlace(Shape& shape, const std::string& file) {
    std::erase_if(shape.warnings,
                  [](const Warning& warning) { return warning.what.starts_with(unusedIfcPlace); });
    shape.warnings.push_back(
        {WarningKind::assumed,
         fmt::format("it stands and is turned as it states ({}); --at or --origin-at, and "
                     "--clockwise, place it otherwise",
                     shape.own.words),
         std::filesystem::path(file).filename().string()});
}

// Where an IFC says that it stands, turned as it says.
Placement placementOfOwn(const ShapeOptions& options, const OwnPlace& own) {
    return {.clockwiseDeg = options.clockwiseDeg.value_or(own.clockwiseDeg.value_or(0)),
            .byM = *own.originM + glm::dvec2(options.eastM, options.northM)};
}

// `standard`: position of the centre if the user gives none.
Result<Placement> placementOf(const ShapeOptions& options, const Shape& shape, const Frame& frame,
                              std::optional<glm::dvec2> standard) {
    if (standsWhereItStates(options, shape)) return placementOfOwn(options, shape.own);
    Placement placement{.scale = shape.hasPlace ? options.scale.value_or(1) : 1,
                        .clockwiseDeg = options.clockwiseDeg.value_or(0)};
    if (!options.originAt) placement.about = findMiddle(*shape.import.shape);
    std::optional<glm::dvec2> target = standard;
    if (shape.hasPlace) target = placement.about;
    if (options.at) target = frame.localFromLonLat(*options.at);
    if (options.originAt) target = frame.localFromLonLat(*options.originAt);
    if (!target)
        return failure("The position of the mesh is not given", options.mesh,
                       "Give --at LON,LAT for its middle, or --origin-at LON,LAT for its origin");
    placement.byM = *target - placement.about + glm::dvec2(options.eastM, options.northM);
    return placement;
}

// The shape at its placement.
Result<Building> standOnTerrain(const ShapeOptions& options, const Shape& shape, const Placement& placement) {
    Building building = placeBuilding(*shape.import.shape, placement);
    if (topM(building) > 0) return building;
    return failure("The building would lie below the ground", options.mesh,
                   "A mesh's heights count from its own zero: check --up, or raise it in the file");
}

std::string describeShape(const std::string& words, const Shape& shape, const Building& there) {
    const Box2 box = bounds(there);
    std::ostringstream all;
    all << words
        << fmt::format("  {:.1f} m from west to east, {:.1f} m from south to north, {:.1f} m high\n",
                       double(box.high.x - box.low.x), double(box.high.y - box.low.y), double(topM(there)));
    printWarnings(all, shape.warnings);
    return all.str();
}

Result<std::string> withShape(const ShapeOptions& options, Project& project, const Shape& shape,
                              const Building& there, const Edit& edit) {
    return withEdits(project, options.scenario, {edit}).map([&](const std::string& words) {
        return describeShape(words, shape, there);
    });
}

// The import of this file in a scenario, else of the building with this id.
Result<const ImportMesh*> findEarlier(const ShapeOptions& options, Project& project) {
    const auto scenario = scenarioToChange(project, options.scenario);
    if (!scenario) return tl::make_unexpected(scenario.error());
    const std::string file = std::filesystem::path(options.mesh).filename().string();
    std::vector<const ImportMesh*> found;
    for (const Edit& edit : (*scenario)->edits)
        if (const auto* import = std::get_if<ImportMesh>(&edit))
            if (options.id.empty() ? import->file == file : import->shape->sourceId == options.id)
                found.push_back(import);
    if (found.size() == 1) return found.front();
    return failure(
        found.empty() ? "No earlier edition of it is in the scenario"
                      : "Several buildings of the scenario come from it",
        options.id.empty() ? file : options.id,
        found.empty() ? "Name its building with --id, or import it without --reload" : "Name one with --id");
}

// What the user states anew comes before what the earlier edition was read and placed with.
ShapeOptions optionsOfEdition(const ShapeOptions& options, const ImportMesh& earlier) {
    ShapeOptions edition = options;
    applyReading(earlier, edition.read);
    copyFields(readSettingsFields().of(options.read), readSettingsFields().of(edition.read), options.given);
    if (options.read.crs) edition.read.crs = options.read.crs;
    if (!options.read.lod.empty()) edition.read.lod = options.read.lod;
    if (!edition.clockwiseDeg) edition.clockwiseDeg = earlier.placement.clockwiseDeg;
    return edition;
}

// Where the earlier edition's base point stands, unless the user names another place.
Result<Placement> placementOfEdition(const ShapeOptions& options, const Shape& shape, const Frame& frame,
                                     const ImportMesh& earlier) {
    if (options.at || options.originAt) return placementOf(options, shape, frame, {});
    Placement placement = earlier.placement;
    placement.clockwiseDeg = *options.clockwiseDeg;
    if (shape.hasPlace && options.scale) placement.scale = *options.scale;
    placement.byM += glm::dvec2(options.eastM, options.northM);
    return placement;
}

Result<std::string> reload(const ShapeOptions& options, Project& project) {
    const auto earlier = findEarlier(options, project);
    if (!earlier) return tl::make_unexpected(earlier.error());
    const ShapeOptions all = optionsOfEdition(options, **earlier);
    const Frame& frame = project.city->frame;
    auto shape = shapeFrom(all, (*earlier)->shape->sourceId, frame);
    if (!shape) return tl::make_unexpected(shape.error());
    const auto placement = placementOfEdition(all, *shape, frame, **earlier);
    if (!placement) return tl::make_unexpected(placement.error());
    shape->import.placement = *placement;
    shape->import.storeyHeightM = (*earlier)->storeyHeightM;
    const auto there = standOnTerrain(all, *shape, *placement);
    if (!there) return tl::make_unexpected(there.error());
    replaceImports(project.scenarios, asEditionOf(shape->import, **earlier));
    return checkApplies(project, options.scenario).map([&] {
        return describeShape(fmt::format("{}: reload {}\n", options.scenario, shape->import.file), *shape,
                             *there);
    });
}

Result<std::string> import(const ShapeOptions& options, Project& project) {
    if (options.reload) return reload(options, project);
    if (options.id.empty())
        return failure("The new building has no id", options.mesh, "Give --id NAME, or --reload");
    const Frame& frame = project.city->frame;
    auto shape = shapeFrom(options, options.id, frame);
    if (!shape) return tl::make_unexpected(shape.error());
    if (standsWhereItStates(options, *shape)) warnOfOwnPlace(*shape, options.mesh);
    const auto placement = placementOf(options, *shape, frame, {});
    if (!placement) return tl::make_unexpected(placement.error());
    const auto there = standOnTerrain(options, *shape, *placement);
    if (!there) return tl::make_unexpected(there.error());
    shape->import.placement = *placement;
    return withShape(options, project, *shape, *there, shape->import);
}

Result<std::string> replace(const ShapeOptions& options, Project& project) {
    const auto city = cityOf(project, options.scenario);
    if (!city) return tl::make_unexpected(city.error());
    const auto found = findBuilding(city->city, options.replaced);
    if (!found) return tl::make_unexpected(found.error());
    const Building& old = *city->city.buildings[*found];
    const Frame& frame = project.city->frame;
    const auto shape = shapeFrom(options, options.id.empty() ? old.sourceId : options.id, frame);
    if (!shape) return tl::make_unexpected(shape.error());
    const auto placement = placementOf(options, *shape, frame, findMiddle(old));
    if (!placement) return tl::make_unexpected(placement.error());
    auto there = standOnTerrain(options, *shape, *placement);
    if (!there) return tl::make_unexpected(there.error());
    if (options.id.empty()) there->name = old.name;
    const Replace edit{old.sourceId, std::make_shared<const Building>(*there)};
    return withShape(options, project, *shape, *there, edit);
}

void addPlaceOptions(CLI::App& command, ShapeOptions& options) {
    CLI::Option* at = addLonLatOption(command, "--at", options.at,
                                      "Position of the centre of its outline, degrees (default: where an IFC "
                                      "or city model states that it stands)");
    addLonLatOption(command, "--origin-at", options.originAt, "Position of the mesh's own origin, degrees")
        ->excludes(at);
    command.add_option("--east", options.eastM, "Offset from there to the east, m")
        ->check(within(-20000, 20000))
        ->type_name("M");
    command.add_option("--north", options.northM, "Offset from there to the north, m")
        ->check(within(-20000, 20000))
        ->type_name("M");
    command.add_option("--scale", options.scale, "Scale factor, also of the heights (default 1)")
        ->check(within(0.001, 1000))
        ->type_name("FACTOR");
    command.add_option("--clockwise", options.clockwiseDeg, "Turn it clockwise, degrees seen from above")
        ->check(within(-360, 360))
        ->type_name("DEG");
}

void addShapeOptions(CLI::App& command, ShapeOptions& options) {
    addPlaceOptions(command, options);
    addFieldOptions(command, meshAxesFields().of(options.read), {.given = &options.given});
    addFieldOptions(command, standFields().of(options.read), {.given = &options.given});
    command
        .add_option("--crs", options.read.crs, "CityJSON that does not state its reference system: EPSG:2263")
        ->type_name("CRS");
    command
        .add_option("--lod", options.read.lod, "CityGML, CityJSON: level of detail (default: the highest)")
        ->type_name("LOD");
}

}  // namespace

void addProjectImport(CLI::App& project, Run& run) {
    const auto options = std::make_shared<ShapeOptions>();
    CLI::App* command =
        addEditCommand(project, "import", "Put the building of a mesh or CityJSON file into a scenario",
                       options, import, run);
    command
        ->add_option("file", options->mesh,
                     "The file (" + shapeFormats() + "); all its solids are one building")
        ->required()
        ->type_name("FILE");
    command->add_option("--id", options->id, "Id and name of the new building")->type_name("NAME");
    command->add_flag("--reload", options->reload,
                      "The file's next edition: it takes the place of the building that was imported from a "
                      "file of this name (or has this --id), read and placed as that was; edits that follow "
                      "stay");
    addShapeOptions(*command, *options);
}

void addProjectReplace(CLI::App& project, Run& run) {
    const auto options = std::make_shared<ShapeOptions>();
    CLI::App* command = addEditCommand(
        project, "replace", "Replace a building of a scenario with that of a mesh or CityJSON file", options,
        replace, run);
    command->add_option("building", options->replaced, "Its id or name")->required()->type_name("BUILDING");
    command
        ->add_option("--with", options->mesh,
                     "The file (" + shapeFormats() +
                         "); by default a mesh is placed at the centre of the old building")
        ->required()
        ->type_name("FILE");
    command->add_option("--id", options->id, "Id and name of the new building (default: the old one's)")
        ->type_name("NAME");
    addShapeOptions(*command, *options);
}

}  // namespace noonmark::cli
