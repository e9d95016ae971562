#include <fmt/format.h>

#include <sstream>

#include "app/cli/base/change_project.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/table.h"
#include "app/cli/project/project_commands.h"
#include "app/input/load_context.h"

namespace noonmark::cli {

namespace {

struct ContextOptions {
    ChangeOptions change;
    std::vector<std::string> files;
    ContextSettings settings;
    bool replace = false;
};

void setContext(Project& project, std::shared_ptr<const MapContext> context) {
    City city = *project.city;
    city.context = std::move(context);
    project.city = std::make_shared<const City>(std::move(city));
}

Result<std::string> changeContext(const ContextOptions& options, Project& project) {
    const Interrupt interrupt;
    NoProgress progress;
    std::ostringstream words;
    auto context = options.replace ? nullptr : project.city->context;
    for (const std::string& file : options.files) {
        auto read = readContext(file, options.settings, project.city->frame, progress, interrupt.token());
        if (!read) return tl::make_unexpected(read.error());
        context = joinContext(context, std::move(read->context));
        printWarnings(words, read->warnings);
    }
    setContext(project, context);
    if (!context) return words.str() + "No map on the ground\n";
    return words.str() + fmt::format("Map on the ground: {} areas, {} lines, {} trees\n",
                                     withCommas(context->areas.size()), withCommas(context->lines.size()),
                                     withCommas(context->trees.size()));
}

}  // namespace

void addProjectContext(CLI::App& project, Run& run) {
    const auto options = std::make_shared<ContextOptions>();
    CLI::App* command = addChangeCommand(
        project, "context", "Add streets, parks, water and trees of map files, which are drawn on the ground",
        options, changeContext, run);
    command->add_option("file", options->files, "OpenStreetMap files, or other vector files with its keys")
        ->type_name("FILE");
    command->add_flag("--replace", options->replace, "Drop what the project had; without files: draw no map");
    command->add_option("--crs", options->settings.crs, "Coordinate system of files that state none")
        ->type_name("EPSG:N");
}

}  // namespace noonmark::cli
