#include <memory>

#include "app/cli/options/study_options.h"
#include "app/cli/project/list_project.h"
#include "app/cli/project/project_commands.h"
#include "core/sun/period_fields.h"

namespace noonmark::cli {

namespace {

struct AddPeriodOptions {
    ChangeOptions change;
    std::string name;
    PeriodOptions period{.names = periodFlagsBesideScenarios()};
};

Result<std::string> addPeriod(const AddPeriodOptions& options, Project& project) {
    return periodFrom(options.period).map([&](const Period& period) {
        project.periods.push_back({options.name, period});
        return options.name + ": " + formatText(period) + "\n";
    });
}

std::vector<Listed> listPeriods(const Project& project) {
    std::vector<Listed> lines;
    for (const NamedPeriod& period : project.periods)
        lines.push_back({period.name, formatText(period.period), {{"period", formatText(period.period)}}});
    return lines;
}

Result<std::string> removePeriods(const RemoveOptions& options, Project& project) {
    return removeNamed(
        project.periods, options.names, [](const NamedPeriod& period) { return period.name; },
        [&](const std::string& name) { return findPeriod(project, name); });
}

}  // namespace

void addProjectPeriod(CLI::App& project, Run& run) {
    CLI::App* group = project.add_subcommand("period", "Named periods: days and hours to measure");
    group->require_subcommand(1);
    const auto options = std::make_shared<AddPeriodOptions>();
    CLI::App* command = addChangeCommand(*group, "add", "Add a period, for `--period` of impact and score",
                                         options, addPeriod, run);
    command->add_option("name", options->name, "Name of the period")->required()->type_name("NAME");
    addPeriodOptions(*command, options->period)->required();
    addListCommand(*group, "List the periods", listPeriods, run);
    addRemoveCommand(*group, "Remove periods", removePeriods, run);
}

}  // namespace noonmark::cli
