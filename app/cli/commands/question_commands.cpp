#include "app/cli/commands/question_commands.h"

#include <fmt/format.h>
#include <functional>
#include <memory>
#include <ostream>
#include <string>

#include "app/cli/base/change_project.h"
#include "app/cli/base/command_line.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/options/field_options.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/options/sheet_options.h"
#include "app/cli/options/study_options.h"
#include "app/questions/review_question.h"
#include "app/report/files/answer_files.h"
#include "core/describe/command_options.h"
#include "core/study/study_fields.h"
#include "scenarios/project/project_provenance.h"
#include "scenarios/project/results/save_result.h"
#include "scenarios/weights/score_text.h"

namespace noonmark::cli {

/// What a command on a project asks, and how it prints the answer.
struct Measure {
    const Question& question;
    std::string scenario;
    std::string baseline{};  ///< of a comparison
    std::function<Result<void>(const Project&, Asked&)>
        complete{};  ///< what else it asks for; empty: nothing
    /// The names of its files: provenance states the region.
    std::function<std::vector<std::string>(const Provenance&, bool withSheets)> fileNames;
    std::function<ChangeScale(const Project&)> scale{};  ///< of a comparison's picture
    void (*print)(const Answer&, std::ostream&);
};

namespace {

using SharedAnswer = std::shared_ptr<const Answer>;

Result<Asked> makeAsked(const MeasureOptions& options, const Measure& measure, const Project& project) {
    Asked asked{.scenario = measure.scenario, .baseline = measure.baseline};
    auto settings = settingsFrom(options, project);
    if (!settings) return tl::make_unexpected(settings.error());
    asked.settings = *std::move(settings);
    if (measure.complete)
        if (auto done = measure.complete(project, asked); !done) return tl::make_unexpected(done.error());
    if (!measure.baseline.empty()) {
        auto before = cityOf(project, measure.baseline);
        if (!before) return tl::make_unexpected(before.error());
        asked.before = std::make_shared<const City>(std::move(before->city));
    }
    auto city = cityOf(project, measure.scenario);
    if (!city) return tl::make_unexpected(city.error());
    asked.loaded.read.city = std::move(city->city);
    asked.loaded.read.warnings = project.reading->warnings;
    return asked;
}

// States what it is made from before --save changes the file.
Result<Asked> ask(const MeasureOptions& options, const SheetOptions& sheets, const Measure& measure,
                  const ProjectFile& disk) {
    auto asked = makeAsked(options, measure, disk.project());
    if (!asked) return asked;
    asked->provenance = provenanceOf(
        disk.project(), &disk, {asked->scenario, asked->baseline, asked->settings.region, asked->weights});
    const auto may = checkOutputs(options.out, measure.fileNames(asked->provenance, sheets.wanted),
                                  outputRulesOf(options, disk.project()));
    if (!may) return tl::make_unexpected(may.error());
    if (options.withProject)
        if (const auto free = checkCopy(disk, options.out); !free) return tl::make_unexpected(free.error());
    return asked;
}

Result<SharedAnswer> compute(const Question& question, const Asked& asked, const Console& console) {
    const Interrupt interrupt;
    ProgressLine progress(console);
    return question.compute(asked, progress, interrupt.token());
}

Result<void> writeFiles(const Answer& answer, const City& city, const MeasureOptions& options,
                        const SheetOptions& sheets, const Measure& measure, const ProjectFile& disk) {
    const OffscreenQt qt;
    const Project& project = disk.project();
    const auto book = bookSettingsOf(sheets, project.sheets);
    if (!book) return tl::make_unexpected(book.error());
    const AnswerFiles how{.scale = measure.scale ? measure.scale(project) : ChangeScale(),
                          .legend = options.legend,
                          .pictureWidth = options.pictureWidth,
                          .sheets = sheets.wanted,
                          .book = *book,
                          .rules = outputRulesOf(options, project)};
    return answer.write(city, options.out, how).and_then([&](const auto&) -> Result<void> {
        return options.withProject ? copyProject(disk, options.out) : Result<void>();
    });
}

Result<void> save(const Answer& answer, const std::string& name, ProjectFile& disk) {
    SavedResult result = answer.toSave(disk.project());
    result.name = name;
    return disk.save(addResult(disk.project(), std::move(result)));
}

}  // namespace

/// Opens the project, asks, writes the files, saves the answer in the project if requested, and prints it.
/// Returns the exit code.
int runMeasure(const MeasureOptions& options, const SheetOptions& sheets, const Measure& measure,
               const Console& console) {
    auto disk = openProject(options.file, console);
    if (!disk) return fail(console, disk.error(), exitUsage);
    const auto asked = ask(options, sheets, measure, *disk);
    if (!asked) return fail(console, asked.error(), exitUsage);
    const auto answer = compute(measure.question, *asked, console);
    if (!answer) return fail(console, answer.error(), exitUsage);
    const auto written = writeFiles(**answer, asked->loaded.read.city, options, sheets, measure, *disk);
    if (!written) return fail(console, written.error(), exitFailed);
    if (!options.keep.empty())
        if (const auto saved = save(**answer, options.keep, *disk); !saved)
            return fail(console, saved.error(), exitFailed);
    if (options.json)
        console.out << (*answer)->json() << '\n';
    else
        measure.print(**answer, console.out);
    return exitOk;
}

namespace {

struct QuestionOptions {
    MeasureOptions measure;
    std::string scenario;
};

void printAnswer(const Answer& answer, std::ostream& out) {
    if (const Sentence& headline = answer.page(LegendChoice{}).headline; !headline.source.empty())
        out << formatText(headline) << '\n';
    Table table;
    table.add("scenario", answer.part().scenario);
    addFigures(table, answer.figures());
    table.print(out);
    printWarnings(out, answer.warnings());
}

int runQuestion(const Question& question, const QuestionOptions& options, const Console& console) {
    return runMeasure(options.measure, {},
                      {.question = question,
                       .scenario = options.scenario,
                       .fileNames = [&question](const Provenance&, bool) { return question.fileNames; },
                       .print = printAnswer},
                      console);
}

void addCommand(CLI::App& app, Run& run, const Question& question) {
    const auto options = std::make_shared<QuestionOptions>();
    CLI::App* command = app.add_subcommand(std::string(question.key), std::string(question.help));
    addMeasureOptions(*command, options->measure);
    addSaveOption(*command, options->measure);
    addPictureOption(*command, options->measure.pictureWidth);
    command->add_option(flags::scenario, options->scenario, "The scenario to measure")
        ->default_val(existingCity)
        ->type_name("NAME");
    command->callback([options, &question, &run] {
        run = [options, &question](const Console& console) {
            return runQuestion(question, *options, console);
        };
    });
}

}  // namespace

void addQuestionCommands(CLI::App& app, Run& run, Questions questions) {
    for (const Question* question : questions)
        if (!question->help.empty()) addCommand(app, run, *question);
}

namespace {

struct ScoreOptions {
    MeasureOptions measure;
    SheetOptions sheets;
    std::string scenario;
    std::string weights;
};

void printScore(const Answer& weighed, std::ostream& out) {
    const auto& answer = *weighed.as<ScoreAnswer>();
    const Score& score = answer.score;
    Table table;
    table.add("scenario", answer.scenario);
    table.add("period", formatText(answer.settings.period));
    table.add("weights", answer.weights.name);
    table.add("engine", score.engine);
    addFigures(table, listScoreLines(score));
    for (const MonthFigures& month : score.months)
        addFigures(table, fmt::format("{:04}-{:02}", int(month.month.year()), unsigned(month.month.month())),
                   listLines(scoreMonthFigures().of(month), FigureUse::result));
    addErrors(table, score.errors);
    table.print(out);
    printWarnings(out, score.warnings);
}

// Options of questions about the cells of scenarios: what is measured, and its picture, legend and sheets.
void addAnswerOptions(CLI::App& command, MeasureOptions& measure, SheetOptions& sheets) {
    addMeasureOptions(command, measure);
    addSaveOption(command, measure);
    addPictureOption(command, measure.pictureWidth);
    addLegendOptions(command, measure.legend);
    addSheetSwitch(command, sheets);
    addSheetOptions(command, sheets);
}

int runScoreCommand(const ScoreOptions& options, const Console& console) {
    const auto complete = [&](const Project& project, Asked& asked) -> Result<void> {
        auto weights = findWeights(project, options.weights);
        if (!weights) return tl::make_unexpected(weights.error());
        asked.weights = *std::move(weights);
        return {};
    };
    return runMeasure(options.measure, options.sheets,
                      {.question = scoreQuestion(),
                       .scenario = options.scenario,
                       .complete = complete,
                       .fileNames = scoreFileNames,
                       .print = printScore},
                      console);
}

}  // namespace

void addScoreCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<ScoreOptions>();
    CLI::App* command = app.add_subcommand("score", "Weigh wanted shade against unwanted shadow over a year");
    addAnswerOptions(*command, options->measure, options->sheets);
    addFieldOptions(*command, treeFields().of(options->measure.settings));
    command->add_option(flags::scenario, options->scenario, "The scenario to measure")
        ->default_val(existingCity)
        ->type_name("NAME");
    command->add_option(flags::weights, options->weights, "A time-weight table of the project")
        ->default_val("default")
        ->type_name("NAME");
    command->callback([options, &run] {
        run = [options](const Console& console) { return runScoreCommand(*options, console); };
    });
}

namespace {

struct ImpactOptions {
    MeasureOptions measure;
    SheetOptions sheets;
    std::string from;
    std::string to;
    ImpactSettings settings;
    std::string scale;  // empty: the project's scale
};

// The scale given by the user, otherwise that of the project.
ChangeScale scaleOf(const ImpactOptions& options, const Project& project) {
    return parseChangeScale(options.scale).value_or(changeScaleIn(project.view));
}

void printComparison(const Answer& compared, std::ostream& out) {
    const auto& answer = *compared.as<ImpactAnswer>();
    const Impact& impact = answer.study.total;
    Table table;
    table.add("from, to", fmt::format("{} -> {}", answer.from, answer.to));
    table.add("period", formatText(answer.settings.study.period));
    table.add("engine", impact.engine);
    table.add("sunlit time", fmt::format("{:.1f} min a day", impact.sunlitMinutesPerDay));
    const ComparisonFigures figures = computeFigures(answer);
    addFigures(table, listLines(figures));
    addErrors(table, figures.errors);
    for (const BuildingImpact& building : answer.study.byBuilding)
        for (const double threshold : answer.settings.thresholdsMin)
            addFigures(table,
                       fmt::format("{}, over {:g} min", building.name.empty() ? building.id : building.name,
                                   threshold),
                       listThresholdLines(computeFigures(building.impact, threshold)));
    table.print(out);
    printWarnings(out, impact.warnings);
}

int runImpactCommand(const ImpactOptions& options, const Console& console) {
    const auto complete = [&](const Project&, Asked& asked) -> Result<void> {
        asked.impact = options.settings;
        return {};
    };
    const auto scale = [&](const Project& project) { return scaleOf(options, project); };
    return runMeasure(options.measure, options.sheets,
                      {.question = comparisonQuestion(),
                       .scenario = options.to,
                       .baseline = options.from,
                       .complete = complete,
                       .fileNames = impactFileNames,
                       .scale = scale,
                       .print = printComparison},
                      console);
}

}  // namespace

void addImpactCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<ImpactOptions>();
    CLI::App* command =
        app.add_subcommand("impact", "Measure how shadow changes from one scenario of a project to another");
    addAnswerOptions(*command, options->measure, options->sheets);
    addErrorOptions(*command, options->measure.settings.errorSample);
    addFieldOptions(*command, treeFields().of(options->measure.settings));
    command->add_option(flags::from, options->from, "The baseline: the scenario to compare with")
        ->default_val(existingCity)
        ->type_name("NAME");
    command->add_option(flags::to, options->to, "The scenario to measure")->required()->type_name("NAME");
    addFieldOptions(*command, impactFields().of(options->settings), {.listsTakeBlanks = true});
    command
        ->add_option(changeScaleFlag, options->scale,
                     "Ends of the picture's colour scale, minutes of change, or auto: fitted to this "
                     "difference (default: the project's scale, 60)")
        ->check([](const std::string& text) {
            return parseChangeScale(text) ? std::string() : "Minutes from above 0 to 1440, or auto";
        })
        ->type_name("MIN|auto");
    command->callback([options, &run] {
        run = [options](const Console& console) { return runImpactCommand(*options, console); };
    });
}

}  // namespace noonmark::cli
