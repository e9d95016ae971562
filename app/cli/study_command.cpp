#include <fmt/format.h>

#include <memory>
#include <ostream>

#include "app/cli/command.h"
#include "app/cli/interrupt.h"
#include "app/cli/offscreen_qt.h"
#include "app/cli/progress_line.h"
#include "app/cli/study_options.h"
#include "app/cli/table.h"
#include "app/input/load_city.h"
#include "app/report/output_folder.h"
#include "app/report/study_files.h"
#include "core/io/read_region.h"
#include "core/study/error_words.h"

namespace noonmark::cli {

namespace {

// An error with the code that it ends the program with.
struct Failure {
    Error error;
    ExitCode code = exitFailed;
};

template <class T>
tl::expected<T, Failure> orCode(Result<T> result, ExitCode code) {
    return std::move(result).map_error([code](Error error) { return Failure{std::move(error), code}; });
}

tl::expected<Study, Failure> computed(const StudyOptions& options, const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    StudySettings settings = options.settings;
    const auto period = orCode(periodFrom(options.period), exitUsage);
    if (!period) return tl::make_unexpected(period.error());
    settings.period = *period;
    if (auto engine = orCode(makeAccumulator(settings.engine, settings.engineSettings), exitUsage); !engine)
        return tl::make_unexpected(engine.error());
    auto loaded =
        orCode(loadCity(options.read.files, options.read.settings, progress, interrupt.token()), exitUsage);
    if (!loaded) return tl::make_unexpected(loaded.error());
    auto region = orCode(readRegion(options.region, loaded->read.city.frame), exitUsage);
    if (!region) return tl::make_unexpected(region.error());
    settings.region = *std::move(region);
    if (auto folder = orCode(prepareFolder(options.out), exitFailed); !folder)
        return tl::make_unexpected(folder.error());
    auto study = orCode(runStudy(loaded->read.city, settings, progress, interrupt.token()), exitFailed);
    if (study) addReading(*study, *loaded);
    return study;
}

Result<std::vector<std::filesystem::path>> writeFiles(const Study& study, const StudyOptions& options) {
    const OffscreenQt qt;
    return writeStudyFiles(study, options.out, {.cellsCsv = options.cellsCsv});
}

std::string secondsText(const Study& study) {
    std::string stages;
    for (const auto& [stage, seconds] : study.seconds)
        if (stage != "total")
            stages += fmt::format("{}{} {:.2f}", stages.empty() ? "" : ", ", stage, seconds);
    return fmt::format("{:.2f} s ({})", study.seconds.at("total"), stages);
}

void addCost(Table& table, const Study& study) {
    const Cost& cost = study.field.cost;
    table.add("buildings", fmt::format("{} of {} can reach a receiver", withCommas(cost.buildingsUsed),
                                       withCommas(study.city.buildings.size())));
    for (const auto& [reason, count] : cost.skipped)
        if (count > 0) table.add("skipped", fmt::format("{} {}", withCommas(count), reason));
    if (cost.rays > 0)
        table.add("rays",
                  fmt::format("{} ({:.1f} million/s)", withCommas(cost.rays),
                              double(cost.rays) * 1e-6 / std::max(1e-9, study.seconds.at("accumulate"))));
    table.add("time", secondsText(study));
}

void print(const Study& study, const std::vector<std::filesystem::path>& files, std::ostream& out) {
    const ShadowStatistics& figures = study.statistics;
    Table table;
    table.add("period", textOf(study.settings.period));
    table.add("engine", study.field.engine);
    table.add("steps", fmt::format("{} with the sun up, {} left out below the horizon",
                                   withCommas(study.sun.steps.size()), withCommas(study.sun.belowHorizon)));
    table.add("receivers", fmt::format("{} cells of {:g} m, {:.0f} m2", withCommas(figures.receivers),
                                       study.receivers.grid.cellM, figures.receiverAreaM2));
    table.add("shadow area",
              fmt::format("{:.1f} m2 (share of the sunlit time x area)", figures.shadowAreaM2));
    table.add("gross shadow",
              fmt::format("mean {:.1f}, most {:.1f} min a day of {:.1f} sunlit", figures.meanGrossMin,
                          figures.maxGrossMin, study.field.sunlitMinutesPerDay));
    table.add("continuous shadow", fmt::format("mean {:.1f}, longest {:.1f} min", figures.meanContinuousMin,
                                               figures.maxContinuousMin));
    for (const ErrorLine& line : errorLines(study)) table.add(line.name, line.value);
    addCost(table, study);
    table.print(out);
    out << "\nFiles\n";
    for (const auto& file : files) out << "  " << file.string() << '\n';
    printWarnings(out, study.warnings);
}

int runStudyCommand(const StudyOptions& options, const Console& console) {
    const auto study = computed(options, console);
    if (!study) return fail(console, study.error().error, study.error().code);
    const auto files = writeFiles(*study, options);
    if (!files) return fail(console, files.error(), exitFailed);
    if (options.json)
        console.out << studyJson(*study) << '\n';
    else
        print(*study, *files, console.out);
    return exitOk;
}

}  // namespace

void addStudyCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<StudyOptions>();
    CLI::App* command =
        app.add_subcommand("study", "Measure the shadow over a region and write maps, figures and a report");
    addStudyOptions(*command, *options);
    command->footer(
        "A first study:\n  noonmark-cli study sample:central-park-south --start 2026-03-21 --from 09:00 "
        "--hours 6 \\\n"
        "    --zone America/New_York --region -73.9845,40.7620,-73.9690,40.7735 --cell 2 --out out\n"
        "Steps with the sun below the horizon are left out; a share of time is of the time that the sun is "
        "up.");
    command->callback([options, &run] {
        run = [options](const Console& console) { return runStudyCommand(*options, console); };
    });
}

}  // namespace noonmark::cli
