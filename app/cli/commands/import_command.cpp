#include <memory>

#include "app/cli/base/command.h"
#include "app/cli/base/save_city.h"
#include "app/cli/options/overwrite_option.h"
#include "app/cli/study/load_city.h"
#include "app/input/output_rules.h"
#include "core/describe/command_flags.h"

namespace noonmark::cli {

namespace {

struct ImportOptions {
    ReadOptions read;
    std::string out;
    bool overwrite = false;
    bool json = false;
};

int runImport(const ImportOptions& options, const Console& console) {
    const OutputRules rules = outputRules(options.read.files, {}, options.overwrite);
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
