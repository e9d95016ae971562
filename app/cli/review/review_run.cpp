#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <ostream>

#include "app/cli/interrupt.h"
#include "app/cli/offscreen_qt.h"
#include "app/cli/options/number_range.h"
#include "app/cli/options/overwrite_option.h"
#include "app/cli/options/sheet_options.h"
#include "app/cli/progress_line.h"
#include "app/cli/project/change_project.h"
#include "app/cli/project/project_question.h"
#include "app/cli/review/places_in_reach.h"
#include "app/cli/review/review_commands.h"
#include "app/cli/review/review_run_options.h"
#include "app/cli/table.h"
#include "app/report/files/review_files.h"
#include "core/base/progress_share.h"
#include "core/engines/auto_engine.h"
#include "core/review/places/review_columns.h"
#include "core/review/places/verdict_text.h"
#include "core/study/text/warnings_json.h"
#include "scenarios/project/project_provenance.h"
#include "scenarios/project/rule_parcels.h"

namespace noonmark::cli {

namespace {

struct ReviewAnswer {
    ReviewStudy study;
    ReviewLabels labels;
    City before, after;
    std::vector<Place> places;
    HeightFacts heights;
    BookSettings sheets;
    std::vector<Place> streets;
};

Result<std::vector<Place>> placesFor(const ReviewRunOptions& options, const Rule& rule,
                                     const Project& project) {
    if (options.places != std::vector<std::string>{"all"})
        return findPlacesUnder(rule, project, options.places);
    std::vector<Place> places = placesUnder(rule, project);
    if (!places.empty()) return places;
    if (rule.receivers.hasLines())
        return failure("The project has no lots", options.file,
                       "Add the parcels: noonmark-cli project lot add");
    return failure("The project has no places", options.file, "Add some: noonmark-cli project place --help");
}

Result<ReviewAnswer> computeReview(const ReviewRunOptions& options, const Rule& rule,
                                   const RuleLibrary& library, const ProjectFile& disk,
                                   const OutputRules& outputs, const Console& console) {
    const Project& project = disk.project();
    const auto drawn = placesFor(options, rule, project);
    if (!drawn) return tl::make_unexpected(drawn.error());
    auto taken = moveLines(rule, project, *drawn);
    if (!taken) return tl::make_unexpected(taken.error());
    const auto zone = zoneOf(options, project);
    if (!zone) return tl::make_unexpected(zone.error());
    const auto before = cityOf(project, options.from), after = cityOf(project, options.to);
    if (!before) return tl::make_unexpected(before.error());
    if (!after) return tl::make_unexpected(after.error());
    if (const auto may = checkOutputs(options.out, reviewFileNames(), outputs); !may)
        return tl::make_unexpected(may.error());
    const auto sheets = bookSettingsOf(options.sheets, project.sheets);
    if (!sheets) return tl::make_unexpected(sheets.error());
    const ReviewSettings settings{options.settings.cellM, *zone, yearOf(options, project), true, true};
    const Interrupt interrupt;
    ProgressLine progress(console);
    Result<std::vector<Place>> places = std::move(taken->places);
    if (options.inReach)
        places = choosePlacesInReach(rule, before->city, after->city, *places, settings, progress,
                                     interrupt.token());
    if (!places) return tl::make_unexpected(places.error());
    auto study = runReview(rule, before->city, after->city, *places, settings, AutoEngine(), progress,
                           interrupt.token());
    if (!study) return tl::make_unexpected(study.error());
    study->warnings.insert(study->warnings.end(), library.warnings().begin(), library.warnings().end());
    putBefore(study->warnings, taken->moved);
    putBefore(study->warnings, project.reading->warnings);
    ReviewLabels labels{options.from, options.to,
                        provenanceOf(project, &disk, {options.to, options.from, {}, {}}), options.places,
                        makeRepeatOptions(options.sheets, *sheets)};
    if (options.inReach) labels.sheets.push_back({"--in-reach", {}});
    return ReviewAnswer{*std::move(study), labels,
                        before->city,      after->city,
                        *places,           project.reading->heights,
                        *sheets,           placesOfKind(project, PlaceKind::street)};
}

/// The rule's own table as text; of many days those with incremental shadow.
void printTable(const ReviewStudy& study, std::ostream& out) {
    const auto& columns = study.rule.deliverables.columns;
    std::vector<std::vector<std::string>> lines(1);
    for (const RuleColumn& column : columns) lines[0].push_back(column.title);
    constexpr std::size_t mostRows = 40;
    std::size_t leftOut = 0;
    for (const PlaceReview& review : study.places)
        for (const ReviewRow& row : review.rows) {
            if (lines.size() > mostRows) {
                ++leftOut;
                continue;
            }
            auto& line = lines.emplace_back();
            for (const RuleColumn& column : columns) line.push_back(columnText(review, row, column.key));
        }
    for (const auto& line : lines) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
            std::size_t width = 0;
            for (const auto& other : lines) width = std::max(width, other[i].size());
            out << fmt::format("{:<{}}{}", line[i], i + 1 < columns.size() ? width : 0,
                               i + 1 < columns.size() ? "  " : "\n");
        }
    }
    if (leftOut > 0) out << fmt::format("({} more rows in review.csv)\n", leftOut);
}

void printReview(const ReviewAnswer& answer, std::ostream& out) {
    const ReviewStudy& study = answer.study;
    Table heading;
    heading.add("rule", fmt::format("{} ({})", study.rule.name, study.rule.key));
    heading.add("from, to", fmt::format("{} -> {}", answer.labels.from, answer.labels.to));
    heading.add("clock", fmt::format("{}, {}", study.clock, study.year));
    heading.add("engine", fmt::format("{}, every {:g} min, cells of {:g} m", study.engine, study.stepMinutes,
                                      study.settings.cellM));
    heading.print(out);
    out << '\n';
    printTable(study, out);
    out << '\n';
    for (const PlaceReview& review : study.places)
        out << fmt::format("{}: {}. {}\n", review.name, nameOf(review.verdict), describeReason(review));
    out << "\nNot checked:\n";
    for (const std::string& text : study.notChecked) out << fmt::format("  - {}\n", text);
    printWarnings(out, study.warnings);
}

Result<std::vector<std::filesystem::path>> writeFiles(const ReviewAnswer& answer,
                                                      const ReviewRunOptions& options,
                                                      const OutputRules& outputs, const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    ProgressShare forSheets(progress, 0, 2), forFiles(progress, 1, 2);
    const ReviewBookSource source{answer.study,  answer.labels,  answer.before, answer.after,
                                  answer.places, answer.heights, answer.streets};
    const auto sheets = makeReviewBook(source, answer.sheets, forSheets, interrupt.token());
    if (!sheets) return tl::make_unexpected(sheets.error());
    return writeReviewFiles(source, *sheets, {options.byteOrderMark, outputs}, options.out, forFiles,
                            interrupt.token());
}

/// A rule about windows needs windows, and one about places places.
Result<void> checkReceivers(const ReviewRunOptions& options, const Rule& rule) {
    const bool isOfWindows = rule.receivers.surface == RuleSurface::windows;
    if (options.windows.asked() && !options.places.empty())
        return failure("Places and windows are not reviewed together", "--places",
                       "Omit --places, or --windows and --facades-of");
    if (isOfWindows && !options.windows.asked())
        return failure("The rule is about windows", rule.key,
                       "Give --windows FILE or --facades-of NAMES|all");
    if (!isOfWindows && options.places.empty())
        return failure("The rule is about places", rule.key, "Give --places NAMES or --places all");
    if (isOfWindows && options.inReach)
        return failure("--in-reach is about places", "--in-reach", "Omit --in-reach");
    return {};
}

int runReviewRun(const ReviewRunOptions& options, const Console& console) {
    const OffscreenQt qt;
    const auto disk = ProjectFile::open(options.file);
    if (!disk) return fail(console, disk.error(), exitUsage);
    OutputRules outputs = outputRules({options.file}, disk->project().inputs, options.overwrite);
    const auto library = loadRules(options.rules);
    if (!library) return fail(console, library.error(), exitUsage);
    const auto rule = findRule(*library, options.rule, options.rules);
    if (!rule) return fail(console, rule.error(), exitUsage);
    if (const auto fits = checkReceivers(options, *rule); !fits)
        return fail(console, fits.error(), exitUsage);
    if (options.windows.asked()) return runWindowReviews(options, *rule, *library, *disk, outputs, console);
    const auto answer = computeReview(options, *rule, *library, *disk, outputs, console);
    if (!answer) return fail(console, answer.error(), exitUsage);
    const auto written = writeFiles(*answer, options, outputs, console);
    if (!written) return fail(console, written.error(), exitFailed);
    if (options.json)
        console.out << toJsonText(reviewJson(answer->study, answer->labels)) << '\n';
    else
        printReview(*answer, console.out);
    return exitOk;
}

void addQuestion(CLI::App& command, ReviewRunOptions& options) {
    addProjectFile(command, options.file);
    command.add_option("--rule", options.rule, "Key of the rule (`review list`)")
        ->required()
        ->type_name("KEY");
    command.add_option("--from", options.from, "The baseline: the scenario to compare with")
        ->default_val(existingCity)
        ->type_name("NAME");
    command.add_option("--to", options.to, "The scenario to review")->required()->type_name("NAME");
    command
        .add_option("--places", options.places,
                    "Places of the project by name, or all; of rules about parcels: its lots. Rules about "
                    "windows take --windows or --facades-of instead")
        ->type_name("all|NAME...");
    command.add_flag("--in-reach", options.inReach,
                     "Of these places, only those that the rule covers and that the shadow of the proposal "
                     "reaches in the rule's hours");
}

void addSettings(CLI::App& command, ReviewRunOptions& options) {
    command
        .add_option("--year", options.settings.year,
                    "Year of the days (default: that of the first period, or 2026)")
        ->check(within(1901, 2099))
        ->type_name("YEAR");
    command.add_option("--zone", options.settings.zone, "Time zone (default: that of the project's periods)")
        ->type_name("ZONE");
    command.add_option("--cell", options.settings.cellM, "Size of a cell, m")
        ->capture_default_str()
        ->check(within(ReceiverSettings::minCellM, ReceiverSettings::maxCellM))
        ->type_name("M");
    addReviewedWindows(command, options.windows);
    addRuleFolders(command, options.rules);
    addRuleChoices(command, options.rules);
    command
        .add_option(
            "--out", options.out,
            "Folder for review.json, review.csv, sheets.pdf, shadows.dxf and shadows.gpkg; of windows "
            "review.json, windows.csv, windows.gpkg and sheets.pdf")
        ->required()
        ->type_name("DIR");
    addSheetOptions(command, options.sheets);
    addDiagramScale(command, options.sheets);
    command.add_flag(
        "--bom", options.byteOrderMark,
        "review.csv or windows.csv begins with a byte order mark, by which Excel recognises UTF-8");
    addOverwriteOption(command, options.overwrite);
    command.add_flag("--json", options.json, "Print only JSON to standard output");
}

}  // namespace

Result<std::string> zoneOf(const ReviewRunOptions& options, const Project& project) {
    if (!options.settings.zone.empty())
        return Zone::named(options.settings.zone).map([](const Zone& zone) { return zone.name(); });
    if (auto zone = commonZone(project)) return *std::move(zone);
    return failure("The rule's hours need a time zone", "--zone",
                   "Give --zone, for example --zone America/New_York");
}

int yearOf(const ReviewRunOptions& options, const Project& project) {
    if (options.settings.year != 0) return options.settings.year;
    return project.periods.empty() ? 2026 : int(project.periods.front().period.start.year());
}

void addReviewRun(CLI::App& review, Run& run) {
    const auto options = std::make_shared<ReviewRunOptions>();
    CLI::App* command = review.add_subcommand("run", "Evaluate a rule on places or windows of a project");
    addQuestion(*command, *options);
    addSettings(*command, *options);
    command->footer(
        "noonmark-cli review run town.noonmark.gpkg --rule ceqr --from \"No action\" --to Proposal \\\n"
        "    --places all --zone America/New_York --out review\n"
        "noonmark-cli review run town.noonmark.gpkg --rule bre-209-windows --to Proposal \\\n"
        "    --facades-of \"Mill House\" --zone Europe/London --out review");
    command->callback([options, &run] {
        run = [options](const Console& console) { return runReviewRun(*options, console); };
    });
}

}  // namespace noonmark::cli
