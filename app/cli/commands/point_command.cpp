#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <ostream>
#include <sstream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/project_options.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/study/study_request.h"
#include "app/input/load_city.h"
#include "app/report/skyline/skyline_svg.h"
#include "core/describe/command_options.h"
#include "core/io/files/write_text.h"
#include "core/measures/shadow_figures.h"
#include "core/study/point_cases.h"
#include "core/study/text/error_text.h"
#include "core/study/text/point_text.h"
#include "scenarios/project/project_file.h"

namespace noonmark::cli {

namespace {

constexpr std::size_t fewPlaces = 3;  // of each warning, as in printed lines

struct PointOptions {
    ReadOptions read;
    PointQuestion question;
    std::string day;
    std::string zone;
    std::string scenario;
    std::string baseline;
    bool allScenarios = false;  ///< also list the point's figures in all scenarios
    std::string svg;            ///< file of the drawing; empty: none
    std::string csv;            ///< file of the minutes by month and hour; empty: none
    bool overwrite = false;
    bool json = false;
    bool allWarnings = false;  ///< in JSON: all places of each
};

/// The cities of the question, and the clock.
struct PointCities {
    City baseline;
    std::optional<City> scenario;
    std::string zone;
    std::vector<PointScenario> cases{};  ///< the existing city and all scenarios, if asked for
    Warnings warnings{};                 ///< of reading, and of what is not measured
};

void parsePlace(const std::string& text, PointQuestion& question) {
    const auto at = parseLonLat(text, &question.heightM);
    if (!at) throw CLI::ValidationError("--at", at.error().text());
    question.at = *at;
}

Result<std::vector<PointScenario>> casesOf(const Project& project) {
    std::vector<PointScenario> cases{{existingCity, project.city}};
    for (const Scenario& scenario : project.scenarios) {
        auto city = cityOf(project, scenario.name);
        if (!city) return tl::make_unexpected(city.error());
        cases.push_back({scenario.name, std::make_shared<const City>(std::move(city->city))});
    }
    return cases;
}

Result<PointCities> citiesOfProject(const PointOptions& options) {
    const std::string& file = options.read.files.front();
    if (const auto alone = checkProjectAlone(options.read); !alone) return tl::make_unexpected(alone.error());
    const auto disk = ProjectFile::open(file);
    if (!disk) return tl::make_unexpected(disk.error());
    const auto before = cityOf(disk->project(), options.baseline.empty() ? existingCity : options.baseline);
    if (!before) return tl::make_unexpected(before.error());
    PointCities cities{before->city, std::nullopt, commonZone(disk->project()).value_or("UTC")};
    cities.warnings = disk->project().reading->warnings;
    if (!options.scenario.empty()) {
        const auto after = cityOf(disk->project(), options.scenario);
        if (!after) return tl::make_unexpected(after.error());
        cities.scenario = after->city;
    }
    if (options.allScenarios) {
        auto cases = casesOf(disk->project());
        if (!cases) return tl::make_unexpected(cases.error());
        cities.cases = *std::move(cases);
    }
    return cities;
}

Result<PointCities> citiesOf(const PointOptions& options, const Console& console) {
    if (namesProject(options.read)) return citiesOfProject(options);
    if (!options.scenario.empty() || !options.baseline.empty() || options.allScenarios)
        return failure("Only a project has scenarios", options.read.files.front(),
                       "Omit --scenario, --against and --all-scenarios, or give a project file");
    return loadCity(options.read, console).map([](const LoadedCity& loaded) {
        PointCities cities{loaded.read.city, std::nullopt, "UTC"};
        cities.warnings = loaded.read.warnings;
        return cities;
    });
}

void print(const PointStudy& study, const City& city, const City* scenario, const Zone& zone,
           std::ostream& out) {
    Table table;
    const auto addView = [&](const std::string& name, const PointView& view, const City& of) {
        table.add(name + "sunlit", sunlitText(view.sunlit, zone));
        if (view.crowns)
            for (const TreeColumns column : PointCrowns::columns)
                table.add(fmt::format("{}sunlit, {}", name, describeTrees(column)),
                          sunlitText(view.crowns->of(column).sunlit, zone));
        table.add(name + "hidden by", shadedText(view, of, zone));
        if (view.crowns) {
            table.add(name + "sun with trees", treesText(*view.crowns));
            if (const std::string taken = takenText(*view.crowns); !taken.empty())
                table.add(name + "taken by trees", taken);
            table.add(name + "sky with trees",
                      treesSkyText(*view.crowns, study.question.facingDeg.has_value()));
        }
        table.add(name + "sky view factor", fmt::format("{:.3f}", view.factors.skyView));
        if (study.question.facingDeg)
            table.add(name + "vertical sky component", fmt::format("{:.1f} %", view.factors.skyComponentPct));
    };
    table.add("day", fmt::format("{}, times of {}", formatText(study.question.day), zone.name()));
    addView("", study.baseline, city);
    if (study.scenario) addView("scenario: ", *study.scenario, scenario != nullptr ? *scenario : city);
    table.print(out);
    out << describe(study, city) << '\n';
}

void addCase(Table& table, const PointCaseFigures& figures, const PointCaseFigures& first, bool wall) {
    if (!figures.why.empty()) return table.add(figures.name, figures.why);
    for (const auto& [shade, changeMin] : listCaseLines(figures, first)) {
        std::string text = fmt::format("{:.0f} min on the day, {:.1f} h in the year, sky view {:.3f}",
                                       shade.dayMin, shade.yearMin / 60, shade.skyView);
        if (wall) text += fmt::format(", VSC {:.1f} %", shade.skyComponentPct);
        if (&figures != &first)
            text += fmt::format("; {} h against {}", formatSigned(changeMin / 60, 1), first.name);
        table.add(shade.column == TreeColumns::without ? figures.name
                                                       : fmt::format("  {}", describeTrees(shade.column)),
                  text);
    }
}

void printCases(const std::vector<PointCaseFigures>& cases, bool wall, std::ostream& out) {
    if (cases.empty()) return;
    Table table;
    for (const PointCaseFigures& figures : cases) addCase(table, figures, cases.front(), wall);
    const bool anyTrees =
        std::ranges::any_of(cases, [](const PointCaseFigures& one) { return !one.withTrees.empty(); });
    out << (anyTrees ? "\nScenarios, without trees unless a line says so\n" : "\nScenarios\n");
    table.print(out);
}

bool isSameFile(const std::string& a, const std::string& b) {
    return std::filesystem::absolute(a).lexically_normal() == std::filesystem::absolute(b).lexically_normal();
}

Result<void> checkFiles(const PointOptions& options) {
    const OutputRules rules = outputRules(listNamedFiles(options.read), {}, options.overwrite);
    if (!options.svg.empty() && !options.csv.empty() && isSameFile(options.svg, options.csv))
        return failure("The drawing and the table cannot be one file", options.svg, "Name two files");
    if (!options.svg.empty())
        if (const auto may = checkOutput(options.svg, OutputKind::svg, rules); !may) return may;
    return options.csv.empty() ? Result<void>() : checkOutput(options.csv, OutputKind::table, rules);
}

Result<void> writeFiles(const PointOptions& options, const PointStudy& study, const City& city,
                        const Zone& zone) {
    if (!options.svg.empty())
        if (const auto written = writeText(options.svg, skylineSvg(study, city, zone)); !written)
            return written;
    return options.csv.empty() ? Result<void>() : writeText(options.csv, pointCsv(study));
}

// "count" states how many there are.
void listFew(nlohmann::ordered_json& warnings) {
    for (auto& group : warnings)
        while (group["where"].size() > fewPlaces) group["where"].erase(fewPlaces);
}

int runPoint(const PointOptions& options, const Console& console) {
    PointQuestion question = options.question;
    const auto day = parseDate(options.day);
    if (!day) return fail(console, day.error(), exitUsage);
    question.day = *day;
    if (const auto may = checkFiles(options); !may) return fail(console, may.error(), exitUsage);
    const auto cities = citiesOf(options, console);
    if (!cities) return fail(console, cities.error(), exitUsage);
    question.zone = options.zone.empty() ? cities->zone : options.zone;
    const auto zone = Zone::named(question.zone);
    if (!zone) return fail(console, zone.error(), exitUsage);
    const Interrupt interrupt;
    const City* const scenario = cities->scenario ? &*cities->scenario : nullptr;
    const auto study = runPointStudy(cities->baseline, scenario, question, interrupt.token());
    if (!study) return fail(console, study.error(), exitUsage);
    if (const auto written = writeFiles(options, *study, cities->baseline, *zone); !written)
        return fail(console, written.error(), exitFailed);
    const auto cases = measurePointCases(cities->cases, question, interrupt.token());
    if (!cases) return fail(console, cases.error(), exitUsage);
    const bool wall = question.facingDeg.has_value();
    if (options.json) {
        auto json = pointJson(*study, cities->baseline, scenario, *zone);
        if (!cases->empty()) json["scenarios"] = pointCasesJson(*cases, wall);
        json["warnings"] = warningsJson(cities->warnings);
        if (!options.allWarnings) listFew(json["warnings"]);
        console.out << toJsonText(json) << '\n';
        return exitOk;
    }
    print(*study, cities->baseline, scenario, *zone, console.out);
    printCases(*cases, wall, console.out);
    printWarnings(console.out, cities->warnings);
    return exitOk;
}

}  // namespace

void addPointCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<PointOptions>();
    CLI::App* command =
        app.add_subcommand("point", "Show what hides the sun and the sky from one point, and when it is lit");
    options->read.filesHelp = "A project, or city files, or sample:central-park-south, sample:grid";
    addReadOptions(*command, options->read);
    command
        ->add_option_function<std::string>(
            "--at", [options](const std::string& text) { parsePlace(text, options->question); },
            "The point, and metres above the ground (default: on the ground, or on the roof of a building)")
        ->required()
        ->type_name("LON,LAT[,H]");
    command
        ->add_option(
            "--facing", options->question.facingDeg,
            "Azimuth that a wall at the point faces, degrees from true north (default: a level surface)")
        ->check(within(0.0, 360.0))
        ->type_name("DEG");
    command->add_option("--day", options->day, "Day of the sunlit bands; its year is measured, too")
        ->default_val("2026-03-21")
        ->type_name("DATE");
    command->add_option("--zone", options->zone, "Time zone (default: that of the project's periods, or UTC)")
        ->type_name("ZONE");
    command->add_option("--step", options->question.stepMinutes, "Minutes between positions of the sun")
        ->capture_default_str()
        ->check(within(1.0 / 60, 60.0))
        ->type_name("MIN");
    command
        ->add_option(flags::scenario, options->scenario,
                     "A scenario of the project: what it takes from the point")
        ->type_name("NAME");
    command
        ->add_option("--baseline,--against", options->baseline,
                     "The scenario to compare with (default: Existing)")
        ->type_name("NAME");
    command->add_flag("--all-scenarios", options->allScenarios,
                      "Also list the point's minutes and sky in the existing city and in all scenarios");
    command
        ->add_option("--svg", options->svg,
                     "Also draw the skyline and the sun's paths of the months, cylindrical and stereographic")
        ->type_name("FILE");
    command->add_option("--csv", options->csv, "Also write the sunlit minutes by month and hour")
        ->type_name("FILE");
    addOverwriteOption(*command, options->overwrite);
    addJsonFlag(*command, options->json);
    command->add_flag("--all-warnings", options->allWarnings,
                      "In JSON, list all places of each warning of reading (default: three)");
    command->footer(
        "A window 4.5 m above the street that faces south:\n"
        "  noonmark-cli point midtown.gpkg --at -73.9781,40.7648,4.5 --facing 180 --day 2026-12-21 \\\n"
        "    --zone America/New_York --json --svg skyline.svg");
    command->callback(
        [options, &run] { run = [options](const Console& console) { return runPoint(*options, console); }; });
}

}  // namespace noonmark::cli
