#include <fmt/format.h>

#include <memory>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/interrupt.h"
#include "app/cli/base/offscreen_qt.h"
#include "app/cli/base/progress_line.h"
#include "app/cli/base/table.h"
#include "app/cli/options/number_range.h"
#include "app/cli/options/picture_option.h"
#include "app/cli/options/sheet_options.h"
#include "app/cli/options/study_options.h"
#include "app/cli/study/run_measure.h"
#include "app/report/files/answer_files.h"
#include "core/describe/command_flags.h"
#include "scenarios/project/project_provenance.h"

namespace noonmark::cli {

namespace {

struct ImpactOptions {
    MeasureOptions measure;
    SheetOptions sheets;
    std::string from;
    std::string to;
    std::vector<double> thresholds{defaultThresholdsMin.begin(), defaultThresholdsMin.end()};
    bool byBuilding = false;
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
        for (const double threshold : answer.thresholdsMin)
            addFigures(table,
                       fmt::format("{}, over {:g} min", building.name.empty() ? building.id : building.name,
                                   threshold),
                       listThresholdLines(computeFigures(building.impact, threshold)));
    table.print(out);
    printWarnings(out, impact.warnings);
}

int runImpactCommand(const ImpactOptions& options, const Console& console) {
    const auto complete = [&](const Project&, Asked& asked) -> Result<void> {
        asked.byBuilding = options.byBuilding;
        asked.thresholdsMin = options.thresholds;
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
    addMeasureOptions(*command, options->measure);
    addSaveOption(*command, options->measure);
    addPictureOption(*command, options->measure.pictureWidth);
    addLegendOptions(*command, options->measure.legend);
    addSheetSwitch(*command, options->sheets);
    addSheetOptions(*command, options->sheets);
    addErrorOptions(*command, options->measure.settings.errorSample);
    command->add_option(flags::from, options->from, "The baseline: the scenario to compare with")
        ->default_val(existingCity)
        ->type_name("NAME");
    command->add_option(flags::to, options->to, "The scenario to measure")->required()->type_name("NAME");
    command
        ->add_option(flags::threshold, options->thresholds,
                     "Thresholds of the change, minutes a day; one or more")
        ->capture_default_str()
        ->check(within(0, 1440))
        ->type_name("MIN");
    command->add_flag(flags::byBuilding, options->byBuilding,
                      "Also measure the sole contribution of each new building");
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
