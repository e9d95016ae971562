#include "app/cli/options/measure_options.h"

#include "app/cli/base/change_project.h"
#include "app/cli/base/command.h"
#include "app/cli/options/project_options.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/options/study_options.h"
#include "app/input/output_rules.h"
#include "core/describe/command_options.h"

namespace noonmark::cli {

void addMeasureOptions(CLI::App& command, MeasureOptions& options) {
    addProjectFile(command, options.file);
    command
        .add_option("--region", options.region,
                    "Where to measure: a region of the project, west,south,east,north in degrees, POLYGON "
                    "((lon lat, ...)), a polygon file, or city: the box around all buildings")
        ->required()
        ->type_name("NAME|W,S,E,N|WKT|FILE|city");
    const std::vector<CLI::Option*> before = command.get_options();
    addPeriodOptions(command, options.period);
    addNamedPeriod(command, before, options.periodName);
    addCellOptions(command, options.settings);
    addEngineOptions(command, options.settings);
    command.add_option(flags::out, options.out, "Folder for GeoTIFF, picture, PDF page, CSV and JSON")
        ->required()
        ->type_name("DIR");
    addOverwriteOption(command, options.overwrite);
    addJsonFlag(command, options.json, "Print only the JSON to standard output");
}

void addSaveOption(CLI::App& command, MeasureOptions& options) {
    addProjectCopyOption(command, options.withProject);
    command.add_option("--save,--keep", options.keep, "Save the result in the project under this name")
        ->type_name("NAME");
}

Result<StudySettings> settingsFrom(const MeasureOptions& options, const Project& project) {
    StudySettings settings = options.settings;
    const auto period = periodIn(project, options.periodName, options.period);
    if (!period) return tl::make_unexpected(period.error());
    settings.period = *period;
    auto region = regionIn(project, *project.city, options.region);
    if (!region) return tl::make_unexpected(region.error());
    settings.region = *std::move(region);
    return settings;
}

OutputRules outputRulesOf(const MeasureOptions& options, const Project& project) {
    OutputRules rules = outputRules({options.file}, project.inputs, options.overwrite);
    addPlace(rules, options.region);
    return rules;
}

}  // namespace noonmark::cli
