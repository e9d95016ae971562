#include <memory>

#include "app/cli/command.h"
#include "app/cli/load_city.h"
#include "app/cli/save_city.h"

namespace noonmark::cli {

namespace {

struct ImportOptions {
    ReadOptions read;
    std::string out;
    bool json = false;
};

int runImport(const ImportOptions& options, const Console& console) {
    const auto loaded = loadCity(options.read, console);
    if (!loaded) return fail(console, loaded.error(), exitUsage);
    return saveCity(loaded->read.city, options.out, options.json, console, loaded->read.warnings);
}

}  // namespace

void addImportCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<ImportOptions>();
    CLI::App* command = app.add_subcommand("import", "Read a city, mend it, and write it as one GeoPackage");
    addReadOptions(*command, options->read);
    command->add_option("--out", options->out, "The file to write")->required()->type_name("FILE.gpkg");
    command->add_flag("--json", options->json, "Say what was written as JSON");
    command->callback([options, &run] {
        run = [options](const Console& console) { return runImport(*options, console); };
    });
}

}  // namespace noonmark::cli
