#include "app/cli/options/study_options.h"

#include <fmt/format.h>
#include <tuple>
#include <vector>

#include "app/cli/base/command.h"
#include "app/cli/options/field_options.h"
#include "app/cli/options/project_options.h"
#include "core/receivers/roof_receivers.h"
#include "core/study/elements/element_fields.h"
#include "core/study/study_fields.h"
#include "core/sun/period_fields.h"

namespace noonmark::cli {

CLI::Option* addPeriodOptions(CLI::App& command, PeriodOptions& options) {
    addFieldOptions(command, periodFields().of(options.period),
                    {.names = options.names, .given = &options.given});
    return command.get_option("--start");
}

Result<Period> periodFrom(const PeriodOptions& options) {
    // With hours of the sun the zone only says where a date begins.
    if (!options.states("--zone") && !options.period.window)
        return failure("The hours need a time zone", "period",
                       "Give --zone, for example --zone America/New_York");
    return Zone::named(options.period.zone).and_then([&](const Zone& zone) {
        Period period = options.period;
        period.zone = zone.name();
        return validate(period);
    });
}

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

namespace {

/// Named buildings have places of their own: the region may be left out, and is the city then.
void makeRegionOptional(CLI::App& command, StudyOptions& options) {
    command.get_option("--region")->required(false);
    if (options.region.empty()) options.region = "city";
}

void addFacadeOptions(CLI::App& command, StudyOptions& options) {
    addFieldOptions(command, facadesOfFields().of(options.elements));
    command.get_option("--facades-of")->each([&command, &options](const std::string& name) {
        if (name != allFacades) makeRegionOptional(command, options);
    });
    addFieldOptions(command, facadeFields().of(options.elements));
    addFieldOptions(command, aboveFloorFields().of(options.elements));
}

void addLineOptions(CLI::App& command, StudyOptions& options) {
    addFieldOptions(command, lineFields().of(options.elements));
    command.get_option("--parcel")->each([&command, &options](const std::string&) {
        makeRegionOptional(command, options);
    });
}

void addListOptions(CLI::App& command, StudyOptions& options) {
    addFieldOptions(command, pointsFileFields().of(options.elements));
    CLI::Option* file = command.get_option("--points");
    file->each([&command, &options](const std::string&) { makeRegionOptional(command, options); });
    addFieldOptions(command, pointFields().of(options.elements));
    command.get_option("--point")->excludes(file)->each(
        [&command, &options](const std::string&) { makeRegionOptional(command, options); });
}

Result<void> checkBelongs(bool given, const StudyOptions& options, ElementPlaces places, const char* option) {
    if (!given || options.points == places) return {};
    return failure(fmt::format("{} needs --receivers {}", option, nameOf(places)), option,
                   fmt::format("Add --receivers {}, or omit {}", nameOf(places), option));
}

}  // namespace

void addGlazingFileOptions(CLI::App& command, ElementSettings& elements) {
    addFieldOptions(command, glazingFields().of(elements));
    addFieldOptions(command, glazingFileFields().of(elements.glazingFile));
}

void addFaceOptions(CLI::App& command, FaceChoice& faces) {
    addFieldOptions(command, faceFields().of(faces));
}

void addElementOptions(CLI::App& command, StudyOptions& options) {
    addFacadeOptions(command, options);
    addFaceOptions(command, options.elements.faces);
    addGlazingFileOptions(command, options.elements);
    addLineOptions(command, options);
    addListOptions(command, options);
    addFieldOptions(command, planeFields().of(options.elements));
}

Result<void> checkElementOptions(const StudyOptions& options) {
    const ElementSettings& elements = options.elements;
    const bool facades = !elements.buildings.empty() || elements.proposed || !elements.faces.faces.empty();
    const bool plane = elements.planeHeightM > 0 && options.points != ElementPlaces::lines;
    const bool listed = !elements.points.empty() || !elements.pointsFile.empty();
    for (const auto& [given, places, option] :
         {std::tuple{facades, ElementPlaces::facades, "--facades-of or --face"},
          {!elements.windows.empty(), ElementPlaces::windows, "--windows"},
          {plane, ElementPlaces::plane, "--plane-height"},
          {!elements.parcel.empty(), ElementPlaces::lines, "--parcel"},
          {listed, ElementPlaces::points, "--points or --point"}})
        if (auto ok = checkBelongs(given, options, places, option); !ok) return ok;
    const bool onWalls = options.points == ElementPlaces::facades || options.points == ElementPlaces::windows;
    if (!elements.faces.takesAll() && !onWalls)
        return failure("--facing and --facing-place are about facades and windows", "--facing",
                       "Add --receivers facades or windows, or omit them");
    if (!options.points) return {};
    if (options.points == ElementPlaces::lines && elements.parcel.empty())
        return failure("The parcel is missing", "--receivers lines", "Give --parcel FILE, or a lot's name");
    if (options.points == ElementPlaces::points && !listed)
        return failure("The points are missing", "--receivers points",
                       "Give --points FILE.csv or --point LON,LAT[,H[,FACING]]");
    if (options.points == ElementPlaces::windows && elements.windows.empty())
        return failure("The windows are missing", "--receivers windows", "Give --windows FILE");
    if (options.settings.contributions || options.cellsCsv)
        return unsupported("Contributions and cells.csv are of cells, not of points", "--receivers",
                           "Omit --contributions and --cells-csv");
    return {};
}

}  // namespace noonmark::cli
