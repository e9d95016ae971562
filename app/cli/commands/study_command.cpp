#include <fmt/format.h>

#include <fstream>
#include <memory>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/progress_line.h"
#include "app/cli/base/study_table.h"
#include "app/cli/options/elevation_sheet_options.h"
#include "app/cli/options/picture_option.h"
#include "app/cli/study/element_run.h"
#include "app/cli/study/study_request.h"
#include "app/input/all_engines.h"
#include "app/report/files/study_files.h"

namespace noonmark::cli {

namespace {

/// A study, and the book that is wanted of it.
struct Answered {
    Study study;
    std::optional<BookSettings> book;
    std::shared_ptr<const ProjectFile> project;
};

Result<std::optional<BookSettings>> bookOf(const StudyOptions& options, const SheetOptions& sheets,
                                           const StudyRequest& request) {
    if (!sheets.wanted) return std::nullopt;
    return bookSettingsOf(sheets, sheetsOf(request)).map([&](BookSettings book) {
        book.legend = options.legend;
        return std::optional(std::move(book));
    });
}

tl::expected<Answered, Failure> computed(const StudyOptions& options, const SheetOptions& sheets,
                                         const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    StudyFileOptions files{.cellsCsv = options.cellsCsv};
    if (sheets.wanted) files.book.emplace();
    auto request =
        parseStudyRequest(options, studyFileNames(options.settings, files), progress, interrupt.token());
    if (!request) return tl::make_unexpected(request.error());
    auto book = orCode(bookOf(options, sheets, *request), exitUsage);
    if (!book) return tl::make_unexpected(book.error());
    auto study = orCode(runStudy(request->loaded.read.city, request->settings, progress, interrupt.token(),
                                 enginesWith(request->settings.engine)),
                        exitFailed);
    if (!study) return tl::make_unexpected(study.error());
    addSource(*study, *request);
    return Answered{*std::move(study), *std::move(book), request->project};
}

Result<std::vector<std::filesystem::path>> writeFiles(const Answered& answered, const StudyOptions& options) {
    const OffscreenQt qt;
    auto files = writeStudyFiles(answered.study, options.out,
                                 {.cellsCsv = options.cellsCsv,
                                  .rules = outputRulesOf(options, answered.study.provenance.inputs),
                                  .pictureWidth = options.pictureWidth,
                                  .legend = options.legend,
                                  .book = answered.book});
    if (!files) return files;
    return copyProjectOf(answered.project, options).map([&] { return *std::move(files); });
}

// As it was written: its times of writing are not known before.
void printFile(const std::filesystem::path& folder, const char* name, std::ostream& out) {
    if (std::ifstream file(folder / name); file) out << file.rdbuf() << '\n';
}

int runStudyCommand(const StudyOptions& options, const SheetOptions& layout, const Console& console) {
    if (options.points && layout.wanted)
        return fail(console,
                    {"A study of points has its sheets always", "--sheets",
                     "Leave it out: elements.pdf is the book of sheets"},
                    exitUsage);
    if (options.points) return runElements(options, layout, console);
    if (const auto ok = checkElementOptions(options); !ok) return fail(console, ok.error(), exitUsage);
    const auto answered = computed(options, layout, console);
    if (!answered) return fail(console, answered.error().error, answered.error().code);
    const auto files = writeFiles(*answered, options);
    if (!files) return fail(console, files.error(), exitFailed);
    if (options.json)
        printFile(options.out, "study.json", console.out);
    else
        printStudy(answered->study, *files, console.out);
    return exitOk;
}

}  // namespace

void addStudyCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<StudyOptions>();
    const auto layout = std::make_shared<SheetOptions>();
    CLI::App* command =
        app.add_subcommand("study", "Measure the shadow over a region and write maps, figures and a report");
    addStudyOptions(*command, *options, ReceiverChoice::cellsAndPoints);
    addElementOptions(*command, *options);
    addElevationSheetOptions(*command, *layout);
    addSheetSwitch(*command, *layout);
    addPieceOptions(*command, *options);
    addLegendOptions(*command, options->legend);
    command->footer(
        "A first study:\n"
        "  noonmark-cli study sample:central-park-south --start 2026-03-21 --from 09:00 --hours 6 \\\n"
        "    --zone America/New_York --region -73.9845,40.7620,-73.9690,40.7735 --cell 2 --out out\n"
        "Sunlight of every window of a file, as elements.csv and elements.gpkg:\n"
        "  noonmark-cli study city.gpkg --start 2026-01-01 --days 365 --window sunrise..sunset --zone "
        "Europe/Amsterdam \\\n"
        "    --region city --receivers windows --windows windows.gpkg --out out\n"
        "Steps with the sun below the horizon are left out; shares of time refer to the time with the sun "
        "above it.");
    command->callback([options, layout, &run] {
        run = [options, layout](const Console& console) {
            return runStudyCommand(*options, *layout, console);
        };
    });
}

}  // namespace noonmark::cli
