#include "app/cli/study/element_run.h"

#include <fmt/format.h>

#include <fstream>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/progress_line.h"
#include "app/cli/base/table.h"
#include "app/cli/study/study_request.h"
#include "app/report/files/element_files.h"
#include "core/study/elements/element_tables.h"
#include "core/study/text/height_words.h"

namespace noonmark::cli {

namespace {

void addSource(ElementStudy& study, const StudyRequest& request) {
    const LoadedCity& loaded = request.loaded;
    study.provenance = provenanceOf(request);
    study.heights = loaded.read.heights;
    study.warnings.insert(study.warnings.begin(), loaded.read.warnings.begin(), loaded.read.warnings.end());
    study.seconds["read"] = loaded.seconds;
    study.seconds["total"] += loaded.seconds;
}

/// What was measured, and the book of it.
struct Measured {
    ElementStudy study;
    BookSettings book;
    std::shared_ptr<const ProjectFile> project;
};

// The file of windows is described before the computation, so that its hash is that of what was read.
tl::expected<Measured, Failure> measureElements(const StudyOptions& options, const SheetOptions& layout,
                                                const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    if (auto ok = orCode(checkElementOptions(options), exitUsage); !ok)
        return tl::make_unexpected(ok.error());
    std::optional<InputFile> windows;
    if (options.points == ElementPlaces::windows) {
        auto file = orCode(describeInputFile(options.elements.windows), exitUsage);
        if (!file) return tl::make_unexpected(file.error());
        windows = *std::move(file);
    }
    auto request = parseStudyRequest(options, elementFileNames(*options.points), progress, interrupt.token());
    if (!request) return tl::make_unexpected(request.error());
    auto book = orCode(bookSettingsOf(layout, sheetsOf(*request)), exitUsage);
    if (!book) return tl::make_unexpected(book.error());
    book->legend = options.legend;
    auto study = runElementStudy(request->loaded.read.city, request->settings, request->elements, progress,
                                 interrupt.token());
    if (!study)
        return tl::make_unexpected(
            Failure{study.error(), study.error().kind == ErrorKind::input ? exitUsage : exitFailed});
    study->glazingInput = windows;
    addSource(*study, *request);
    return Measured{*std::move(study), *std::move(book), request->project};
}

std::string errorText(const ElementStudy& study) {
    if (!study.error)
        return study.engineKey == referenceEngine ? "none: it is the reference" : "not measured";
    return describe(*study.error);
}

void printElements(const ElementStudy& study, const std::vector<std::filesystem::path>& files,
                   std::ostream& out) {
    const ElementFigures figures = computeFigures(study);
    Table table;
    if (const auto headline = makeDoubtHeadline(study.heights)) table.add("unit of heights", *headline);
    if (const auto headline = makeStandHeadline(study.heights)) table.add("bases", *headline);
    table.add("period", formatText(study.settings.period));
    table.add("engine", describeEngine(study));
    table.add("steps", fmt::format("{} with the sun up, {} left out below the horizon",
                                   withCommas(study.sun.steps.size()), withCommas(study.sun.belowHorizon)));
    table.add("receivers on", std::string(nameOf(study.elements.places)));
    addFigures(table, listLines(elementFigures().of(figures), {.sunlitMin = figures.possibleMin}));
    table.add("error against rays", errorText(study));
    table.add("time", fmt::format("{:.2f} s", study.seconds.at("total")));
    table.print(out);
    out << "\nFiles\n";
    for (const auto& file : files) out << "  " << file.string() << '\n';
    printWarnings(out, study.warnings);
}

}  // namespace

int runElements(const StudyOptions& options, const SheetOptions& layout, const Console& console) {
    const OffscreenQt qt;
    const auto measured = measureElements(options, layout, console);
    if (!measured) return fail(console, measured.error().error, measured.error().code);
    const ElementStudy& study = measured->study;
    const auto files = writeElementFiles(study, measured->book, options.out,
                                         outputRulesOf(options, study.provenance.inputs));
    if (!files) return fail(console, files.error(), exitFailed);
    if (const auto copied = copyProjectOf(measured->project, options); !copied)
        return fail(console, copied.error(), exitFailed);
    if (!options.json)
        printElements(study, *files, console.out);
    else if (std::ifstream file(std::filesystem::path(options.out) / "study.json"); file)
        console.out << file.rdbuf() << '\n';
    return exitOk;
}

}  // namespace noonmark::cli
