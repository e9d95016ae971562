#include "app/cli/options/study_options.h"

#include <string>
#include <vector>

#include "app/cli/options/engine_options.h"
#include "app/cli/options/number_range.h"
#include "app/cli/options/overwrite_option.h"
#include "app/cli/options/picture_option.h"
#include "app/cli/project/project_question.h"
#include "core/receivers/roof_receivers.h"

namespace noonmark::cli {

namespace {

void takeReceivers(const std::string& name, StudyOptions& options) {
    options.points = std::nullopt;
    if (const auto places = parsePlaces(name)) options.settings.receivers.places = *places;
    for (const ElementPlaces places : allElementPlaces)
        if (name == nameOf(places)) options.points = options.elements.places = places;
}

void addPlacesOption(CLI::App& command, StudyOptions& options, ReceiverChoice choice) {
    std::vector<std::string> names;
    for (const ReceiverPlaces places : allReceiverPlaces) names.emplace_back(nameOf(places));
    std::string help =
        "Where shadow is measured: cells on the ground, roofs or both (roofs: engines horizon, ray, auto)";
    if (choice == ReceiverChoice::cellsAndPoints) {
        for (const ElementPlaces places : allElementPlaces) names.emplace_back(nameOf(places));
        help += ", or points: facades, windows of a file, a plane, lines around a parcel, single points";
    }
    command
        .add_option_function<std::string>(
            "--receivers", [&options](const std::string& name) { takeReceivers(name, options); }, help)
        ->check(CLI::IsMember(names))
        ->default_str("ground")
        ->type_name("PLACES");
}

}  // namespace

void addErrorOptions(CLI::App& command, ErrorSampleSettings& sample) {
    CLI::Option* count =
        command
            .add_option("--error-sample", sample.receivers,
                        "Receivers that the ray reference recomputes to measure the error; 0: none")
            ->capture_default_str()
            ->check(CLI::Range(0, ErrorSampleSettings::mostReceivers))
            ->type_name("N");
    command
        .add_flag_callback(
            "--no-error-sample", [&sample] { sample.receivers = 0; }, "Do not measure the error")
        ->excludes(count);
}

void addReceiverOptions(CLI::App& command, StudySettings& settings) {
    command.add_option("--cell", settings.receivers.cellM, "Size of a cell, m")
        ->capture_default_str()
        ->check(within(ReceiverSettings::minCellM, ReceiverSettings::maxCellM))
        ->type_name("M");
    command.add_option("--pressure", settings.pressureHPa, "Air pressure for refraction, hPa")
        ->capture_default_str()
        ->check(within(0.0, 1200.0))
        ->type_name("HPA");
    command.add_option("--temperature", settings.temperatureC, "Air temperature for refraction, deg C")
        ->capture_default_str()
        ->check(within(-90.0, 60.0))
        ->type_name("C");
}

void addStudyOptions(CLI::App& command, StudyOptions& options, ReceiverChoice choice) {
    options.read.filesHelp += ", or one project: NAME.noonmark.gpkg";
    addReadOptions(command, options.read);
    command
        .add_option("--scenario", options.scenario,
                    "Scenario of the project to measure (default: the existing city)")
        ->type_name("NAME");
    const std::vector<CLI::Option*> before = command.get_options();
    addPeriodOptions(command, options.period);
    addNamedPeriod(command, before, options.periodName);
    StudySettings& settings = options.settings;
    command
        .add_option(
            "--region", options.region,
            "Where to measure: west,south,east,north in degrees, a polygon file, city: the box around "
            "all buildings, or a region of the project; may be left out with --facades-of NAME, --parcel, "
            "--points and --point: city")
        ->required()
        ->type_name("W,S,E,N|FILE|city|NAME");
    addReceiverOptions(command, settings);
    addPlacesOption(command, options, choice);
    addEngineOptions(command, settings);
    addErrorOptions(command, settings.errorSample);
    command.add_option("--out", options.out, "Folder for the maps, the report and study.json")
        ->required()
        ->type_name("DIR");
    addOverwriteOption(command, options.overwrite);
    command.add_flag("--json", options.json, "Print only study.json to standard output");
}

void addMonthOption(CLI::App& command, StudySettings& settings) {
    command
        .add_option_function<std::string>(
            "--by", [&settings](const std::string&) { settings.byMonth = true; },
            "month: the shadow of each month, as bands and a table (engines horizon, projected)")
        ->check(CLI::IsMember({"month"}))
        ->type_name("SET");
}

void addPieceOptions(CLI::App& command, StudyOptions& options) {
    StudySettings& settings = options.settings;
    addMonthOption(command, settings);
    command.add_flag("--contributions", settings.contributions,
                     "Attributed shadow and sole contribution of each building, as a table, a map and sheets "
                     "(engine horizon)");
    addPictureOption(command, options.pictureWidth);
    command.add_flag("--cells-csv", options.cellsCsv, "Also write cells.csv: one line per receiver");
}

}  // namespace noonmark::cli
