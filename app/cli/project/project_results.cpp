#include <fmt/format.h>

#include "app/cli/project/list_project.h"
#include "app/cli/project/project_commands.h"

namespace noonmark::cli {

namespace {

using SharedResult = std::shared_ptr<const SavedResult>;

std::string cityOf(const SavedResult& result) {
    return result.baseline.empty() ? result.scenario
                                   : fmt::format("{} -> {}", result.baseline, result.scenario);
}

std::vector<Listed> listResults(const Project& project) {
    std::vector<Listed> lines;
    for (const SharedResult& result : project.results)
        lines.push_back(
            {result->name,
             fmt::format("{} of {}", result->kind, cityOf(*result)),
             {{"kind", result->kind}, {"scenario", result->scenario}, {"baseline", result->baseline}}});
    return lines;
}

Result<std::string> removeResults(const RemoveOptions& options, Project& project) {
    return removeNamed(
        project.results, options.names, [](const SharedResult& result) { return result->name; },
        [&](const std::string& name) { return findResult(project, name); });
}

}  // namespace

void addProjectResult(CLI::App& project, Run& run) {
    CLI::App* group = project.add_subcommand("result", "Results of impact and score saved in the project");
    group->require_subcommand(1);
    addListCommand(*group, "List the saved results", listResults, run);
    addRemoveCommand(*group, "Remove saved results", removeResults, run);
}

}  // namespace noonmark::cli
