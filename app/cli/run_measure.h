#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "app/cli/command.h"
#include "app/cli/open_project.h"
#include "app/cli/options/measure_options.h"
#include "scenarios/project/results/save_result.h"

namespace noonmark::cli {

/// The parts that differ between impact and score. addResult() (save_result.h) must accept an `Answer`.
template <class Answer>
struct Measure {
    std::function<Result<Answer>(const ProjectFile&)> answer;
    std::function<Result<void>(const Answer&, const Project&)> writeFiles;
    std::string (*json)(const Answer&);
    void (*print)(const Answer&, std::ostream&);
};

/// Opens the project, measures, writes the files, saves the result in the project if requested, and prints
/// it. Returns the exit code.
template <class Answer>
int runMeasure(const MeasureOptions& options, const Measure<Answer>& measure, const Console& console) {
    auto disk = openProject(options.file, console);
    if (!disk) return fail(console, disk.error(), exitUsage);
    const Result<Answer> answer =
        measure.answer(*disk);  // records the state of the file before --keep changes it
    if (!answer) return fail(console, answer.error(), exitUsage);
    const auto written = measure.writeFiles(*answer, disk->project());
    if (!written) return fail(console, written.error(), exitFailed);
    if (!options.keep.empty())
        if (const auto saved = disk->save(addResult(disk->project(), options.keep, *answer)); !saved)
            return fail(console, saved.error(), exitFailed);
    if (options.json)
        console.out << measure.json(*answer) << '\n';
    else
        measure.print(*answer, console.out);
    return exitOk;
}

}  // namespace noonmark::cli
