#include "app/cli/study/run_measure.h"

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/open_project.h"
#include "app/cli/base/progress_line.h"
#include "app/questions/review_question.h"
#include "scenarios/project/results/save_result.h"

namespace noonmark::cli {

namespace {

using SharedAnswer = std::shared_ptr<const Answer>;

Result<Asked> makeAsked(const MeasureOptions& options, const Measure& measure, const Project& project) {
    Asked asked{.scenario = measure.scenario, .baseline = measure.baseline};
    auto settings = settingsFrom(options, project);
    if (!settings) return tl::make_unexpected(settings.error());
    asked.settings = *std::move(settings);
    if (measure.complete)
        if (auto done = measure.complete(project, asked); !done) return tl::make_unexpected(done.error());
    if (!measure.baseline.empty()) {
        auto before = cityOf(project, measure.baseline);
        if (!before) return tl::make_unexpected(before.error());
        asked.before = std::make_shared<const City>(std::move(before->city));
    }
    auto city = cityOf(project, measure.scenario);
    if (!city) return tl::make_unexpected(city.error());
    asked.loaded.read.city = std::move(city->city);
    asked.loaded.read.warnings = project.reading->warnings;
    return asked;
}

// States what it is made from before --save changes the file.
Result<Asked> ask(const MeasureOptions& options, const SheetOptions& sheets, const Measure& measure,
                  const ProjectFile& disk) {
    auto asked = makeAsked(options, measure, disk.project());
    if (!asked) return asked;
    asked->provenance = provenanceOf(
        disk.project(), &disk, {asked->scenario, asked->baseline, asked->settings.region, asked->weights});
    const auto may = checkOutputs(options.out, measure.fileNames(asked->provenance, sheets.wanted),
                                  outputRulesOf(options, disk.project()));
    if (!may) return tl::make_unexpected(may.error());
    if (options.withProject)
        if (const auto free = checkCopy(disk, options.out); !free) return tl::make_unexpected(free.error());
    return asked;
}

Result<SharedAnswer> compute(const Question& question, const Asked& asked, const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    return question.compute(asked, progress, interrupt.token());
}

Result<void> writeFiles(const Answer& answer, const City& city, const MeasureOptions& options,
                        const SheetOptions& sheets, const Measure& measure, const ProjectFile& disk) {
    const OffscreenQt qt;
    const Project& project = disk.project();
    const auto book = bookSettingsOf(sheets, project.sheets);
    if (!book) return tl::make_unexpected(book.error());
    const AnswerFiles how{.scale = measure.scale ? measure.scale(project) : ChangeScale(),
                          .legend = options.legend,
                          .pictureWidth = options.pictureWidth,
                          .sheets = sheets.wanted,
                          .book = *book,
                          .rules = outputRulesOf(options, project)};
    return answer.write(city, options.out, how).and_then([&](const auto&) -> Result<void> {
        return options.withProject ? copyProject(disk, options.out) : Result<void>();
    });
}

Result<void> save(const Answer& answer, const std::string& name, ProjectFile& disk) {
    SavedResult result = answer.toSave(disk.project());
    result.name = name;
    return disk.save(addResult(disk.project(), std::move(result)));
}

}  // namespace

int runMeasure(const MeasureOptions& options, const SheetOptions& sheets, const Measure& measure,
               const Console& console) {
    auto disk = openProject(options.file, console);
    if (!disk) return fail(console, disk.error(), exitUsage);
    const auto asked = ask(options, sheets, measure, *disk);
    if (!asked) return fail(console, asked.error(), exitUsage);
    const auto answer = compute(measure.question, *asked, console);
    if (!answer) return fail(console, answer.error(), exitUsage);
    const auto written = writeFiles(**answer, asked->loaded.read.city, options, sheets, measure, *disk);
    if (!written) return fail(console, written.error(), exitFailed);
    if (!options.keep.empty())
        if (const auto saved = save(**answer, options.keep, *disk); !saved)
            return fail(console, saved.error(), exitFailed);
    if (options.json)
        console.out << (*answer)->json() << '\n';
    else
        measure.print(**answer, console.out);
    return exitOk;
}

}  // namespace noonmark::cli
