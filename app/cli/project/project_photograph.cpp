#include <fmt/format.h>

#include "app/cli/base/change_project.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/options/number_range.h"
#include "app/cli/project/project_commands.h"
#include "app/input/load_photograph.h"

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

}  // namespace noonmark::cli
