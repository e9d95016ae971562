#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/field_options.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/options/sheet_options.h"
#include "app/cli/review/review_command.h"
#include "app/cli/review/review_source.h"
#include "app/report/files/answer_files.h"
#include "core/base/safe_text.h"
#include "core/describe/command_options.h"
#include "core/engines/auto_engine.h"
#include "core/review/places/review_columns.h"
#include "core/review/places/verdict_text.h"
#include "core/study/study_cost.h"
#include "core/study/text/error_text.h"
#include "scenarios/project/rule_parcels.h"

namespace noonmark::cli {

namespace {

Result<std::vector<Place>> placesFor(const ReviewRunOptions& options, const Rule& rule,
                                     const Project& project) {
    if (options.places != std::vector<std::string>{"all"})
        return findPlacesUnder(rule, project, options.places);
    std::vector<Place> places = placesUnder(rule, project);
    if (!places.empty()) return places;
    if (rule.receivers.hasLines())
        return failure("The project has no lots", options.read.files.front(),
                       "Add the parcels: noonmark-cli project lot add");
    return failure("The project has no places", options.read.files.front(),
                   "Add some: noonmark-cli project place --help");
}

/// What is measured, checked, and how its sheets are laid out.
struct PlaceQuestion {
    ReviewQuestion asked;
    BookSettings sheets;
};

Result<PlaceQuestion> makePlaceQuestion(const ReviewRunOptions& options, const Rule& rule,
                                        const ReviewSource& source) {
    const auto drawn = placesFor(options, rule, source.project);
    if (!drawn) return tl::make_unexpected(drawn.error());
    auto taken = moveLines(rule, source.project, *drawn);
    if (!taken) return tl::make_unexpected(taken.error());
    auto ground = prepareGround(options, source, reviewFileNames());
    if (!ground) return tl::make_unexpected(ground.error());
    if (options.withProject && source.file && !options.estimate)
        if (const auto may = checkCopy(*source.file, options.out); !may)
            return tl::make_unexpected(may.error());
    const ReviewSettings settings{options.settings.cellM, ground->zone, ground->year, true, true};
    ReviewQuestion asked{
        std::move(ground->cities), rule,           std::move(taken->places),         settings,
        std::move(taken->moved),   options.places, makeRepeatOptions(options.sheets)};
    return PlaceQuestion{std::move(asked), std::move(ground->sheets)};
}

Result<void> keepPlacesInReach(ReviewQuestion& question, const Console& console,
                               const std::stop_token& stop) {
    ProgressLine progress(console);
    return findPlacesInReach(question, progress, stop).and_then([&](const PlacesInReach& found) {
        return keepPlacesInReach(question, found);
    });
}

Result<double> estimateSeconds(const ReviewQuestion& asked, const std::stop_token& stop) {
    return estimateReviewSeconds(asked.rule, *asked.before, *asked.after, asked.places, asked.settings, stop);
}

/// "202 places: about 2 min"
std::string describeCost(const ReviewQuestion& asked, double seconds) {
    return fmt::format("{}: {}", countOf(asked.places.size(), "place"), describeDuration(seconds));
}

/// What takes long is announced.
void announce(const ReviewQuestion& asked, const Console& console, const std::stop_token& stop) {
    constexpr double longS = 10;
    if (const auto seconds = estimateSeconds(asked, stop); seconds && *seconds >= longS)
        console.err << describeCost(asked, *seconds) << std::endl;
}

Result<std::shared_ptr<const Answer>> measurePlaces(const ReviewRunOptions& options, ReviewQuestion question,
                                                    const ReviewSource& source, const Console& console) {
    const Interrupt interrupt;
    if (options.inReach)
        if (const auto kept = keepPlacesInReach(question, console, interrupt.token()); !kept)
            return tl::make_unexpected(kept.error());
    announce(question, console, interrupt.token());
    ProgressLine progress(console);
    const Asked asked{.review = std::make_shared<const ReviewQuestion>(std::move(question)),
                      .reviewSource = std::make_shared<const ReviewSource>(source)};
    return reviewQuestion().compute(asked, progress, interrupt.token());
}

int estimatePlaces(const ReviewRunOptions& options, ReviewQuestion asked, const Console& console) {
    const Interrupt interrupt;
    if (options.inReach)
        if (const auto kept = keepPlacesInReach(asked, console, interrupt.token()); !kept)
            return fail(console, kept.error(), exitUsage);
    const auto seconds = estimateSeconds(asked, interrupt.token());
    if (!seconds) return fail(console, seconds.error(), exitUsage);
    if (options.json)
        console.out << toJsonText({{"places", asked.places.size()}, {"estimated_seconds", *seconds}}) << '\n';
    else
        console.out << describeCost(asked, *seconds) << '\n';
    return exitOk;
}

/// The rule's own table as text; of many days those with incremental shadow.
void printTable(const ReviewStudy& study, std::ostream& out) {
    const auto& columns = study.rule.deliverables.columns;
    std::vector<std::vector<std::string>> lines(1);
    for (const RuleColumn& column : columns) lines[0].push_back(column.title);
    constexpr std::size_t maxRows = 40;
    std::size_t leftOut = 0;
    for (const PlaceReview& review : study.places)
        for (const ReviewRow& row : review.rows) {
            if (lines.size() > maxRows) {
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
    if (leftOut > 0) out << fmt::format("({} in review.csv)\n", countOf(leftOut, "more row"));
}

/// "Park: shadow existing 55.29 %, with the proposal 60.05 %, incremental 5.71 % of 11,512,774 m2 h of
/// theoretical sun; most incremental shadow on 2026-12-14 (1,204 m2 h)"
std::string describeSums(const PlaceReview& review) {
    const ReviewTotals& sums = review.totals;
    const auto share = [&](double m2h) {
        return fmt::format("{:.2f} %", sums.theoreticalM2h > 0 ? 100 * m2h / sums.theoreticalM2h : 0.0);
    };
    std::string text =
        fmt::format("{}: shadow existing {}, with the proposal {}, incremental {} of {} of theoretical sun",
                    review.name, share(sums.baselineM2h), share(sums.scenarioM2h), share(sums.incrementalM2h),
                    formatAreaHours(sums.theoreticalM2h, UnitSystem::metric));
    if (sums.largestDay && sums.incrementalM2h > 0)
        text += fmt::format("; most incremental shadow on {} ({})", formatText(*sums.largestDay),
                            formatAreaHours(sums.largestDayM2h, UnitSystem::metric));
    return text;
}

/// Of rules about a range of days.
void printSums(const ReviewStudy& study, std::ostream& out) {
    if (!study.rule.days.fixed.empty()) return;
    out << fmt::format("Sums over the {:g} days of the rule:\n",
                       study.places.empty() ? 0.0 : study.places.front().totals.days);
    for (const PlaceReview& review : study.places) out << "  " << describeSums(review) << '\n';
    out << '\n';
}

void printReview(const ReviewAnswer& answer, const ReviewSource& source, std::ostream& out) {
    const ReviewStudy& study = answer.study;
    Table heading;
    heading.add("rule", fmt::format("{} ({})", study.rule.name, study.rule.key));
    heading.add("from, to", fmt::format("{} -> {}", answer.question.from, answer.question.to));
    heading.add("clock", fmt::format("{}, {}", study.clock, study.year));
    heading.add("engine", fmt::format("{}, every {:g} min, cells of {:g} m", study.engine, study.stepMinutes,
                                      study.settings.cellM));
    heading.add("shade", study.trees);
    heading.print(out);
    out << '\n';
    printTable(study, out);
    out << '\n';
    printSums(study, out);
    for (const PlaceReview& review : study.places)
        out << fmt::format("{}: {}. {}\n", review.name, nameVerdict(review), describeReason(review));
    out << "\nNot checked:\n";
    for (const std::string& text : study.notChecked) out << fmt::format("  - {}\n", text);
    printWarnings(out, statedWarnings(answer, source));
}

/// A rule about windows needs windows, and one about places places; files need a folder.
Result<void> checkOptions(const ReviewRunOptions& options, const Rule& rule) {
    const bool isOfGlazing = rule.receivers.surface == RuleSurface::windows;
    if (options.windows.asked() && !options.places.empty())
        return failure("Places and windows are not reviewed together", flags::places,
                       "Omit --places, or --windows and --facades-of");
    if (isOfGlazing && !options.windows.asked())
        return failure("The rule is about windows", rule.key,
                       "Give --windows FILE or --facades-of NAMES|all");
    if (!isOfGlazing && options.places.empty())
        return failure("The rule is about places", rule.key, "Give --places NAMES or --places all");
    if (isOfGlazing && options.inReach)
        return failure("--in-reach is about places", "--in-reach", "Omit --in-reach");
    if (options.out.empty() && !options.estimate)
        return failure("The files need a folder", flags::out, "Give --out DIR");
    return {};
}

int reviewPlaces(const ReviewRunOptions& options, const Rule& rule, const ReviewSource& source,
                 const Console& console) {
    auto question = makePlaceQuestion(options, rule, source);
    if (!question) return fail(console, question.error(), exitUsage);
    if (options.estimate) return estimatePlaces(options, question->asked, console);
    const auto answer = measurePlaces(options, std::move(question->asked), source, console);
    if (!answer) return fail(console, answer.error(), exitUsage);
    if (const auto written = writeAnswer(**answer, options, question->sheets, source, console); !written)
        return fail(console, written.error(), exitFailed);
    if (options.withProject && source.file)
        if (const auto copied = copyProject(*source.file, options.out); !copied)
            return fail(console, copied.error(), exitFailed);
    if (options.json)
        printReviewJson(options.out, console.out);
    else
        printReview(*(*answer)->as<ReviewAnswer>(), source, console.out);
    return exitOk;
}

int runReviewRun(const ReviewRunOptions& options, const Console& console) {
    const OffscreenQt qt;
    const auto library = loadRules(options.rules);
    if (!library) return fail(console, library.error(), exitUsage);
    const auto rule = findRule(*library, options.rule, options.rules);
    if (!rule) return fail(console, rule.error(), exitUsage);
    if (const auto fits = checkOptions(options, *rule); !fits) return fail(console, fits.error(), exitUsage);
    const auto source = openReviewSource(options, *library, console);
    if (!source) return fail(console, source.error(), exitUsage);
    return options.windows.asked() ? runGlazingReviews(options, *rule, *source, console)
                                   : reviewPlaces(options, *rule, *source, console);
}

void addQuestion(CLI::App& command, ReviewRunOptions& options) {
    options.read.filesHelp = "The project; of rules about windows also city files, as of `study`";
    addReadOptions(command, options.read);
    command.add_option(flags::rule, options.rule, "Key of the rule (`review list`)")
        ->required()
        ->type_name("KEY");
    command.add_option(flags::from, options.from, "The baseline: the scenario to compare with")
        ->default_str(existingCity)
        ->type_name("NAME");
    command
        .add_option(flags::to, options.to,
                    "The scenario to review (default: the existing city, as it stands). City files have the "
                    "existing city alone")
        ->type_name("NAME");
    command
        .add_option(flags::places, options.places,
                    "Places of the project by name, or all; of rules about parcels: its lots. Rules about "
                    "windows take --windows or --facades-of instead")
        ->type_name("all|NAME...");
    command.add_flag("--in-reach", options.inReach,
                     "Of these places, only those that the rule covers and that the shadow of the proposal "
                     "reaches in the rule's hours");
}

void addSettings(CLI::App& command, ReviewRunOptions& options) {
    addFieldOptions(command, reviewFields().of(options.settings));
    addGlazingRunOptions(command, options.windows);
    addRuleFolders(command, options.rules);
    addRuleChoices(command, options.rules);
    command
        .add_option(
            flags::out, options.out,
            "Folder for review.json, review.csv, sheets.pdf, shadows.dxf and shadows.gpkg; of windows "
            "review.json, windows.csv, windows.gpkg and sheets.pdf. Required, except with --estimate")
        ->type_name("DIR");
    addSheetOptions(command, options.sheets);
    addLegendOptions(command, options.sheets.layout.legend);
    addDiagramScale(command, options.sheets);
    addBookExtent(command, options.sheets);
    command.add_flag(
        "--bom", options.byteOrderMark,
        "review.csv or windows.csv begins with a byte order mark, by which Excel recognises UTF-8");
    addOverwriteOption(command, options.overwrite);
    addProjectCopyOption(command, options.withProject);
    command.add_flag("--estimate", options.estimate,
                     "Only state how long the review will take, and write nothing");
    addJsonFlag(command, options.json);
}

}  // namespace

void addReviewRun(CLI::App& review, Run& run) {
    const auto options = std::make_shared<ReviewRunOptions>();
    CLI::App* command = review.add_subcommand(
        "run", "Evaluate a rule on places or windows of a project, or on windows of city files");
    addQuestion(*command, *options);
    addSettings(*command, *options);
    command->footer(
        "noonmark-cli review run town.noonmark.gpkg --rule ceqr --from \"No action\" --to Proposal \\\n"
        "    --places all --zone America/New_York --out review\n"
        "noonmark-cli review run town.noonmark.gpkg --rule bre-209-windows --to Proposal \\\n"
        "    --facades-of \"Mill House\" --zone Europe/London --out review\n"
        "noonmark-cli review run town.osm.pbf --rule en-17037 --facades-of all --zone Europe/Paris --out "
        "review");
    command->callback([options, &run] {
        run = [options](const Console& console) { return runReviewRun(*options, console); };
    });
}

}  // namespace noonmark::cli
