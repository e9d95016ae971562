#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/field_options.h"
#include "app/cli/options/project_options.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/options/study_options.h"
#include "app/cli/review/review_source.h"
#include "app/input/load_project.h"
#include "app/questions/glazing_question.h"
#include "app/report/files/element_files.h"
#include "core/base/safe_text.h"
#include "core/review/places/verdict_text.h"
#include "core/study/elements/element_fields.h"
#include "core/study/study_cost.h"
#include "core/study/text/error_text.h"

namespace noonmark::cli {

namespace {

/// The rule with what the options change.
Result<Rule> withOptions(Rule rule, const GlazingRunOptions& windows) {
    if (windows.wallM) {
        rule.receivers.glazing.opening.wallM = *windows.wallM;
        rule.readings.push_back(fmt::format("Walls of {:g} m, as given by the user", *windows.wallM));
    }
    if (windows.sunshine.empty()) return rule;
    if (std::ranges::none_of(rule.criteria,
                             [](const Criterion& c) { return c.measure == Measure::probableSun; }))
        return failure("The rule asks for no probable sunlight hours", "--sunshine", "Omit --sunshine");
    if (std::ranges::max(windows.sunshine) <= 0)
        return failure("The sun must shine in one month at least", "--sunshine");
    rule.sunshine.emplace();
    std::ranges::copy(windows.sunshine, rule.sunshine->byMonth.begin());
    rule.sunshine->evidence = {FigureStatus::unconfirmed, "Given by the user"};
    rule.readings.push_back("Hours of sun are weighted by the monthly probabilities that the user gave");
    return rule;
}

/// The options that windows and sheets do not restate by themselves.
std::vector<CommandOption> repeatOptions(const ReviewRunOptions& options) {
    const GlazingRunOptions& windows = options.windows;
    std::vector<CommandOption> repeated{{"--region", {windows.region}}};
    if (windows.wallM) repeated.push_back({"--wall", {fmt::format("{}", *windows.wallM)}});
    if (!windows.sunshine.empty())
        repeated.push_back({"--sunshine", {fmt::format("{}", fmt::join(windows.sunshine, ","))}});
    if (windows.engine != "auto") repeated.push_back({"--engine", {windows.engine}});
    for (CommandOption& option : makeRepeatOptions(options.sheets)) repeated.push_back(std::move(option));
    return repeated;
}

/// What is measured, checked, and how its sheets are laid out.
struct GlazingRequest {
    GlazingQuestion question;
    BookSettings sheets;
};

Result<GlazingRequest> makeGlazingQuestion(const ReviewRunOptions& options, const Rule& asked,
                                           const ReviewSource& source) {
    auto rule = withOptions(asked, options.windows);
    if (!rule) return tl::make_unexpected(rule.error());
    auto ground = prepareGround(options, source, glazingFileNames());
    if (!ground) return tl::make_unexpected(ground.error());
    const City& city = *ground->cities.after;
    auto region = regionIn(source.project, city, options.windows.region);
    if (!region) return tl::make_unexpected(region.error());
    auto elements = findElementParts(options.windows.elements, source.project, city);
    if (!elements) return tl::make_unexpected(elements.error());
    using By = ShadedStepFinder::By;
    std::optional<By> by;
    if (options.windows.engine != "auto") by = options.windows.engine == "ray" ? By::rays : By::horizons;
    return GlazingRequest{{std::move(ground->cities),
                           *std::move(rule),
                           {*std::move(elements), *std::move(region), ground->zone, ground->year, by},
                           repeatOptions(options)},
                          std::move(ground->sheets)};
}

std::string forecastText(const GlazingForecast& forecast) {
    return fmt::format("{}, {} of the sun: {}", countOf(forecast.windows, "window"),
                       countOf(forecast.steps, "step"), describeDuration(forecast.seconds));
}

Result<GlazingAnswer> measureGlazing(const GlazingQuestion& question, const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    const auto announce = [&](const GlazingForecast& forecast) {
        constexpr double worthReportingS = 10;
        if (console.watched || forecast.seconds >= worthReportingS)
            console.err << (console.watched ? "\r\x1b[K" : "") << forecastText(forecast) << std::endl;
    };
    return computeGlazingReview(question, progress, interrupt.token(), announce);
}

int estimateGlazing(const ReviewRunOptions& options, const GlazingQuestion& question,
                    const Console& console) {
    const Interrupt interrupt;
    NoProgress quiet;
    const auto forecast = forecastGlazingReview(question.rule, *question.before, *question.after,
                                                question.settings, quiet, interrupt.token());
    if (!forecast) return fail(console, forecast.error(), exitUsage);
    if (options.json)
        console.out << toJsonText({{"windows", forecast->windows},
                                   {"steps", forecast->steps},
                                   {"estimated_seconds", forecast->seconds}})
                    << '\n';
    else
        console.out << forecastText(*forecast) << '\n';
    return exitOk;
}

std::string countsText(const VerdictCounts& counts) {
    return fmt::format("{} pass, {} borderline, {} fail, {} not applicable", counts.pass, counts.borderline,
                       counts.fail, counts.notJudged());
}

void addChanges(Table& table, const std::string& what, const VerdictChanges& changes) {
    table.add(what + " before", countsText(changes.before));
    table.add(what + " after", countsText(changes.after));
    table.add(what + " changed", fmt::format("{} worse, {} better", changes.worse, changes.better));
}

void printGlazing(const GlazingAnswer& answer, const ReviewSource& source,
                  const std::vector<std::filesystem::path>& files, std::ostream& out) {
    const GlazingStudy& study = answer.study;
    Table table;
    table.add("rule", fmt::format("{} ({})", study.rule.name, study.rule.key));
    table.add("from, to", fmt::format("{} -> {}", answer.question.from, answer.question.to));
    table.add("clock", fmt::format("{}, {}", study.clock.text(), study.year));
    table.add("engine", fmt::format("{}, {} steps of {:g} min", study.engine, withCommas(study.steps),
                                    study.stepMinutes));
    table.add("shade", study.trees);
    addChanges(table, "windows", study.windowChanges);
    addChanges(table, "buildings", study.buildingChanges);
    table.add("time", fmt::format("{:.2f} s", study.seconds.at("total")));
    table.print(out);
    constexpr std::size_t maxLines = 20;
    std::size_t listed = 0;
    for (const GlazingReview* review : sortWorstFirst(study.windows)) {
        if (review->verdict != Verdict::fail && review->verdict != Verdict::borderline) break;
        if (++listed <= maxLines)
            out << fmt::format("{}{}: {}, {} before. {}\n", listed == 1 ? "\n" : "", review->window.id,
                               nameOf(review->verdict), nameOf(review->formerVerdict),
                               describeReason(study.rule, *review));
    }
    if (listed > maxLines)
        out << fmt::format("({} more windows that do not pass are in windows.csv)\n", listed - maxLines);
    out << "\nNot checked:\n";
    for (const std::string& text : study.notChecked) out << fmt::format("  - {}\n", text);
    out << "\nFiles\n";
    for (const auto& file : files) out << "  " << file.string() << '\n';
    printWarnings(out, statedWarnings(study.warnings, source));
}

void addFacades(CLI::App& command, GlazingRunOptions& windows) {
    addFieldOptions(command, facadesOfFields().of(windows.elements));
    command.get_option("--facades-of")
        ->description(
            "Rules about windows: a window in each bay and storey of these buildings, by name or id, of all "
            "of the region, or of those that the scenario builds or changes; may be repeated")
        ->each([&windows](const std::string&) {
            windows.onFacades = true;
            windows.elements.places = ElementPlaces::facades;
        });
    addFieldOptions(command, facadeFields().of(windows.elements));
}

}  // namespace

void addGlazingRunOptions(CLI::App& command, GlazingRunOptions& windows) {
    addGlazingFileOptions(command, windows.elements);
    command.get_option("--windows")->each([&windows](const std::string&) {
        windows.ofFile = true;
        windows.elements.places = ElementPlaces::windows;
    });
    addFacades(command, windows);
    command.get_option("--facades-of")->excludes("--windows");
    addFaceOptions(command, windows.elements.faces);
    command.get_option("--face")->excludes("--windows");
    command
        .add_option("--region", windows.region,
                    "Windows: only those in this region (a name of the project, a box, a polygon or a file)")
        ->capture_default_str()
        ->type_name("NAME|W,S,E,N|FILE|city");
    command.add_option("--wall", windows.wallM, "Windows: thickness of the walls, instead of the rule's")
        ->check(within(0.0, 3.0))
        ->type_name("M");
    command
        .add_option("--sunshine", windows.sunshine,
                    "Probable sunlight hours: how probable it is that the sun shines, 0 to 1, by month")
        ->delimiter(',')
        ->expected(12)
        ->check(within(0.0, 1.0))
        ->type_name("JAN,...,DEC");
    command
        .add_option(
            "--engine", windows.engine,
            "Windows: horizons whose ends rays correct, or rays at every step; auto traces few days and "
            "sweeps many")
        ->capture_default_str()
        ->check(CLI::IsMember({"auto", "horizon", "ray"}))
        ->type_name("ENGINE");
}

int runGlazingReviews(const ReviewRunOptions& options, const Rule& rule, const ReviewSource& source,
                      const Console& console) {
    const auto asked = makeGlazingQuestion(options, rule, source);
    if (!asked) return fail(console, asked.error(), exitUsage);
    if (options.estimate) return estimateGlazing(options, asked->question, console);
    auto measured = measureGlazing(asked->question, console);
    if (!measured) return fail(console, measured.error(), exitUsage);
    const auto glazing = std::make_shared<const GlazingAnswer>(*std::move(measured));
    const auto answer = makeAnswer(glazing, std::make_shared<const ReviewSource>(source));
    const auto written = writeAnswer(*answer, options, asked->sheets, source, console);
    if (!written) return fail(console, written.error(), exitFailed);
    if (options.json)
        printReviewJson(options.out, console.out);
    else
        printGlazing(*glazing, source, *written, console.out);
    return exitOk;
}

}  // namespace noonmark::cli
