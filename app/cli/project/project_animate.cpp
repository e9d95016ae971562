#include <fmt/format.h>

#include <memory>
#include <ostream>

#include "app/cli/base/change_project.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/project/drawn_times.h"
#include "app/cli/project/project_commands.h"
#include "app/input/load_city.h"
#include "app/report/movie/shadow_movie.h"
#include "core/base/safe_text.h"
#include "core/describe/command_options.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

namespace {

struct AnimateOptions {
    std::string file, from, to, out, title, size = "1280x720";
    DrawnTimeChoice when;
    DrawnAreaOptions where;
    DrawingSettings drawing;
    int year = 0;
    MovieFormat format;
    bool swipe = false;
    bool overwrite = false;
};

Result<QSize> sizeOf(const std::string& text) {
    int width = 0, height = 0;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) == 2) return QSize(width, height);
    return failure("The size is not two numbers", text, "Give width and height in pixels: 1280x720");
}

Result<ShadowMovie> movieOf(const AnimateOptions& options, const Project& project) {
    auto before = cityOf(project, options.from);
    if (!before) return tl::make_unexpected(before.error());
    if (const auto given = checkTimesGiven(options.when); !given) return tl::make_unexpected(given.error());
    const auto area = findDrawnArea(options.where, project, before->city);
    if (!area) return tl::make_unexpected(area.error());
    const auto size = sizeOf(options.size);
    if (!size) return tl::make_unexpected(size.error());
    ShadowMovie movie{.baseline = std::make_shared<const City>(std::move(before->city)),
                      .places = project.places,
                      .when = options.when,
                      .drawing = options.drawing,
                      .title = options.title,
                      .credit = project.attribution,
                      .swipe = options.swipe,
                      .format = options.format,
                      .outputs = outputRules({options.file}, project.inputs, options.overwrite)};
    if (options.year != 0) movie.when.days = listDaysOf(options.year);
    movie.drawing.area = *area;
    movie.format.size = *size;
    if (movie.title.empty())
        movie.title = options.to.empty() ? "Shadow: " + options.from
                                         : fmt::format("{} compared with {}", options.to, options.from);
    if (options.to.empty()) return movie;
    auto after = cityOf(project, options.to);
    if (!after) return tl::make_unexpected(after.error());
    movie.scenario = std::make_shared<const City>(std::move(after->city));
    return movie;
}

Result<MovieFacts> film(const ShadowMovie& movie, const std::string& file, const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    return writeShadowMovie(movie, file, progress, interrupt.token());
}

int runAnimate(const AnimateOptions& options, const Console& console) {
    const OffscreenQt qt;
    const auto disk = openProject(options.file, console);
    if (!disk) return fail(console, disk.error(), exitUsage);
    const auto movie = movieOf(options, disk->project());
    if (!movie) return fail(console, movie.error(), exitUsage);
    const auto made = film(*movie, options.out, console);
    if (!made) return fail(console, made.error(), exitUsage);
    console.out << fmt::format("{}: {}, {:.1f} s\n", options.out,
                               countOf(std::uint64_t(made->frames), "frame"), made->seconds);
    printWarnings(console.out, made->warnings);
    return exitOk;
}

void addQuestion(CLI::App& command, AnimateOptions& options) {
    addProjectFile(command, options.file);
    command.add_option(flags::from, options.from, "The baseline: the scenario to compare with")
        ->default_val(existingCity)
        ->type_name("NAME");
    command.add_option(flags::to, options.to, "The scenario to show (default: the baseline alone)")
        ->type_name("NAME");
    CLI::Option* day = addDrawnTimeOptions(command, options.when);
    CLI::Option* year = command.add_option(flags::year, options.year, "All days of a year, at --times")
                            ->check(within(1901, 2099));
    year->type_name("YEAR")->excludes(day);
    command.add_flag("--swipe", options.swipe,
                     "At the first of the times, uncover the scenario from left to right");
    addDrawnAreaOptions(command, options.where);
    command.add_option("--cell", options.drawing.cellM, "Size of a cell on terrain, m")
        ->capture_default_str()
        ->check(within(ReceiverSettings::minCellM, ReceiverSettings::maxCellM))
        ->type_name("M");
}

void addPicture(CLI::App& command, AnimateOptions& options) {
    command.add_option("--title", options.title, "Title of the movie (default: the scenarios)")
        ->type_name("TEXT");
    command.add_option("--size", options.size, "Pixels, even numbers")
        ->capture_default_str()
        ->type_name("WxH");
    command.add_option("--fps", options.format.framesPerSecond, "Frames per second")
        ->capture_default_str()
        ->check(within(0.5, 60))
        ->type_name("N");
    command.add_option(flags::out, options.out, "The file to write: .mp4 or .gif")
        ->required()
        ->type_name("FILE");
    addOverwriteOption(command, options.overwrite);
}

}  // namespace

void addProjectAnimate(CLI::App& project, Run& run) {
    const auto options = std::make_shared<AnimateOptions>();
    CLI::App* command = project.add_subcommand(
        "animate",
        "Write a movie (MP4, GIF) of the shadows of a day, of a year, or of the change by a scenario");
    addQuestion(*command, *options);
    addPicture(*command, *options);
    command->footer(
        "noonmark-cli project animate town.noonmark.gpkg --to Tower --day 2026-03-21 --every 10 \\\n"
        "    --zone America/New_York --out day.mp4");
    command->callback([options, &run] {
        run = [options](const Console& console) { return runAnimate(*options, console); };
    });
}

}  // namespace noonmark::cli
