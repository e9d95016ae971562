#include <fmt/format.h>

#include <memory>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/progress_line.h"
#include "app/cli/base/table.h"
#include "app/cli/options/picture_option.h"
#include "app/cli/options/sheet_options.h"
#include "app/cli/study/run_measure.h"
#include "app/report/files/answer_files.h"
#include "core/describe/command_flags.h"
#include "scenarios/project/project_provenance.h"
#include "scenarios/weights/score_figures.h"

namespace noonmark::cli {

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
    addFigures(table, listLines(scoreFigures().of(score)));
    for (const MonthFigures& month : score.months)
        addFigures(table, fmt::format("{:04}-{:02}", int(month.month.year()), unsigned(month.month.month())),
                   listLines(scoreMonthFigures().of(month), FigureUse::result));
    addErrors(table, score.errors);
    table.print(out);
    printWarnings(out, score.warnings);
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
    addMeasureOptions(*command, options->measure);
    addSaveOption(*command, options->measure);
    addPictureOption(*command, options->measure.pictureWidth);
    addLegendOptions(*command, options->measure.legend);
    addSheetSwitch(*command, options->sheets);
    addSheetOptions(*command, options->sheets);
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

}  // namespace noonmark::cli
