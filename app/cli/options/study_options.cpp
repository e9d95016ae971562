#include "app/cli/options/study_options.h"

#include <string>
#include <vector>

#include "app/cli/base/command.h"
#include "app/cli/options/field_options.h"
#include "app/cli/options/overwrite_option.h"
#include "app/cli/options/picture_option.h"
#include "app/cli/options/project_question.h"
#include "core/describe/command_flags.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/study_fields.h"

namespace noonmark::cli {

namespace {

void takeReceivers(const std::string& name, StudyOptions& options) {
    const auto cells = findChoice<ReceiverPlaces>(receiverPlaceChoices, name);
    if (cells) options.settings.receivers.places = *cells;
    options.points = findChoice<ElementPlaces>(elementPlaceChoices, name);
    if (options.points) options.elements.places = *options.points;
}

void addPlacesOption(CLI::App& command, StudyOptions& options, ReceiverChoice choice) {
    std::vector<std::string> names;
    for (const auto& place : receiverPlaceChoices) names.emplace_back(place.key);
    std::string help(surfaceFields().rows().front().help);
    if (choice == ReceiverChoice::cellsAndPoints) {
        for (const auto& place : elementPlaceChoices) names.emplace_back(place.key);
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
    addFieldOptions(command, sampleFields().of(sample));
    command
        .add_flag_callback(
            "--no-error-sample", [&sample] { sample.receivers = 0; }, "Do not measure the error")
        ->excludes("--error-sample");
}

void addCellOptions(CLI::App& command, StudySettings& settings) {
    addFieldOptions(command, cellFields().of(settings));
    addFieldOptions(command, airFields().of(settings));
}

void addEngineOptions(CLI::App& command, StudySettings& settings) {
    addFieldOptions(command, engineFields().of(settings));
}

void addStudyOptions(CLI::App& command, StudyOptions& options, ReceiverChoice choice) {
    options.read.filesHelp += ", or one project: NAME.noonmark.gpkg";
    addReadOptions(command, options.read);
    command
        .add_option(flags::scenario, options.scenario,
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
    addCellOptions(command, settings);
    addPlacesOption(command, options, choice);
    addEngineOptions(command, settings);
    addErrorOptions(command, settings.errorSample);
    command.add_option(flags::out, options.out, "Folder for the maps, the report and study.json")
        ->required()
        ->type_name("DIR");
    addOverwriteOption(command, options.overwrite);
    addJsonFlag(command, options.json, "Print only study.json to standard output");
}

void addMonthOption(CLI::App& command, StudySettings& settings) {
    addFieldOptions(command, monthFields().of(settings));
}

void addPieceOptions(CLI::App& command, StudyOptions& options) {
    StudySettings& settings = options.settings;
    addMonthOption(command, settings);
    addFieldOptions(command, contributionFields().of(settings));
    addFieldOptions(command, treeFields().of(settings));
    addPictureOption(command, options.pictureWidth);
    addProjectCopyOption(command, options.withProject);
    command.add_flag("--cells-csv", options.cellsCsv, "Also write cells.csv: one line per receiver");
}

}  // namespace noonmark::cli
