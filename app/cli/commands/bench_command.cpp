#include <fmt/format.h>

#include <memory>
#include <ostream>
#include <span>

#include "app/bench/bench_pages.h"
#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/shared_options.h"
#include "app/input/all_engines.h"
#include "app/input/load_city.h"
#include "app/report/files/output_folder.h"
#include "core/describe/command_options.h"
#include "core/lab/bench/contests/moments.h"
#include "core/lab/bench/horizon/horizon_bench.h"
#include "core/lab/bench/paper/paper_bench.h"
#include "core/lab/bench/points/point_bench.h"
#include "core/samples/sample_city.h"

namespace noonmark::cli {

namespace {

struct BenchOptions {
    std::string out;
    std::string city;
    std::string zone = "America/New_York";
    std::string date = "2026-03-21";
    double sideM = 800;
    std::uint32_t seed = 1;
    bool overwrite = false;
    bool quick = false;
    bool gate = false;
    bool json = false;
};

// As many buildings as the paper's Manhattan, with a million triangles.
constexpr GridSampleSettings largeGrid{.buildings = 43'000, .roundness = 7};

Result<City> cityOf(const BenchOptions& options, Progress& progress, const std::stop_token& stop) {
    if (options.city.empty()) return makeGridSample(largeGrid);
    return loadCity({options.city}, {}, progress, stop).map([](LoadedCity&& loaded) {
        return std::move(loaded.read.city);
    });
}

std::string cityName(const BenchOptions& options) {
    if (options.city.empty()) return "grid sample";
    return isSample(options.city) ? options.city : std::filesystem::path(options.city).filename().string();
}

Result<bench::BenchSite> siteOf(const BenchOptions& options, Progress& progress,
                                const std::stop_token& stop) {
    const auto zone = Zone::named(options.zone);
    if (!zone) return tl::make_unexpected(zone.error());
    const auto date = parseDate(options.date);
    if (!date) return tl::make_unexpected(date.error());
    return cityOf(options, progress, stop).map([&](City&& city) {
        return bench::BenchSite{std::move(city), cityName(options), zone->name(),
                                *date,           options.sideM,     options.seed};
    });
}

void print(const bench::BenchReport& report, const std::vector<std::filesystem::path>& files,
           std::ostream& out) {
    Table table;
    table.add("city", report.site);
    table.add("machine", report.machine);
    table.add("extent", report.extent);
    for (const bench::SummaryFigure& figure : report.summary)
        table.add(figure.key,
                  fmt::format("{} ({}: {})",
                              figure.value ? bench::formatThreeDigits(*figure.value) : "not measured",
                              report.reference, figure.paper));
    table.add("time", fmt::format("{:.0f} s", report.seconds));
    for (const bench::Finding& finding : report.findings)
        table.add("", fmt::format("{:.1f} s {}", finding.seconds, finding.title));
    table.print(out);
    out << "\nFiles\n";
    for (const auto& file : files) out << "  " << file.string() << '\n';
}

// Whether all figures reach their targets; else says which do not.
bool reachesTargets(const bench::BenchReport& report, std::ostream& out) {
    const auto missed = bench::listMissed(report);
    for (const bench::SummaryFigure& figure : missed)
        out << fmt::format("missed: {} is {}, not {}\n", figure.key,
                           figure.value ? bench::formatThreeDigits(*figure.value) : "not measured",
                           figure.paper);
    return missed.empty();
}

struct Bench {
    Result<bench::BenchReport> (*run)(const bench::BenchSite&, const bench::Extent&, const EngineList&,
                                      Progress&, const std::stop_token&);
    std::span<const char* const> keys;  // keys of its findings
};

int runBench(const Bench& bench, const BenchOptions& options, const Console& console) {
    const Interrupt interrupt;
    const OutputRules rules = outputRules({options.city}, {}, options.overwrite);
    if (const auto may = checkOutputs(options.out, benchFileNames(bench.keys), rules); !may)
        return fail(console, may.error(), exitUsage);
    if (const auto folder = prepareFolder(options.out); !folder)
        return fail(console, folder.error(), exitFailed);
    std::optional<ProgressLine> progress(console);
    const auto site = siteOf(options, *progress, interrupt.token());
    if (!site) return fail(console, site.error(), exitUsage);
    const auto report = bench.run(*site, options.quick ? bench::makeQuickExtent() : bench::makeFullExtent(),
                                  allEngines(), *progress, interrupt.token());
    progress.reset();
    if (!report) return fail(console, report.error(), exitFailed);
    const OffscreenQt qt;
    const auto files = writeBenchFiles(*report, options.out, rules);
    if (!files) return fail(console, files.error(), exitFailed);
    if (options.json)
        console.out << summaryJson(*report);
    else
        print(*report, *files, console.out);
    return options.gate && !reachesTargets(*report, console.err) ? exitFailed : exitOk;
}

void addBenchOptions(CLI::App& command, BenchOptions& options) {
    command.add_option(flags::out, options.out, "Folder for the tables, the report and summary.json")
        ->required()
        ->type_name("DIR");
    addOverwriteOption(command, options.overwrite);
    command
        .add_option("--city", options.city,
                    "City file or sample (default: the grid sample, 43,000 buildings)")
        ->type_name("FILE");
    command.add_option("--zone", options.zone, "Time zone, for example America/New_York")
        ->capture_default_str()
        ->type_name("ZONE");
    command
        .add_option("--date", options.date,
                    "Date of the experiments on a single day; the others use its year")
        ->capture_default_str()
        ->type_name("DATE");
    command.add_option("--side", options.sideM, "Side of the square regions that are measured, m")
        ->capture_default_str()
        ->check(CLI::Range(50, 2000))
        ->type_name("M");
    command.add_option("--seed", options.seed, "Random seed: another number gives other places and times")
        ->capture_default_str()
        ->type_name("S");
    command.add_flag("--quick", options.quick,
                     "Fewer places, days and settings: at most 5 minutes on two cores; the files state this");
    command.add_flag("--gate", options.gate,
                     "End with 1 where a ratio or an error is over a quarter worse than its target");
    addJsonFlag(command, options.json, "Print only summary.json to standard output");
}

void addBench(CLI::App& group, const char* name, const char* about, const Bench& bench, Run& run) {
    const auto options = std::make_shared<BenchOptions>();
    CLI::App* command = group.add_subcommand(name, about);
    addBenchOptions(*command, *options);
    command->callback([options, bench, &run] {
        run = [options, bench](const Console& console) { return runBench(bench, *options, console); };
    });
}

}  // namespace

void addBenchCommand(CLI::App& app, Run& run) {
    CLI::App* group = app.add_subcommand("bench", "Measure time and error of the engines on this machine");
    group->require_subcommand(1);
    addBench(*group, "paper",
             "The experiments of the paper on shadow accrual maps, with our values beside the paper's",
             {bench::runPaperBench, bench::paperBenchKeys}, run);
    addBench(
        *group, "horizon",
        "The horizon sweep over a year, projected shadows over a day, and edits, compared with their targets",
        {bench::runHorizonBench, bench::horizonBenchKeys}, run);
    addBench(*group, "points", "A year on 100,000 points of facades, and its error, compared with rays",
             {bench::runPointBench, bench::pointBenchKeys}, run);
}

}  // namespace noonmark::cli
