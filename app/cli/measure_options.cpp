#include "app/cli/measure_options.h"

#include <algorithm>

#include "app/cli/engine_options.h"
#include "app/cli/project/change_project.h"
#include "app/cli/study_options.h"
#include "core/io/read_region.h"

namespace noonmark::cli {

namespace {

// A period of the project by its name, or days and hours.
void addPeriod(CLI::App& command, MeasureOptions& options) {
    const std::vector<CLI::Option*> before = command.get_options();
    addPeriodOptions(command, options.period);
    CLI::Option* named =
        command.add_option("--period", options.periodName, "A period of the project, instead of --start");
    named->type_name("NAME");
    for (CLI::Option* option : command.get_options())
        if (option != named && std::ranges::find(before, option) == before.end()) named->excludes(option);
}

Result<Period> periodOf(const MeasureOptions& options, const Project& project) {
    if (!options.periodName.empty())
        return periodNamed(project, options.periodName).map([](const NamedPeriod& named) {
            return named.period;
        });
    if (!options.period.start.empty()) return periodFrom(options.period);
    return failure("It is not said when", "period", "Give --start DATE, or --period NAME of the project");
}

bool looksLikePlace(const std::string& text) {
    std::error_code ignored;
    return text.find_first_of(",(") != std::string::npos || std::filesystem::exists(text, ignored);
}

// A region of the project by its name, or a place.
Result<Region> regionOf(const MeasureOptions& options, const Project& project) {
    auto region = regionNamed(project, options.region);
    if (region) return region;
    auto place = readRegion(options.region, project.city->frame);
    if (place || looksLikePlace(options.region)) return place;
    return failure(region.error().what, region.error().where,
                   region.error().advice + "; or give a box, a polygon or a file");
}

}  // namespace

void addMeasureOptions(CLI::App& command, MeasureOptions& options) {
    addProjectFile(command, options.file);
    command
        .add_option("--region", options.region,
                    "Where to measure: a region of the project, west,south,east,north in degrees, POLYGON "
                    "((lon lat, ...)), or a polygon file")
        ->required()
        ->type_name("NAME|W,S,E,N|WKT|FILE");
    addPeriod(command, options);
    addReceiverOptions(command, options.settings);
    addEngineOptions(command, options.settings);
    command.add_option("--out", options.out, "Folder for GeoTIFF, picture, PDF page, CSV and JSON")
        ->required()
        ->type_name("DIR");
    command.add_option("--keep", options.keep, "Keep the result in the project, under this name")
        ->type_name("NAME");
    command.add_flag("--json", options.json, "The JSON on standard output, nothing else");
}

Result<StudySettings> settingsFrom(const MeasureOptions& options, const Project& project) {
    StudySettings settings = options.settings;
    const auto period = periodOf(options, project);
    if (!period) return tl::make_unexpected(period.error());
    settings.period = *period;
    auto region = regionOf(options, project);
    if (!region) return tl::make_unexpected(region.error());
    settings.region = *std::move(region);
    return settings;
}

}  // namespace noonmark::cli
