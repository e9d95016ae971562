#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/cli/base/interrupt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/study/study_request.h"
#include "app/cli/tiles/tile_question.h"
#include "app/cli/tiles/tiles_command.h"
#include "app/input/all_engines.h"
#include "app/input/load_city.h"
#include "app/report/files/output_folder.h"
#include "core/base/safe_text.h"
#include "core/describe/command_options.h"
#include "core/io/formats/format.h"
#include "core/study/tile_tasks/plan/make_task_plan.h"

namespace noonmark::cli {

namespace {

namespace fs = std::filesystem;

struct PlanOptions {
    TileStudyOptions question;
    int tileCells = TiledStudySettings::defaultTileCells;
    double taskSeconds = TaskSize{}.seconds;
    double taskMemoryGB = TaskSize{}.memoryBytes / 1e9;
    double districtKm = 40;
    bool builtUpOnly = false;
};

std::string absolutePath(const fs::path& file) { return fs::absolute(file).lexically_normal().string(); }

// A city model by its ending; whether XML or an archive is one, its beginning tells: metadata are XML too.
bool isTile(const fs::path& file) {
    const Format* format = findByEnding(file, FileKind::cityJson);
    if (format == nullptr || format->json != JsonKind::other) return format != nullptr;
    const Format* found = findReadFormat(readFileHead(file));
    return found != nullptr && found->reader.kind == FileKind::cityJson;
}

// The 3D city models of a folder, in the order of their names, so that a plan made twice is the same. A
// folder without them may be a dataset of its own: of shapefiles, or a geodatabase.
Result<std::vector<std::string>> findFilesIn(const fs::path& folder) {
    std::vector<std::string> files;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
        if (entry.is_regular_file(error) && isTile(entry.path())) files.push_back(absolutePath(entry));
    if (error)
        return failure("The folder cannot be read: " + error.message(), folder.string(),
                       "Check its permissions");
    std::ranges::sort(files);
    if (files.empty()) files.push_back(absolutePath(folder));
    return files;
}

Result<std::vector<std::string>> findFiles(const ReadOptions& read) {
    std::vector<std::string> files;
    for (const std::string& file : read.files) {
        if (isSample(file))
            return failure("Tasks read files, not samples", file,
                           "Write it to a file: noonmark-cli sample, or project new");
        std::error_code error;
        auto some = fs::is_directory(file, error) ? findFilesIn(file)
                                                  : Result<std::vector<std::string>>({absolutePath(file)});
        if (!some) return tl::make_unexpected(some.error());
        files.insert(files.end(), some->begin(), some->end());
    }
    return files;
}

Result<std::vector<InputFile>> describeInputs(const std::vector<std::string>& files) {
    std::vector<InputFile> inputs;
    for (const std::string& file : files) {
        auto some = describeInputFiles(file);
        if (!some) return tl::make_unexpected(some.error());
        inputs.insert(inputs.end(), some->begin(), some->end());
    }
    return inputs;
}

// Tiles of an earlier plan stay where they belong to the same study: unchanged ones are not computed again.
void removeOtherTiles(const fs::path& folder, const TaskPlan& plan) {
    const auto before = readTaskPlan(folder);
    bool same = before && before->districts.size() == plan.districts.size();
    for (std::size_t i = 0; same && i < plan.districts.size(); ++i)
        same = before->studyHash(i) == plan.studyHash(i) &&
               before->districts[i].tiles.side == plan.districts[i].tiles.side;
    std::error_code ignored;
    if (!same) fs::remove_all(folder / "tasks", ignored);
}

Result<TaskPlan> makePlan(const PlanOptions& options, std::vector<std::string> arguments,
                          const Console& console) {
    const StudyOptions& study = options.question.study;
    const auto files = findFiles(study.read);
    if (!files) return tl::make_unexpected(files.error());
    const auto question = readQuestion(options.question);
    if (!question) return tl::make_unexpected(question.error());
    OutputRules rules = outputRules(listNamedFiles(study.read), {}, study.overwrite);
    addPlace(rules, study.region);
    addPlace(rules, options.question.placesFile());
    if (auto may = checkOutputs(study.out, {planFileName, indexFileName}, rules); !may)
        return tl::make_unexpected(may.error());
    const Interrupt interrupt;
    ProgressLine progress(console);
    const TaskPlanRequest request{.files = *files,
                                  .reading = study.read.settings,
                                  .settings = question->settings,
                                  .region = study.region,
                                  .tileCells = options.tileCells,
                                  .task = {options.taskSeconds, options.taskMemoryGB * 1e9},
                                  .districtM = options.districtKm * 1000,
                                  .builtUpOnly = options.builtUpOnly,
                                  .subject = question->subjectOrNull(),
                                  .timelines = question->timelinesOrNull(),
                                  .byPlace = question->byPlaceOrNull()};
    auto plan = makeTaskPlan(request, progress, interrupt.token(), enginesWith(request.settings.engine));
    if (!plan) return plan;
    plan->arguments = std::move(arguments);
    std::vector<std::string> read = *files;
    const std::string& places = options.question.placesFile();
    if (!places.empty() && std::ranges::find(read, places) == read.end()) read.push_back(places);
    for (const std::string& trees : study.read.settings.treeFiles) read.push_back(absolutePath(trees));
    auto inputs = describeInputs(read);
    if (!inputs) return tl::make_unexpected(inputs.error());
    plan->inputs = *std::move(inputs);
    const fs::path folder = study.out;
    return prepareFolder(folder)
        .and_then([&] {
            removeOtherTiles(folder, *plan);
            return writeTileIndex(folder / indexFileName, *plan);
        })
        .and_then([&] { return writeTaskPlan(folder, *plan); })
        .map([&] { return *std::move(plan); });
}

void print(const TaskPlan& plan, bool json, std::ostream& out) {
    double seconds = 0, haloM2 = 0, tileM2 = 0;
    const double memory = largestExtentBytes(plan);
    for (const PlannedTile& tile : plan.tiles) {
        seconds += tile.seconds;
        const glm::dvec2 reads = glm::dvec2(tile.reads.high) - glm::dvec2(tile.reads.low);
        const Grid grid = plan.districts[tile.district].tiles.tile(tile.number);
        haloM2 += reads.x * reads.y;
        tileM2 += double(grid.size()) * grid.cellAreaM2();
    }
    if (json) {
        out << nlohmann::ordered_json{{"districts", plan.districts.size()},
                                      {"tiles", plan.tiles.size()},
                                      {"tasks", plan.taskCount},
                                      {"by_window", plan.byExtent},
                                      {"estimated_seconds", seconds},
                                      {"largest_window_bytes", memory},
                                      {"tiles_m2", tileM2},
                                      {"halos_m2", haloM2}}
                   .dump(2)
            << '\n';
        return;
    }
    out << fmt::format("{} in {}, {}\n", countOf(plan.tiles.size(), "tile"), countOf(plan.taskCount, "task"),
                       countOf(plan.districts.size(), "district"));
    out << fmt::format("Estimated: {:.1f} h on two cores, {:.2f} GB for the largest window of a task\n",
                       seconds / 3600, memory / 1e9);
    out << fmt::format("A tile reads {:.1f} times its own area; {}\n", haloM2 / tileM2,
                       plan.byExtent ? "tasks read by window" : "every task reads all files whole");
    out << fmt::format("Run the tasks 0 to {}\n", plan.taskCount - 1);
}

}  // namespace

void addPlanTiles(CLI::App& tiles, Run& run) {
    const auto options = std::make_shared<PlanOptions>();
    CLI::App* command = tiles.add_subcommand("plan", "Plan the tiles and tasks of a study");
    addTileStudyOptions(*command, options->question);
    command->get_option(flags::out)->description("Folder for plan.json, tiles.gpkg and the tiles");
    command->add_option(flags::tile, options->tileCells, "Cells per side of a tile")
        ->capture_default_str()
        ->check(CLI::Range(TiledStudySettings::minTileCells, TiledStudySettings::maxTileCells))
        ->type_name("CELLS");
    command->add_option("--task-seconds", options->taskSeconds, "Pack tiles into tasks of about this length")
        ->capture_default_str()
        ->check(within(1.0, 86400.0))
        ->type_name("S");
    command
        ->add_option("--task-memory", options->taskMemoryGB,
                     "Read the tiles of a task in windows of at most this estimated memory")
        ->capture_default_str()
        ->check(within(0.1, 1000.0))
        ->type_name("GB");
    command
        ->add_option("--district", options->districtKm,
                     "Divide a wider region into districts of this side, each with its own origin and sun")
        ->capture_default_str()
        ->check(within(5.0, 120.0))
        ->type_name("KM");
    command->add_flag("--built-up", options->builtUpOnly, "Leave out tiles without a building");
    command->callback([options, command, &run] {
        auto words = listArguments(
            *command, {flags::out, flags::overwrite, flags::json, flags::tile, "--task-seconds",
                       "--task-memory", "--district", "--built-up", "--timelines", "--by-place"});
        const auto makeAbsolute = [&](const char* flag, std::string& file) {
            if (file.empty()) return;
            file = absolutePath(file);
            words.push_back(fmt::format("{}={}", flag, file));
        };
        makeAbsolute("--timelines", options->question.timelines);
        makeAbsolute("--by-place", options->question.byPlace);
        run = [options, words = std::move(words)](const Console& console) {
            const auto plan = makePlan(*options, words, console);
            if (!plan) return fail(console, plan.error(), exitUsage);
            print(*plan, options->question.study.json, console.out);
            return int(exitOk);
        };
    });
}

}  // namespace noonmark::cli
