#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <ostream>
#include <set>

#include "app/cli/base/change_project.h"
#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/field_options.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/options/sheet_options.h"
#include "app/cli/options/study_options.h"
#include "app/input/all_engines.h"
#include "app/questions/review_question.h"
#include "app/report/scenarios/scenario_book.h"
#include "app/report/scenarios/scenario_study.h"
#include "core/base/progress.h"
#include "core/base/units.h"
#include "core/describe/command_options.h"
#include "core/measures/shadow_figures.h"
#include "core/study/study_fields.h"
#include "scenarios/impact/impact.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/project/project_provenance.h"
#include "scenarios/scenario.h"
#include "scenarios/weights/score_text.h"

namespace noonmark::cli {

namespace {

struct ScenariosOptions {
    MeasureOptions measure;
    SheetOptions sheets;
    std::vector<std::string> names;  // empty: all
    std::string weights;             // name of a table; empty: no scores
    std::string baseline;            // of comparisons; empty: none
    double thresholdMin = defaultThresholdsMin.front();
};

// What is asked of each scenario.
struct ScenariosQuestion {
    StudySettings study;
    std::optional<TimeWeights> weights;
    std::string baseline{};
    double thresholdMin = defaultThresholdsMin.front();
};

std::vector<std::string> chooseScenarios(const ScenariosOptions& options, const Project& project) {
    return options.names.empty() ? listNames(project.scenarios) : options.names;
}

// What was measured, and what could not be.
struct MeasuredScenarios {
    ScenarioStudies studies;
    FailedScenarios failed;
};

Result<void> addScore(ScenarioStudy& scenario, const ScenariosQuestion& question, Progress& progress,
                      const std::stop_token& stop) {
    const StudySettings& settings = question.study;
    auto score = runScore(scenario.study->city, settings, *question.weights, progress, stop,
                          enginesWith(settings.engine));
    if (!score) return tl::make_unexpected(score.error());
    scenario.answers.score =
        ScenarioScore{question.weights->name, *score, std::move(score->months), std::move(score->errors),
                      withoutMaps(std::move(score->withTrees))};
    return {};
}

Result<ScenarioStudy> measureScenario(const std::string& name, const ScenariosQuestion& question,
                                      const ProjectFile& disk, Progress& progress,
                                      const std::stop_token& stop) {
    const Project& project = disk.project();
    const StudySettings& settings = question.study;
    const auto city = cityOf(project, name);
    if (!city) return tl::make_unexpected(city.error());
    auto study = runStudy(city->city, settings, progress, stop, enginesWith(settings.engine));
    if (!study) return tl::make_unexpected(study.error());
    prependWarnings(study->warnings, project.reading->warnings);
    study->provenance = provenanceOf(project, &disk, {name, {}, settings.region, question.weights});
    return makeScenarioStudy(project.scenarios, name, std::make_shared<const Study>(*std::move(study)));
}

// What fails is noted, and its study stays where only the score fails. Error: cancelled().
Result<void> addScenario(MeasuredScenarios& made, const std::string& name, const ScenariosQuestion& question,
                         const ProjectFile& disk, Progress& progress, const std::stop_token& stop) {
    const std::size_t parts = question.weights ? 2 : 1;
    ProgressShare first(progress, 0, parts), second(progress, parts - 1, parts);
    const auto note = [&](const Error& error) -> Result<void> {
        if (isCancelled(error)) return tl::make_unexpected(error);
        made.failed.push_back({name, error});
        return {};
    };
    auto study = measureScenario(name, question, disk, first, stop);
    if (!study) return note(study.error());
    made.studies.push_back(*std::move(study));
    if (!question.weights) return {};
    const auto scored = addScore(made.studies.back(), question, second, stop);
    return scored ? Result<void>() : note(scored.error());
}

const std::string& cityOf(const Study& study) { return study.provenance.project->scenario.citySha256; }

// As a comparison finds it, where the two studies are not enough: their engines were chosen one by one.
Result<ImpactFigures> compare(const Study& before, const Study& after, const ScenariosQuestion& question,
                              Progress& progress, const std::stop_token& stop) {
    if (areComparable(before, after)) return compareStudies(before, after, question.thresholdMin);
    return runImpact(before.city, after.city, {.study = question.study}, progress, stop,
                     enginesWith(question.study.engine))
        .map([&](const ImpactStudy& impact) { return computeFigures(impact.total, question.thresholdMin); });
}

// The baseline itself, and scenarios with its buildings, have no impact.
Result<void> addImpacts(MeasuredScenarios& made, const ScenariosQuestion& question, const ProjectFile& disk,
                        Progress& progress, const std::stop_token& stop) {
    const auto known = std::ranges::find(made.studies, question.baseline, &ScenarioStudy::name);
    auto before = known != made.studies.end()
                      ? Result<ScenarioStudy>(*known)
                      : measureScenario(question.baseline, question, disk, progress, stop);
    if (!before) return tl::make_unexpected(before.error());
    for (ScenarioStudy& one : made.studies) {
        if (cityOf(*one.study) == cityOf(*before->study)) continue;
        const auto figures = compare(*before->study, *one.study, question, progress, stop);
        if (figures)
            one.answers.impact = ScenarioImpact{question.baseline, *figures};
        else if (isCancelled(figures.error()))
            return tl::make_unexpected(figures.error());
        else
            made.failed.push_back({one.name, figures.error()});
    }
    return {};
}

Result<MeasuredScenarios> measureAll(const std::vector<std::string>& names, const ScenariosQuestion& question,
                                     const ProjectFile& disk, const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    MeasuredScenarios made;
    for (std::size_t i = 0; i < names.size(); ++i) {
        ProgressShare share(progress, i, names.size());
        if (auto done = addScenario(made, names[i], question, disk, share, interrupt.token()); !done)
            return tl::make_unexpected(done.error());
    }
    if (question.baseline.empty() || made.studies.empty()) return made;
    return addImpacts(made, question, disk, progress, interrupt.token()).map([&] { return std::move(made); });
}

// Everything that can be wrong with the request is found before the first scenario is measured.
Result<ScenariosQuestion> checkRequest(const ScenariosOptions& options, const std::vector<std::string>& names,
                                       const Project& project) {
    for (const std::string& name : names) {
        if (std::ranges::count(names, name) > 1)
            return failure("The scenario is named twice", "--scenario " + name, "Name each scenario once");
        if (const auto city = cityOf(project, name); !city && !options.names.empty())
            return tl::make_unexpected(city.error());
    }
    if (const auto sheets = bookSettingsOf(options.sheets, project.sheets); !sheets)
        return tl::make_unexpected(sheets.error());
    if (auto may =
            checkOutputs(options.measure.out, scenarioFileNames(), outputRulesOf(options.measure, project));
        !may)
        return tl::make_unexpected(may.error());
    if (!options.baseline.empty())
        if (const auto city = cityOf(project, options.baseline); !city)
            return tl::make_unexpected(city.error());
    auto settings = settingsFrom(options.measure, project);
    if (!settings) return tl::make_unexpected(settings.error());
    ScenariosQuestion question{*std::move(settings), {}, options.baseline, options.thresholdMin};
    if (options.weights.empty()) return question;
    auto weights = findWeights(project, options.weights);
    if (!weights) return tl::make_unexpected(weights.error());
    question.weights = *std::move(weights);
    return question;
}

Result<void> writeFiles(const MeasuredScenarios& made, const ScenariosOptions& options,
                        const Project& project) {
    const OffscreenQt qt;
    auto sheets = bookSettingsOf(options.sheets, project.sheets);
    if (!sheets) return tl::make_unexpected(sheets.error());
    sheets->legend = options.measure.legend;
    return writeScenarioFiles(made.studies, *sheets, options.measure.out,
                              outputRulesOf(options.measure, project), made.failed)
        .map([](const auto&) {});
}

// Each warning once: scenarios share most of their buildings.
Warnings collectWarnings(const ScenarioStudies& studies) {
    Warnings all;
    std::set<std::pair<std::string, std::string>> known;
    for (const ScenarioStudy& scenario : studies)
        for (const Warning& warning : scenario.study->warnings)
            if (known.emplace(warning.what, warning.where).second) all.push_back(warning);
    return all;
}

// ", 70.0 m high, 12,300 m2 floor area"; nothing where the scenario adds no building.
std::string describeBuilt(const ScenarioStudy& scenario) {
    std::string words;
    if (scenario.heightM) words += fmt::format(", {:.1f} m high", *scenario.heightM);
    if (const auto floorM2 = sumFloorAreaM2(scenario.uses))
        words += fmt::format(", {} m2 floor area", formatNumber(*floorM2));
    return words;
}

void addScoreLines(Table& table, const ScenarioScore& score) {
    addFigures(table, "", listLines(scoreFigures().of(score.totals), FigureUse::result));
    for (const ShadedScore& with : score.withTrees)
        addFigures(table, "",
                   listLines({scoreFiguresWithTrees(with.column), static_cast<const ScoreTotals*>(&with)},
                             FigureUse::result));
}

void print(const ScenarioStudies& studies, std::ostream& out) {
    Table table;
    for (const ScenarioStudy& scenario : studies) {
        const ShadowStatistics& figures = scenario.study->statistics;
        addFigures(table, scenario.name, listLines(shadowFigures().of(figures), FigureUse::result));
        for (const ShadedFigures& with : scenario.withTrees)
            addFigures(table, "", listLines({treeFigures(with.column), &with.figures}, FigureUse::result));
        table.add("", fmt::format("change of the shadow area {} m2{}",
                                  formatSigned(computeShadowAreaChange(studies, scenario), 0),
                                  describeBuilt(scenario)));
        if (const auto& impact = scenario.answers.impact)
            table.add("", fmt::format(
                              "against {}: {}", impact->baseline,
                              joinLines(listLines(impactFigures().of(impact->figures), FigureUse::result))));
        if (const auto& score = scenario.answers.score) addScoreLines(table, *score);
    }
    table.print(out);
    printWarnings(out, collectWarnings(studies));
}

// Exit code: something failed, or nothing.
int reportFailed(const FailedScenarios& failed, const Console& console) {
    int code = exitOk;
    for (const FailedScenario& one : failed) {
        Error named = one.error;
        named.where = named.where.empty() ? one.name : one.name + ", " + named.where;
        code = fail(console, named, exitFailed);
    }
    return code;
}

int runScenariosCommand(const ScenariosOptions& options, const Console& console) {
    const auto disk = openProject(options.measure.file, console);
    if (!disk) return fail(console, disk.error(), exitUsage);
    const std::vector<std::string> names = chooseScenarios(options, disk->project());
    const auto question = checkRequest(options, names, disk->project());
    if (!question) return fail(console, question.error(), exitUsage);
    if (options.measure.withProject)
        if (const auto may = checkCopy(*disk, options.measure.out); !may)
            return fail(console, may.error(), exitUsage);
    const auto made = measureAll(names, *question, *disk, console);
    if (!made) return fail(console, made.error(), exitFailed);
    if (made->studies.empty()) return reportFailed(made->failed, console);
    if (const auto written = writeFiles(*made, options, disk->project()); !written)
        return fail(console, written.error(), exitFailed);
    if (options.measure.withProject)
        if (const auto copied = copyProject(*disk, options.measure.out); !copied)
            return fail(console, copied.error(), exitFailed);
    if (options.measure.json)
        console.out << scenariosJson(made->studies, made->failed) << '\n';
    else
        print(made->studies, console.out);
    return reportFailed(made->failed, console);
}

}  // namespace

void addScenariosCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<ScenariosOptions>();
    CLI::App* command =
        app.add_subcommand("scenarios", "Measure the same study of all scenarios of a project, side by side");
    addMeasureOptions(*command, options->measure);
    addSheetOptions(*command, options->sheets);
    addLegendOptions(*command, options->measure.legend);
    addErrorOptions(*command, options->measure.settings.errorSample);
    addMonthOption(*command, options->measure.settings);
    addFieldOptions(*command, treeFields().of(options->measure.settings));
    command
        ->add_option(flags::weights, options->weights,
                     "Also score each scenario, in all and by month, with this time-weight table of the "
                     "project")
        ->type_name("NAME");
    command
        ->add_option(flags::scenario, options->names,
                     "A scenario to measure; may be repeated; the first is what the others are compared with "
                     "(default: the existing city and all scenarios)")
        ->type_name("NAME");
    command
        ->add_option(flags::baseline, options->baseline,
                     "Also state the impact of each scenario: what it changes against this one")
        ->type_name("NAME");
    command
        ->add_option(flags::threshold, options->thresholdMin,
                     "Minutes of more or less shadow a day above which area counts in the impact")
        ->type_name("MIN")
        ->check(CLI::Range(0.0, ImpactSettings::maxThresholdMin))
        ->capture_default_str();
    addProjectCopyOption(*command, options->measure.withProject);
    command->callback([options, &run] {
        run = [options](const Console& console) { return runScenariosCommand(*options, console); };
    });
}

}  // namespace noonmark::cli
