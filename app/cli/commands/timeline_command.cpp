#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/field_options.h"
#include "app/cli/options/project_options.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/options/study_options.h"
#include "core/base/safe_text.h"
#include "core/describe/command_options.h"
#include "core/engines/auto_engine.h"
#include "core/measures/places/place_sums.h"
#include "core/measures/shadow_figures.h"
#include "core/study/place_study.h"
#include "core/study/study_fields.h"
#include "core/study/text/error_text.h"
#include "scenarios/project/project_file.h"
#include "scenarios/project/project_provenance.h"

namespace noonmark::cli {

namespace {

using Json = nlohmann::ordered_json;

struct TimelineOptions {
    std::string file;
    std::vector<std::string> places;
    std::string from, to;
    std::string periodName;
    PeriodOptions period{.names = {{"--from", "--at"}, {"--start", "--day,--start"}}};
    PlaceStudySettings study;
    StudySettings shade;  // only its trees
    bool allSteps = false;
    bool json = false;
    bool csv = false;
};

struct TimelineAnswer {
    PlaceStudy study;
    TimelineLabels labels;
};

Result<std::vector<Place>> placesOf(const TimelineOptions& options, const Project& project) {
    if (options.places == std::vector<std::string>{"all"}) return project.places;
    std::vector<Place> places;
    for (const std::string& name : options.places) {
        auto place = findPlace(project, name);
        if (!place) return tl::make_unexpected(place.error());
        places.push_back(*std::move(place));
    }
    return places;
}

// Without hours: from sunrise to sunset.
Result<Period> periodOf(const TimelineOptions& options, const Project& project, bool hoursGiven) {
    PeriodOptions asked = options.period;
    if (!hoursGiven) asked.period.window = SolarHours{};
    if (const auto zone = commonZone(project); zone && !asked.states("--zone")) {
        asked.period.zone = *zone;
        asked.given.emplace("--zone");
    }
    return periodIn(project, options.periodName, asked);
}

Result<TimelineAnswer> computeTimelines(const TimelineOptions& options, bool hoursGiven,
                                        const Console& console) {
    const auto disk = ProjectFile::open(options.file);
    if (!disk) return tl::make_unexpected(disk.error());
    const Project& project = disk->project();
    const auto places = placesOf(options, project);
    if (!places) return tl::make_unexpected(places.error());
    const auto period = periodOf(options, project, hoursGiven);
    if (!period) return tl::make_unexpected(period.error());
    const auto zone = Zone::named(period->zone);
    if (!zone) return tl::make_unexpected(zone.error());
    const auto before = cityOf(project, options.from);
    if (!before) return tl::make_unexpected(before.error());
    const auto after = cityOf(project, options.to.empty() ? options.from : options.to);
    if (!after) return tl::make_unexpected(after.error());
    PlaceStudySettings settings = options.study;
    settings.period = *period;
    settings.trees = options.shade.trees;
    settings.allSteps = period->days == 1 || options.allSteps || options.csv;
    const Interrupt interrupt;
    ProgressLine progress(console);
    return runPlaceStudy(before->city, options.to.empty() ? nullptr : &after->city, *places, settings,
                         AutoEngine(), progress, interrupt.token())
        .map([&](PlaceStudy study) {
            prependWarnings(study.warnings, project.reading->warnings);
            return TimelineAnswer{std::move(study), {options.from, options.to, *zone}};
        });
}

std::string clockText(const std::optional<Instant>& at, const Zone& zone) {
    return at ? zone.text(std::chrono::round<std::chrono::seconds>(*at)).substr(11, 5) : std::string("-");
}

std::string lineOf(const ShadowOnPlace& shadow, const Zone& zone) {
    if (shadow.intervals.empty()) return "none";
    std::string text = fmt::format("{} to {}, {:.0f} min in {}; largest {:.0f} m2 at {}; {:.1f} m2 x h",
                                   clockText(shadow.enters(), zone), clockText(shadow.exits(), zone),
                                   shadow.minutes, countOf(shadow.intervals.size(), "interval"),
                                   shadow.largestM2, clockText(shadow.largestAt, zone), shadow.areaHoursM2);
    if (shadow.longest)
        text += fmt::format("; longest at one spot {:.0f} min from {}", shadow.longest->minutes,
                            clockText(shadow.longest->when.from, zone));
    return text;
}

/// A kind of shadow, or minutes, of a day in each column.
class DayTable {
public:
    DayTable(const PlaceTimeline& place, const Zone& zone) : place_(place), zone_(zone) {}

    void add(const std::string& name, ShadowOnPlace DayTimeline::*kind) {
        addColumns(name, [&](const DayTimeline& day) { return lineOf(day.*kind, zone_); });
    }
    void add(const std::string& name, double DayTimeline::*minutes) {
        addColumns(name, [&](const DayTimeline& day) { return fmt::format("{:.0f} min", day.*minutes); });
    }
    void addColumns(const std::string& name, const auto& textOf) {
        table_.add(name, textOf(place_.days.front()));
        for (const ShadedPlace& with : place_.withTrees)
            table_.add(fmt::format("{}, {}", name, describeTrees(with.column)), textOf(with.days.front()));
    }
    Table& table() { return table_; }

private:
    const PlaceTimeline& place_;
    const Zone& zone_;
    Table table_;
};

void printDay(const PlaceTimeline& place, const TimelineAnswer& answer, std::ostream& out) {
    const DayTimeline& day = place.days.front();
    const Zone& zone = answer.labels.zone;
    DayTable table(place, zone);
    std::string when = fmt::format("{}, {:.0f} min of sun; times of {}", formatText(day.day),
                                   day.sunlitMinutes, zone.name());
    if (day.stepMinutes > 1) when += fmt::format(", up to {:g} min too late", day.stepMinutes);
    table.table().add("day", when);
    table.add("baseline", &DayTimeline::baseline);
    if (!answer.labels.to.empty()) {
        table.add("scenario", &DayTimeline::scenario);
        table.add("incremental", &DayTimeline::incremental);
        table.add("gained", &DayTimeline::gained);
        table.add("all sun taken", &DayTimeline::allSunTakenMin);
    }
    table.add("wholly covered", &DayTimeline::fullCoverMin);
    table.table().print(out);
}

void printPeriod(const PlaceTimeline& place, std::ostream& out) {
    Table table;
    const PlaceSums& sums = place.sums;
    addFigures(table, listLines(areaHoursFigures().of(sums.all())));
    for (const ShadedPlace& with : place.withTrees)
        addFigures(table, listLines({areaHoursFiguresWithTrees(with.column), &with.sums.all()}));
    for (std::size_t i = 0; i < quarterNames.size(); ++i)
        if (sums.quarters()[i].days > 0)
            addFigures(table, quarterNames[i],
                       listLines(areaHoursFigures().of(sums.quarters()[i]), FigureUse::result));
    if (sums.maxIncrementalDay())
        table.add("day of most incremental",
                  fmt::format("{}, {:.1f} m2 x h", formatText(sums.maxIncrementalDay()->day),
                              sums.maxIncrementalDay()->areaHoursM2));
    table.print(out);
}

void print(const TimelineAnswer& answer, std::ostream& out) {
    for (const PlaceTimeline& place : answer.study.places) {
        out << fmt::format("{} ({}), {:.0f} m2 measured, {}{}\n", place.place.name, nameOf(place.place.kind),
                           place.days.empty() ? 0 : place.days.front().areaM2, answer.labels.from,
                           answer.labels.to.empty() ? "" : " -> " + answer.labels.to);
        if (place.days.size() == 1)
            printDay(place, answer, out);
        else
            printPeriod(place, out);
    }
    printWarnings(out, answer.study.warnings);
}

void printJson(const TimelineAnswer& answer, std::ostream& out) {
    const auto& places = answer.study.places;
    if (places.size() == 1) {
        out << toJsonText(timelineJson(answer.study, places.front(), answer.labels)) << '\n';
        return;
    }
    Json all = Json::array();
    for (const PlaceTimeline& place : places) all.push_back(timelineJson(answer.study, place, answer.labels));
    out << toJsonText({{"places", all}}) << '\n';
}

int runTimeline(const TimelineOptions& options, bool hoursGiven, const Console& console) {
    const auto answer = computeTimelines(options, hoursGiven, console);
    if (!answer) return fail(console, answer.error(), exitUsage);
    if (options.csv)
        console.out << timelineCsv(answer->study, answer->labels);
    else if (options.json)
        printJson(*answer, console.out);
    else
        print(*answer, console.out);
    return exitOk;
}

}  // namespace

void addTimelineCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<TimelineOptions>();
    CLI::App* command = app.add_subcommand(
        "timeline", "State when the shadow enters and leaves a place, and how much of it is covered");
    command->add_option("project", options->file, "The project")->required()->type_name("NAME.noonmark.gpkg");
    command->add_option("--place", options->places, "A place of the project by name, or all; may be repeated")
        ->allow_extra_args(false)
        ->required()
        ->type_name("NAME");
    command->add_option(flags::from, options->from, "The baseline: the scenario to compare with")
        ->default_val(existingCity)
        ->type_name("NAME");
    command->add_option(flags::to, options->to, "The scenario to measure (default: the baseline alone)")
        ->type_name("NAME");
    const std::vector<CLI::Option*> before = command->get_options();
    addPeriodOptions(*command, options->period);
    addNamedPeriod(*command, before, options->periodName);
    command->add_option("--cell", options->study.cellM, "Size of a cell, m")
        ->capture_default_str()
        ->check(within(ReceiverSettings::minCellM, ReceiverSettings::maxCellM))
        ->type_name("M");
    addFieldOptions(*command, treeFields().of(options->shade));
    command->add_flag("--all-steps", options->allSteps, "Of several days, state the steps of each too");
    CLI::Option* json = addJsonFlag(*command, options->json);
    command->add_flag("--csv", options->csv, "Print only CSV to standard output: one row for each step")
        ->excludes(json);
    command->footer(
        "The shadow of a proposal on a park, from sunrise to sunset:\n"
        "  noonmark-cli timeline town.noonmark.gpkg --place \"Bryant Park\" --day 2026-03-21 \\\n"
        "    --from Existing --to Tower --zone America/New_York");
    command->callback([options, command, &run] {
        const bool hours =
            command->count("--at") + command->count("--hours") + command->count("--window") > 0;
        run = [options, hours](const Console& console) { return runTimeline(*options, hours, console); };
    });
}

}  // namespace noonmark::cli
