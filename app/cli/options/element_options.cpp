#include <fmt/format.h>

#include <tuple>

#include "app/cli/options/field_options.h"
#include "app/cli/options/study_options.h"
#include "core/study/elements/element_fields.h"

namespace noonmark::cli {

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
