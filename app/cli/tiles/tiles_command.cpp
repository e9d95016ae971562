#include "app/cli/tiles/tiles_command.h"

#include <fmt/format.h>
#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <memory>
#include <ostream>

#include "app/cli/base/interrupt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/tiles/tile_question.h"
#include "app/input/all_engines.h"
#include "core/base/cgroup_limits.h"
#include "core/base/safe_text.h"
#include "core/study/tile_tasks/run_task.h"

namespace noonmark::cli {

void addTilesCommand(CLI::App& app, Run& run) {
    CLI::App* tiles =
        app.add_subcommand("tiles", "Divide a study into tiles for many machines, run and merge them");
    tiles->require_subcommand(1);
    tiles->footer(
        "A study on a cluster:\n"
        "  noonmark-cli tiles plan country.fgb --start 2026-01-01 --days 365 \\\n"
        "    --window sunrise+1.5h..sunset-1.5h --zone Europe/Berlin --region city --out plan\n"
        "  sbatch --array=0-99 --wrap 'noonmark-cli tiles run plan'\n"
        "  noonmark-cli tiles merge plan");
    addPlanTiles(*tiles, run);
    addRunTiles(*tiles, run);
    addTilesStatus(*tiles, run);
    addMergeTiles(*tiles, run);
}

std::optional<std::string> readEnvironment(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? std::nullopt : std::optional<std::string>(value);
}

Result<std::size_t> findArrayTask(const Environment& environment) {
    for (const char* name : {"SLURM_ARRAY_TASK_ID", "JOB_COMPLETION_INDEX", "AWS_BATCH_JOB_ARRAY_INDEX"}) {
        const auto text = environment(name);
        if (!text) continue;
        std::size_t task = 0;
        const auto [end, error] = std::from_chars(text->data(), text->data() + text->size(), task);
        if (error == std::errc() && end == text->data() + text->size()) return task;
        return failure("\"" + *text + "\" is not the number of a task", name,
                       "Give --task N, or run in an array of jobs that counts from 0");
    }
    return failure("No task is named", {},
                   "Give --task N, or run in an array of Slurm, Kubernetes or AWS Batch");
}

namespace {

struct RunOptions {
    std::string folder;
    std::optional<std::size_t> task;
    std::optional<std::size_t> threads;
};

Result<TaskReport> runOne(const RunOptions& options, const CgroupLimits& limits, const Console& console) {
    const auto task = options.task ? Result<std::size_t>(*options.task) : findArrayTask(readEnvironment);
    if (!task) return tl::make_unexpected(task.error());
    const auto plan = readTaskPlan(options.folder);
    if (!plan) return tl::make_unexpected(plan.error());
    const auto study = parseArguments(plan->arguments, plan->files);
    if (!study) return tl::make_unexpected(study.error());
    auto question = readQuestion(*study);
    if (!question) return tl::make_unexpected(question.error());
    StudySettings& settings = question->settings;
    constexpr std::uint64_t share = 9;  // tenths: the rest is for what is not estimated
    if (limits.memoryBytes) settings.memoryLimit = *limits.memoryBytes / 10 * share;
    const Interrupt interrupt;
    ProgressLine progress(console);
    const TaskQuestion asked{study->study.read.settings, settings, question->subjectOrNull(),
                             question->timelinesOrNull(), question->byPlaceOrNull()};
    return runTask(options.folder, *plan, *task, asked, progress, interrupt.token(),
                   enginesWith(settings.engine));
}

int runTiles(const RunOptions& options, const Console& console) {
    const CgroupLimits limits = readCgroupLimits();
    std::optional<ThreadLimit> threads;
    if (const auto count = options.threads ? options.threads : countThreads(limits)) threads.emplace(*count);
    const auto report = runOne(options, limits, console);
    if (!report) return fail(console, report.error(), isRetryable(report.error()) ? exitRetry : exitFailed);
    console.out << fmt::format("{}, {} computed; {} read in {:.1f} s, {:.1f} s in all\n",
                               countOf(report->tiles, "tile"), report->computed,
                               countOf(report->buildings, "building"), report->readSeconds, report->seconds);
    return exitOk;
}

}  // namespace

void addRunTiles(CLI::App& tiles, Run& run) {
    const auto options = std::make_shared<RunOptions>();
    CLI::App* command = tiles.add_subcommand("run", "Compute the tiles of one task that are missing");
    command->add_option("folder", options->folder, "Folder of the plan")->required()->type_name("DIR");
    command
        ->add_option("--task", options->task,
                     "Number of the task (default: SLURM_ARRAY_TASK_ID, JOB_COMPLETION_INDEX or "
                     "AWS_BATCH_JOB_ARRAY_INDEX)")
        ->type_name("N");
    command
        ->add_option("--threads", options->threads,
                     "Threads to compute with (default: the processors that the control group allows)")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    command->footer(
        "Exit codes: 0 done; 75 failed, may succeed when tried again (disk full, out of memory, another\n"
        "process works on the task); 130 stopped by a signal, try again; 1 and 2 failed for good.");
    command->callback(
        [options, &run] { run = [options](const Console& console) { return runTiles(*options, console); }; });
}

}  // namespace noonmark::cli
