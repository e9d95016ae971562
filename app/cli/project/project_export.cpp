#include <memory>

#include "app/cli/base/change_project.h"
#include "app/cli/base/command.h"
#include "app/cli/base/save_city.h"
#include "app/cli/options/overwrite_option.h"
#include "app/cli/project/project_commands.h"
#include "app/input/output_rules.h"
#include "core/describe/command_flags.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

namespace {

struct ExportOptions {
    std::string file;
    std::string scenario;
    std::string out;
    bool overwrite = false;
    bool json = false;
};

int runExport(const ExportOptions& options, const Console& console) {
    const auto disk = ProjectFile::open(options.file);
    if (!disk) return fail(console, disk.error(), exitUsage);
    const OutputRules rules = outputRules({options.file}, disk->project().inputs, options.overwrite);
    if (const auto may = checkOutput(options.out, OutputKind::geoPackage, rules); !may)
        return fail(console, may.error(), exitUsage);
    const auto city = cityOf(disk->project(), options.scenario);
    if (!city) return fail(console, city.error(), exitUsage);
    return saveCity(city->city, options.out, options.json, console);
}

}  // namespace

void addProjectExport(CLI::App& project, Run& run) {
    const auto options = std::make_shared<ExportOptions>();
    CLI::App* command = project.add_subcommand("export", "Write the city of a scenario as a GeoPackage");
    addProjectFile(*command, options->file);
    command->add_option(flags::scenario, options->scenario, "The scenario to write")
        ->default_val(existingCity)
        ->type_name("NAME");
    command->add_option(flags::out, options->out, "The file to write")->required()->type_name("FILE.gpkg");
    addOverwriteOption(*command, options->overwrite);
    addJsonFlag(*command, options->json, "Report what was written as JSON");
    command->callback([options, &run] {
        run = [options](const Console& console) { return runExport(*options, console); };
    });
}

}  // namespace noonmark::cli
