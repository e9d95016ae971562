#include "app/cli/measure_options.h"

#include "app/cli/engine_options.h"
#include "app/cli/project/change_project.h"
#include "app/cli/study_options.h"
#include "core/io/read_region.h"

namespace noonmark::cli {

void addMeasureOptions(CLI::App& command, MeasureOptions& options) {
    options.settings.engine = "horizon";
    addProjectFile(command, options.file);
    command
        .add_option(
            "--region", options.region,
            "Where to measure: a region of the project, west,south,east,north in degrees, or a polygon file")
        ->required()
        ->type_name("NAME|W,S,E,N|FILE");
    addPeriodOptions(command, options.period);
    addReceiverOptions(command, options.settings);
    addEngineOptions(command, options.settings);
    command.add_option("--out", options.out, "Folder for the GeoTIFF, CSV and JSON")
        ->required()
        ->type_name("DIR");
    command.add_option("--keep", options.keep, "Keep the result in the project, under this name")
        ->type_name("NAME");
    command.add_flag("--json", options.json, "The JSON on standard output, nothing else");
}

Result<StudySettings> settingsFrom(const MeasureOptions& options, const Project& project) {
    StudySettings settings = options.settings;
    const auto period = periodFrom(options.period);
    if (!period) return tl::make_unexpected(period.error());
    settings.period = *period;
    auto region = regionNamed(project, options.region);
    const Error unknown = region ? Error{} : region.error();
    if (!region) region = readRegion(options.region, project.city->frame);
    if (!region) return failure(unknown.what, unknown.where, unknown.advice + "; or give a box or a file");
    settings.region = *std::move(region);
    return settings;
}

Result<std::filesystem::path> folderFor(const MeasureOptions& options) {
    std::error_code error;
    std::filesystem::create_directories(options.out, error);
    if (std::filesystem::is_directory(options.out)) return std::filesystem::path(options.out);
    return failure("The folder could not be made", options.out, "Choose a folder that you may write to");
}

}  // namespace noonmark::cli
