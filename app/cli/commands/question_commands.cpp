#include "app/cli/commands/question_commands.h"

#include <memory>
#include <ostream>

#include "app/cli/base/table.h"
#include "app/cli/options/picture_option.h"
#include "app/cli/study/run_measure.h"

namespace noonmark::cli {

namespace {

struct QuestionOptions {
    MeasureOptions measure;
    std::string scenario;
};

void printAnswer(const Answer& answer, std::ostream& out) {
    if (const Sentence& headline = answer.page(ShownAs::shadow).headline; !headline.source.empty())
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

}  // namespace noonmark::cli
