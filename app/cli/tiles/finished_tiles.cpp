#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/project_options.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/options/sheet_options.h"
#include "app/cli/study/study_request.h"
#include "app/cli/tiles/tile_question.h"
#include "app/cli/tiles/tiles_command.h"
#include "app/input/load_city.h"
#include "app/questions/question.h"
#include "core/base/safe_text.h"
#include "core/describe/command_options.h"
#include "core/describe/figure_text.h"
#include "core/io/read_city.h"
#include "core/measures/shadow_figures.h"
#include "core/study/study_cost.h"
#include "core/study/tile_tasks/merge/merge_tiles.h"
#include "core/study/tile_tasks/plan/find_districts.h"
#include "core/study/tile_tasks/plan/make_task_plan.h"

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
    console.out << fmt::format(
        "{} of {} done, {} of {} complete\n", status->doneTiles, countOf(status->allTiles, "tile"),
        plan->taskCount - status->unfinishedTasks.size(), countOf(plan->taskCount, "task"));
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
    SheetOptions sheets;
    PlaceColours colours{.legend = {}};
    bool namesShown = false;  // --show is given; places are shown by their sun if not
};

// Where sheets draw its buildings the city is read whole, else only its ground counts.
Result<std::vector<City>> readGround(const MergeOptions& options, const TaskPlan& plan,
                                     const TileStudyOptions& study, const TileQuestionRead& question,
                                     Progress& progress, const std::stop_token& stop) {
    std::vector<City> cities;
    if (question.subject) {
        for (const auto& city : question.subject->cities) cities.push_back(*city);
        return cities;
    }
    const District& district = plan.districts.front();
    City ground{.frame = district.frame};
    if (!district.terrainHash.empty()) ground.terrain = std::make_shared<const Terrain>();
    if (options.sheets.wanted) {
        auto read = readCity(pathsOf(plan.files), readSettingsIn(district, study.study.read.settings),
                             progress, stop);
        if (!read) return tl::make_unexpected(read.error());
        ground = std::move(read->city);
    }
    cities.push_back(std::move(ground));
    return cities;
}

AnswerFiles filesOf(const MergeOptions& options, const TaskPlan& plan, const BookSettings& book) {
    AnswerFiles how;
    how.sheets = options.sheets.wanted;
    how.book = book;
    how.legend = options.colours.legend;
    if (!options.namesShown) how.legend.show = ShownAs::sun;
    how.thresholdHours = options.colours.thresholdHours;
    how.rules = outputRules(plan.files, plan.inputs, true);  // those of an earlier merge
    return how;
}

// How by-place chooses the same places; none where it has no words for it.
std::optional<PlaceSelection> findSameSelection(const TaskPlan& plan, const TileStudyOptions& study) {
    const bool ofCity = std::ranges::find(plan.files, study.byPlace) != plan.files.end();
    if (!ofCity || study.study.region != "city" || namesProject(study.study.read)) return std::nullopt;
    return PlaceSelection{listOptions(study.places)};
}

Result<MergeReport> mergeByPlace(const MergeOptions& options, const TaskPlan& plan,
                                 const TileStudyOptions& study, Progress& progress,
                                 const std::stop_token& stop) {
    const auto question = readQuestion(study);
    if (!question) return tl::make_unexpected(question.error());
    const auto book = bookSettingsOf(options.sheets, {});
    if (!book) return tl::make_unexpected(book.error());
    const auto cities = readGround(options, plan, study, *question, progress, stop);
    if (!cities) return tl::make_unexpected(cities.error());
    auto merged = mergeSunByPlace(options.folder, plan, *question->byPlace, question->settings, *cities,
                                  options.partial, progress, stop);
    if (!merged) return tl::make_unexpected(merged.error());
    merged->sun.baseline.provenance.inputs = plan.inputs;
    merged->sun.baseline.asked = findSameSelection(plan, study);
    const auto folder = makeMergedFolder(options.folder);
    if (!folder) return tl::make_unexpected(folder.error());
    MergeReport report{.places = merged->sun.baseline.places.size(),
                       .missingTiles = merged->missingTiles,
                       .warnings = merged->sun.baseline.warnings};
    const OffscreenQt qt;
    const auto answer = makeByPlaceAnswer(std::move(merged->sun), question->settings);
    auto files = answer->write(cities->back(), *folder, filesOf(options, plan, *book));
    if (!files) return tl::make_unexpected(files.error());
    report.files = *std::move(files);
    return report;
}

Result<MergeReport> merge(const MergeOptions& options, const Console& console) {
    const auto plan = readTaskPlan(options.folder);
    if (!plan) return tl::make_unexpected(plan.error());
    const auto study = parseArguments(plan->arguments, plan->files);
    if (!study) return tl::make_unexpected(study.error());
    const Interrupt interrupt;
    ProgressLine progress(console);
    if (!study->timelines.empty())
        return mergeTimelines(options.folder, *plan, options.partial, progress, interrupt.token());
    if (!study->byPlace.empty()) return mergeByPlace(options, *plan, *study, progress, interrupt.token());
    StudySettings asked = study->study.settings;
    const auto period = readPeriod(*study);
    if (!period) return tl::make_unexpected(period.error());
    asked.period = *period;
    Provenance provenance;
    provenance.inputs = plan->inputs;
    MergeSettings settings{.placeSettings = options.place.settings,
                           .partial = options.partial,
                           .provenance = provenance,
                           .maps = listMaps(*study, options.colours.legend),
                           .legend = options.colours.legend};
    if (!options.places.empty()) settings.places = options.places;
    return mergeTiles(options.folder, *plan, asked, settings, progress, interrupt.token());
}

// A score has no minutes of shadow.
void print(const MergeReport& report, std::ostream& out) {
    if (report.places > 0) {
        out << countOf(report.places, "place") << '\n';
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
        console.out << fmt::format("Missing: {}. Cells there have no value\n",
                                   countOf(report->missingTiles, "tile"));
    for (const auto& file : report->files) console.out << "Wrote " << file.string() << '\n';
    printWarnings(console.out, report->warnings);
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
        "merge",
        "Join the tiles: Cloud Optimized GeoTIFF, VRT, statistics by place, STAC item; sun by place as "
        "by-place writes it");
    command->add_option("folder", options->folder, "Folder of the plan; files go into its folder merged")
        ->required()
        ->type_name("DIR");
    command
        ->add_option(flags::places, options->places, "Polygon layer whose places get statistics (places.csv)")
        ->type_name("FILE");
    addPlaceOptions(*command, options->place);
    addLegendOptions(*command, options->colours.legend);
    command
        ->add_option(flags::threshold, options->colours.thresholdHours,
                     "Sun by place: hours of sun a day at which the map of the sheets and the style of "
                     "places.gpkg change their colour (default: --enough of the plan)")
        ->check(within(0, SunByPlaceSettings::maxHours))
        ->type_name("H");
    command->add_flag("--sheets", options->sheets.wanted,
                      "Sun by place: also write sheets.pdf, for which the whole city is read");
    addSheetOptions(*command, options->sheets);
    command->add_flag(flags::partial, options->partial, "Merge what is done, even if tiles are missing");
    command->callback([options, command, &run] {
        options->namesShown = command->count(std::string(flagOf(legendFields().rows(), "show"))) > 0;
        run = [options](const Console& console) { return runMerge(*options, console); };
    });
}

}  // namespace noonmark::cli
