#include <map>
#include <memory>

#include "app/cli/base/change_project.h"
#include "app/cli/base/command.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/save_city.h"
#include "app/cli/options/overwrite_option.h"
#include "app/cli/project/drawn_times.h"
#include "app/cli/project/project_commands.h"
#include "app/input/output_rules.h"
#include "app/report/bodies/body_files.h"
#include "core/describe/command_flags.h"
#include "scenarios/massing/tower_design.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

namespace {

struct ExportOptions {
    std::string file;
    std::string scenario;
    std::string out;
    BodyFileSettings bodies;
    bool overwrite = false;
    bool json = false;
};

const std::map<std::string, WrittenBuildings> buildingNames{{"all", WrittenBuildings::all},
                                                            {"proposed", WrittenBuildings::proposed}};

int runExport(const ExportOptions& options, const Console& console) {
    const OffscreenQt qt;  // finds the library that writes glTF and OBJ
    const auto disk = ProjectFile::open(options.file);
    if (!disk) return fail(console, disk.error(), exitUsage);
    const OutputRules rules = outputRules({options.file}, disk->project().inputs, options.overwrite);
    if (const auto may = checkOutput(options.out, detectOutputKind(options.out), rules); !may)
        return fail(console, may.error(), exitUsage);
    const auto city = cityOf(disk->project(), options.scenario);
    if (!city) return fail(console, city.error(), exitUsage);
    const auto proposed = listProposed(disk->project().scenarios, options.scenario);
    if (!proposed) return fail(console, proposed.error(), exitUsage);
    auto written = writeBodies(options.out, city->city, *proposed, options.bodies);
    if (!written) return fail(console, written.error(), exitUsage);
    printSaved(
        {options.out, written->buildings, written->parts, written->plane, std::move(written->warnings)},
        options.json, console.out);
    return exitOk;
}

}  // namespace

void addProjectExport(CLI::App& project, Run& run) {
    const auto options = std::make_shared<ExportOptions>();
    CLI::App* command = project.add_subcommand(
        "export", "Write the buildings of a scenario for GIS and CAD: GeoPackage, DXF, OBJ, glTF");
    addProjectFile(*command, options->file);
    command->add_option(flags::scenario, options->scenario, "The scenario to write")
        ->default_val(existingCity)
        ->type_name("NAME");
    command->add_option(flags::out, options->out, "The file to write; its ending chooses the format")
        ->required()
        ->type_name("FILE.gpkg|dxf|obj|glb");
    command->add_option("--buildings", options->bodies.which, "all (default), or those the scenario proposes")
        ->transform(CLI::CheckedTransformer(buildingNames).description(""))
        ->type_name("all|proposed");
    addPlaneOption(*command, options->bodies.plane, "Plane of DXF: local (default) or utm");
    addOverwriteOption(*command, options->overwrite);
    addJsonFlag(*command, options->json, "Report what was written as JSON");
    command->callback([options, &run] {
        run = [options](const Console& console) { return runExport(*options, console); };
    });
}

}  // namespace noonmark::cli
