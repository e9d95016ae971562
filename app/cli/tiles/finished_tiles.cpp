#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/progress_line.h"
#include "app/cli/base/table.h"
#include "app/cli/options/place_options.h"
#include "app/cli/tiles/tile_question.h"
#include "app/cli/tiles/tiles_command.h"
#include "core/describe/command_flags.h"
#include "core/describe/figure_text.h"
#include "core/measures/shadow_figures.h"
#include "core/study/remaining_time.h"
#include "core/study/tile_tasks/merge/merge_timelines.h"

namespace noonmark::cli {

namespace {

struct StatusOptions {
    std::string folder;
    bool json = false;
};

int printStatus(const StatusOptions& options, const Console& console) {
    const auto plan = readTaskPlan(options.folder);
    if (!plan) return fail(console, plan.error(), exitUsage);
    const auto status = findStatus(options.folder, *plan);
    if (!status) return fail(console, status.error(), exitFailed);
    if (options.json) {
        console.out << statusJson(*plan, *status) << '\n';
        return exitOk;
    }
    console.out << fmt::format("{} of {} tiles done, {} of {} tasks complete\n", status->doneTiles,
                               status->allTiles, plan->taskCount - status->unfinishedTasks.size(),
                               plan->taskCount);
    if (!status->complete())
        console.out << fmt::format("Unfinished tasks: {}\n{:.2f} h of computing left\n",
                                   formatRanges(status->unfinishedTasks), status->leftSeconds / 3600);
    return exitOk;
}

struct MergeOptions {
    std::string folder;
    std::string places;
    PlaceOptions place;
    bool partial = false;
};

Result<MergeReport> merge(const MergeOptions& options, const Console& console) {
    const auto plan = readTaskPlan(options.folder);
    if (!plan) return tl::make_unexpected(plan.error());
    const auto study = parseArguments(plan->arguments, plan->files);
    if (!study) return tl::make_unexpected(study.error());
    const Interrupt interrupt;
    ProgressLine progress(console);
    if (!study->timelines.empty())
        return mergeTimelines(options.folder, *plan, options.partial, progress, interrupt.token());
    StudySettings asked = study->study.settings;
    const auto period = readPeriod(*study);
    if (!period) return tl::make_unexpected(period.error());
    asked.period = *period;
    Provenance provenance;
    provenance.inputs = plan->inputs;
    MergeSettings settings{.placeSettings = options.place.settings,
                           .partial = options.partial,
                           .provenance = provenance,
                           .maps = listMaps(*study)};
    if (!options.places.empty()) settings.places = options.places;
    return mergeTiles(options.folder, *plan, asked, settings, progress, interrupt.token());
}

// A score has no minutes of shadow.
void print(const MergeReport& report, std::ostream& out) {
    if (report.places > 0) {
        out << fmt::format("{} place{}\n", report.places, report.places == 1 ? "" : "s");
        return;
    }
    const ShadowStatistics& shadow = report.statistics;
    Table table;
    if (std::isnan(shadow.meanGrossMin))
        table.add("receivers", withCommas(shadow.receivers));
    else
        addFigures(table, listLines(shadowFigures().of(shadow)));
    table.print(out);
    for (const auto& [name, value] : report.figures) out << fmt::format("{} {:.0f}\n", name, value);
}

int runMerge(const MergeOptions& options, const Console& console) {
    const auto report = merge(options, console);
    if (!report) return fail(console, report.error(), exitFailed);
    print(*report, console.out);
    if (report->missingTiles > 0)
        console.out << fmt::format("{} tiles are missing: their cells have no value\n", report->missingTiles);
    for (const auto& file : report->files) console.out << "Wrote " << file.string() << '\n';
    return exitOk;
}

}  // namespace

void addTilesStatus(CLI::App& tiles, Run& run) {
    const auto options = std::make_shared<StatusOptions>();
    CLI::App* command = tiles.add_subcommand("status", "Report which tiles and tasks are done");
    command->add_option("folder", options->folder, "Folder of the plan")->required()->type_name("DIR");
    addJsonFlag(*command, options->json, "Print JSON");
    command->callback([options, &run] {
        run = [options](const Console& console) { return printStatus(*options, console); };
    });
}

void addMergeTiles(CLI::App& tiles, Run& run) {
    const auto options = std::make_shared<MergeOptions>();
    CLI::App* command = tiles.add_subcommand(
        "merge", "Join the tiles: Cloud Optimized GeoTIFF, VRT, statistics by place, STAC item");
    command->add_option("folder", options->folder, "Folder of the plan; files go into its folder merged")
        ->required()
        ->type_name("DIR");
    command
        ->add_option(flags::places, options->places, "Polygon layer whose places get statistics (places.csv)")
        ->type_name("FILE");
    addPlaceOptions(*command, options->place);
    command->add_flag(flags::partial, options->partial, "Merge what is done, even if tiles are missing");
    command->callback(
        [options, &run] { run = [options](const Console& console) { return runMerge(*options, console); }; });
}

}  // namespace noonmark::cli
