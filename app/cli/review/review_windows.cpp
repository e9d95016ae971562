#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/progress_line.h"
#include "app/cli/base/table.h"
#include "app/cli/options/field_options.h"
#include "app/cli/options/number_range.h"
#include "app/cli/options/project_question.h"
#include "app/cli/options/study_options.h"
#include "app/cli/review/review_source.h"
#include "app/input/find_element_parts.h"
#include "app/report/book/review/review_book.h"
#include "app/report/files/window_files.h"
#include "core/review/places/verdict_text.h"
#include "core/study/elements/element_fields.h"
#include "core/study/remaining_time.h"
#include "core/study/text/warnings_json.h"
#include "scenarios/project/project_provenance.h"

namespace noonmark::cli {

namespace {

struct WindowAnswer {
    WindowStudy study;
    ReviewLabels labels;
    City baseline, scenario;
    HeightFacts heights;
    BookSettings sheets;
};

/// The rule with what the options change.
Result<Rule> withOptions(Rule rule, const ReviewedWindows& windows) {
    if (windows.wallM) {
        rule.receivers.windows.opening.wallM = *windows.wallM;
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

std::vector<CommandOption> repeatOptions(const ReviewRunOptions& options, const BookSettings& sheets) {
    const ReviewedWindows& windows = options.windows;
    std::vector<CommandOption> repeated = makeRepeatOptions(windows.elements);
    const auto add = [&](const char* name, std::vector<std::string> values) {
        repeated.push_back({name, std::move(values)});
    };
    add("--region", {windows.region});
    if (windows.wallM) add("--wall", {fmt::format("{}", *windows.wallM)});
    if (!windows.sunshine.empty()) add("--sunshine", {fmt::format("{}", fmt::join(windows.sunshine, ","))});
    if (windows.engine != "auto") add("--engine", {windows.engine});
    for (CommandOption& option : makeRepeatOptions(sheets)) repeated.push_back(std::move(option));
    return repeated;
}

/// What is measured, checked. The file of windows is described before it is read, so that its hash is that
/// of what was read.
struct WindowQuestion {
    Rule rule;
    ReviewGround ground;
    WindowReviewSettings settings;
    std::optional<InputFile> windowsFile;
};

Result<WindowQuestion> makeWindowQuestion(const ReviewRunOptions& options, const Rule& asked,
                                          const ReviewSource& source, const OutputRules& outputs) {
    auto rule = withOptions(asked, options.windows);
    if (!rule) return tl::make_unexpected(rule.error());
    auto ground = prepareGround(options, source, windowFileNames(), outputs);
    if (!ground) return tl::make_unexpected(ground.error());
    const auto region = regionIn(source.project, ground->after, options.windows.region);
    if (!region) return tl::make_unexpected(region.error());
    const auto elements = findElementParts(options.windows.elements, source.project, ground->after);
    if (!elements) return tl::make_unexpected(elements.error());
    using By = ShadedStepFinder::By;
    std::optional<By> by;
    if (options.windows.engine != "auto") by = options.windows.engine == "ray" ? By::rays : By::horizons;
    WindowReviewSettings settings{*elements, *region, ground->zone, ground->year, by};
    std::optional<InputFile> windowsFile;
    if (options.windows.ofFile) {
        auto file = describeInputFile(options.windows.elements.windows);
        if (!file) return tl::make_unexpected(file.error());
        windowsFile = *std::move(file);
    }
    return WindowQuestion{*std::move(rule), *std::move(ground), std::move(settings), std::move(windowsFile)};
}

std::string forecastText(const WindowForecast& forecast) {
    return fmt::format("{} windows, {} steps of the sun: {}", withCommas(forecast.windows),
                       withCommas(forecast.steps), describeDuration(forecast.seconds));
}

Result<WindowAnswer> computeWindows(const ReviewRunOptions& options, const Rule& asked,
                                    const RuleLibrary& library, const ReviewSource& source,
                                    const OutputRules& outputs, const Console& console) {
    auto question = makeWindowQuestion(options, asked, source, outputs);
    if (!question) return tl::make_unexpected(question.error());
    const ReviewGround& ground = question->ground;
    const Interrupt interrupt;
    ProgressLine progress(console);
    const auto announce = [&](const WindowForecast& forecast) {
        constexpr double worthTelling = 10;
        if (console.watched || forecast.seconds >= worthTelling)
            console.err << (console.watched ? "\r\x1b[K" : "") << forecastText(forecast) << std::endl;
    };
    auto study = runWindowReview(question->rule, ground.before, ground.after, question->settings, progress,
                                 interrupt.token(), announce);
    if (!study) return tl::make_unexpected(study.error());
    study->windowsFile = std::move(question->windowsFile);
    study->warnings.insert(study->warnings.end(), library.warnings().begin(), library.warnings().end());
    putBefore(study->warnings, source.project.reading->warnings);
    ReviewLabels labels{
        ground.from, ground.to, provenanceOf(source, ground), {}, repeatOptions(options, ground.sheets)};
    return WindowAnswer{
        *std::move(study), std::move(labels), ground.before, ground.after, source.project.reading->heights,
        ground.sheets};
}

int estimateWindows(const ReviewRunOptions& options, const Rule& rule, const ReviewSource& source,
                    const OutputRules& outputs, const Console& console) {
    const auto question = makeWindowQuestion(options, rule, source, outputs);
    if (!question) return fail(console, question.error(), exitUsage);
    const Interrupt interrupt;
    NoProgress quiet;
    const auto forecast =
        forecastWindowReview(question->rule, question->ground.before, question->ground.after,
                             question->settings, quiet, interrupt.token());
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

void printWindows(const WindowAnswer& answer, const std::vector<std::filesystem::path>& files,
                  std::ostream& out) {
    const WindowStudy& study = answer.study;
    Table table;
    table.add("rule", fmt::format("{} ({})", study.rule.name, study.rule.key));
    table.add("from, to", fmt::format("{} -> {}", answer.labels.from, answer.labels.to));
    table.add("clock", fmt::format("{}, {}", study.clock.text(), study.year));
    table.add("engine", fmt::format("{}, {} steps of {:g} min", study.engine, withCommas(study.steps),
                                    study.stepMinutes));
    addChanges(table, "windows", study.windowChanges);
    addChanges(table, "buildings", study.buildingChanges);
    table.add("time", fmt::format("{:.2f} s", study.seconds.at("total")));
    table.print(out);
    constexpr std::size_t mostLines = 20;
    std::size_t listed = 0;
    for (const WindowReview* review : sortWorstFirst(study.windows)) {
        if (review->verdict != Verdict::fail && review->verdict != Verdict::borderline) break;
        if (++listed <= mostLines)
            out << fmt::format("{}{}: {}, {} before. {}\n", listed == 1 ? "\n" : "", review->window.id,
                               nameOf(review->verdict), nameOf(review->formerVerdict),
                               describeReason(study.rule, *review));
    }
    if (listed > mostLines)
        out << fmt::format("({} more windows that do not pass are in windows.csv)\n", listed - mostLines);
    out << "\nNot checked:\n";
    for (const std::string& text : study.notChecked) out << fmt::format("  - {}\n", text);
    out << "\nFiles\n";
    for (const auto& file : files) out << "  " << file.string() << '\n';
    printWarnings(out, study.warnings);
}

void addFacades(CLI::App& command, ReviewedWindows& windows) {
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

void addReviewedWindows(CLI::App& command, ReviewedWindows& windows) {
    addWindowFileOptions(command, windows.elements);
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

int runWindowReviews(const ReviewRunOptions& options, const Rule& rule, const RuleLibrary& library,
                     const ReviewSource& source, OutputRules outputs, const Console& console) {
    if (options.windows.ofFile) addPlace(outputs, options.windows.elements.windows.string());
    addPlace(outputs, options.windows.region);
    if (options.estimate) return estimateWindows(options, rule, source, outputs, console);
    const auto answer = computeWindows(options, rule, library, source, outputs, console);
    if (!answer) return fail(console, answer.error(), exitUsage);
    const Interrupt interrupt;
    ProgressLine progress(console);
    const auto files = writeWindowFiles(
        {answer->study, answer->labels, answer->baseline, answer->scenario, answer->heights}, answer->sheets,
        options.out, options.byteOrderMark, outputs, progress, interrupt.token());
    if (!files) return fail(console, files.error(), exitFailed);
    if (options.json)
        console.out << toJsonText(windowReviewJson(answer->study, answer->labels)) << '\n';
    else
        printWindows(*answer, *files, console.out);
    return exitOk;
}

}  // namespace noonmark::cli
