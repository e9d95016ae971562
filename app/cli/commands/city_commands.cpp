#include <memory>

#include "app/cli/base/command.h"
#include "app/cli/base/save_city.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/study/study_request.h"
#include "app/input/load_city.h"
#include "core/describe/command_options.h"
#include "core/io/files/check_output.h"
#include "core/samples/sample_city.h"

namespace noonmark::cli {

namespace {

struct SampleOptions {
    std::string name;
    std::string out;
    GridSampleSettings grid;
    bool overwrite = false;
    bool json = false;
};

int runSample(const SampleOptions& options, const Console& console) {
    if (const auto may = checkOutput(options.out, OutputKind::geoPackage, {{}, options.overwrite}); !may)
        return fail(console, may.error(), exitUsage);
    const auto city = options.name == "grid" ? makeGridSample(options.grid) : sampleCity(options.name);
    if (!city) return fail(console, city.error(), exitUsage);
    return saveCity(*city, options.out, options.json, console);
}

}  // namespace

void addSampleCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<SampleOptions>();
    CLI::App* command = app.add_subcommand("sample", "Write a sample city as a GeoPackage");
    command->add_option("name", options->name, "central-park-south or grid")
        ->required()
        ->check(CLI::IsMember({"central-park-south", "grid"}))
        ->type_name("NAME");
    command->add_option(flags::out, options->out, "The file to write")->required()->type_name("FILE.gpkg");
    addOverwriteOption(*command, options->overwrite);
    command->add_option("--buildings", options->grid.buildings, "grid: number of buildings")
        ->capture_default_str()
        ->check(CLI::Range(100, 50000))
        ->type_name("N");
    command->add_option("--seed", options->grid.seed, "grid: random seed; another number gives another city")
        ->capture_default_str()
        ->type_name("S");
    command->add_option("--roundness", options->grid.roundness, "grid: extra points on curved facades")
        ->capture_default_str()
        ->check(CLI::Range(0, 64))
        ->type_name("R");
    addJsonFlag(*command, options->json, "Report what was written as JSON");
    command->callback([options, command, &run] {
        for (const char* name : {"--buildings", "--seed", "--roundness"})
            if (options->name != "grid" && command->count(name) > 0)
                throw CLI::ValidationError(name, "belongs to the sample `grid`");
        run = [options](const Console& console) { return runSample(*options, console); };
    });
}

namespace {

struct ImportOptions {
    ReadOptions read;
    std::string out;
    bool overwrite = false;
    bool json = false;
};

int runImport(const ImportOptions& options, const Console& console) {
    const OutputRules rules = outputRules(listNamedFiles(options.read), {}, options.overwrite);
    if (const auto may = checkOutput(options.out, OutputKind::geoPackage, rules); !may)
        return fail(console, may.error(), exitUsage);
    const auto loaded = loadCity(options.read, console);
    if (!loaded) return fail(console, loaded.error(), exitUsage);
    return saveCity(loaded->read.city, options.out, options.json, console, loaded->read.warnings);
}

}  // namespace

void addImportCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<ImportOptions>();
    CLI::App* command =
        app.add_subcommand("import", "Read a city, repair it, and write it as one GeoPackage");
    addReadOptions(*command, options->read);
    command->add_option(flags::out, options->out, "The file to write")->required()->type_name("FILE.gpkg");
    addOverwriteOption(*command, options->overwrite);
    addJsonFlag(*command, options->json, "Report what was written as JSON");
    command->callback([options, &run] {
        run = [options](const Console& console) { return runImport(*options, console); };
    });
}

}  // namespace noonmark::cli
