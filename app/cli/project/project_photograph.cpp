#include <fmt/format.h>
#include <sstream>

#include "app/cli/base/change_project.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/project/project_commands.h"
#include "app/input/load_city.h"
#include "core/base/safe_text.h"

namespace noonmark::cli {

namespace {

struct PhotographOptions {
    ChangeOptions change;
    std::string file;
    std::optional<std::string> attribution;
    std::optional<double> opacityPct;
    bool show = false, hide = false, remove = false;
};

// The file is read once, so that one without a position or away from the city is refused here.
Result<GroundPictureFile> choosePicture(const PhotographOptions& options, const Project& project) {
    if (options.file.empty() && !project.groundPicture)
        return failure("The project has no aerial photograph", "FILE", "Give a GeoTIFF");
    if (options.file.empty()) return *project.groundPicture;
    const Interrupt interrupt;
    NoProgress progress;
    const GroundPictureFile wanted{std::filesystem::absolute(options.file), {}, {}};
    return loadPhotograph(wanted, *project.city, progress, interrupt.token())
        .map([](const Photograph& photograph) { return photograph.file; });
}

std::string describe(const GroundPictureFile& picture) {
    return fmt::format("Aerial photograph: {}{}{}, {:.0f} % opaque\n", picture.path.string(),
                       picture.attribution.empty() ? "" : ", ", picture.attribution, picture.opacity * 100) +
           (picture.shown ? "" : "It is hidden\n");
}

Result<std::string> changePhotograph(const PhotographOptions& options, Project& project) {
    if (options.remove) {
        project = withGroundPicture(std::move(project), std::nullopt, nullptr);
        return std::string("No aerial photograph\n");
    }
    auto picture = choosePicture(options, project);
    if (!picture) return tl::make_unexpected(picture.error());
    if (options.attribution) picture->attribution = *options.attribution;
    if (options.opacityPct) picture->opacity = *options.opacityPct / 100;
    if (options.show || options.hide) picture->shown = options.show;
    project = withGroundPicture(std::move(project), *picture, nullptr);
    return describe(*picture);
}

}  // namespace

void addProjectPhotograph(CLI::App& project, Run& run) {
    const auto options = std::make_shared<PhotographOptions>();
    CLI::App* command = addChangeCommand(
        project, "photograph",
        "Lay an aerial photograph on the ground of views, maps and sheets; the project refers to its file",
        options, changePhotograph, run);
    CLI::Option* file = command
                            ->add_option("file", options->file,
                                         "A GeoTIFF, or another picture with a position that GDAL reads")
                            ->type_name("FILE");
    command
        ->add_option("--attribution", options->attribution,
                     "Whose picture it is, printed wherever it is drawn")
        ->type_name("TEXT");
    command->add_option("--opacity", options->opacityPct, "How opaque it is, percent")
        ->check(within(0, 100))
        ->type_name("PERCENT");
    CLI::Option* hide = command->add_flag("--hide", options->hide, "Keep it, and do not draw it");
    command->add_flag("--show", options->show, "Draw it again")->excludes(hide);
    command->add_flag("--remove", options->remove, "Forget it; its file stays")->excludes(file);
}

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
    return words.str() +
           fmt::format("Map on the ground: {}, {}, {}\n", countOf(context->areas.size(), "area"),
                       countOf(context->lines.size(), "line"), countOf(context->trees.size(), "tree"));
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
