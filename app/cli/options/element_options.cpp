#include <fmt/format.h>

#include <tuple>

#include "app/cli/options/number_range.h"
#include "app/cli/options/study_options.h"
#include "core/receivers/points/plane_points.h"

namespace noonmark::cli {

namespace {

/// Named buildings have places of their own: the region may be left out, and is the city then.
void makeRegionOptional(CLI::App& command, StudyOptions& options) {
    command.get_option("--region")->required(false);
    if (options.region.empty()) options.region = "city";
}

void takePoints(const std::vector<std::string>& texts, ElementSettings& elements) {
    for (const std::string& text : texts) {
        auto point = parsePoint(text);
        if (!point) throw CLI::ValidationError("--point", point.error().what + ". " + point.error().advice);
        point->id = fmt::format("point {}", elements.points.size() + 1);
        elements.points.push_back(*std::move(point));
    }
}

void addFacadeOptions(CLI::App& command, StudyOptions& options) {
    ElementSettings& elements = options.elements;
    command
        .add_option_function<std::vector<std::string>>(
            "--facades-of",
            [&command, &options](const std::vector<std::string>& names) {
                if (names.size() == 1 && names.front() == "all") return;
                options.elements.proposed = names.size() == 1 && names.front() == "proposed";
                if (!options.elements.proposed) options.elements.buildings = names;
                makeRegionOptional(command, options);
            },
            "Facades: buildings of the region by name or id (default: all, those whose middle is in the "
            "region), or those that a scenario of a project builds or changes; may be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME,...|all|proposed");
    const auto addMetres = [&](const char* name, double& value, const char* help, double from, double to) {
        command.add_option(name, value, help)->capture_default_str()->check(within(from, to))->type_name("M");
    };
    FacadeSettings& facades = elements.facades;
    addMetres("--bay", facades.bayM, "Facades: width of a bay, one point each", FacadeSettings::leastM,
              FacadeSettings::mostM);
    addMetres("--storey", facades.storeyM,
              "Height of a storey: facades have one point each, windows are numbered by it",
              FacadeSettings::leastM, FacadeSettings::mostM);
    addMetres("--above-floor", facades.aboveFloorM, "Facades: height of the points above the floor", 0, 50);
}

void addLineOptions(CLI::App& command, StudyOptions& options) {
    ElementSettings& elements = options.elements;
    command
        .add_option_function<std::string>(
            "--parcel",
            [&command, &options](const std::string& text) {
                options.elements.parcel = text;
                makeRegionOptional(command, options);
            },
            "Lines: the parcel, a polygon file or a lot, region or place of the project")
        ->type_name("FILE|NAME");
    command
        .add_option("--offsets", elements.lines.offsetsM,
                    "Lines: their distances from the parcel, with commas")
        ->delimiter(',')
        ->check(within(LineSettings::leastOffsetM, LineSettings::mostOffsetM))
        ->default_str("5,10")
        ->type_name("M,...");
    command.add_option("--spacing", elements.lines.spacingM, "Lines: distance from point to point")
        ->capture_default_str()
        ->check(within(LineSettings::leastSpacingM, LineSettings::mostSpacingM))
        ->type_name("M");
}

void addListOptions(CLI::App& command, StudyOptions& options) {
    CLI::Option* file = command
                            .add_option_function<std::string>(
                                "--points",
                                [&command, &options](const std::string& name) {
                                    options.elements.pointsFile = name;
                                    makeRegionOptional(command, options);
                                },
                                "Points: a CSV file with columns lon, lat and, if known, id, height (metres "
                                "above the ground) "
                                "and facing (azimuth of a wall)")
                            ->type_name("FILE.csv");
    command
        .add_option_function<std::vector<std::string>>(
            "--point",
            [&command, &options](const std::vector<std::string>& texts) {
                takePoints(texts, options.elements);
                makeRegionOptional(command, options);
            },
            "Points: one point; may be repeated")
        ->allow_extra_args(false)
        ->excludes(file)
        ->type_name("LON,LAT[,H[,FACING]]");
}

Result<void> checkBelongs(bool given, const StudyOptions& options, ElementPlaces places, const char* option) {
    if (!given || options.points == places) return {};
    return failure(fmt::format("{} needs --receivers {}", option, nameOf(places)), option,
                   fmt::format("Add --receivers {}, or omit {}", nameOf(places), option));
}

}  // namespace

void addWindowFileOptions(CLI::App& command, ElementSettings& elements) {
    command
        .add_option_function<std::string>(
            "--windows", [&elements](const std::string& file) { elements.windows = file; },
            "Windows: a file of points or polygons with heights (fields id, azimuth, floor)")
        ->type_name("FILE");
    command
        .add_option("--window-id", elements.windowFile.idField,
                    "Windows: the field with their ids (default: id, window, window_id, name)")
        ->type_name("FIELD");
    command
        .add_option("--windows-crs", elements.windowFile.crs,
                    "Windows: coordinate reference system, if the file states none")
        ->type_name("CRS");
    command
        .add_option_function<std::string>(
            "--window-heights",
            [&elements](const std::string& what) { elements.windowFile.aboveGround = what == "ground"; },
            "Windows: heights are elevations, as those of the city, or metres above the ground below")
        ->check(CLI::IsMember({"elevation", "ground"}))
        ->default_str("elevation")
        ->type_name("WHAT");
}

void addFaceOptions(CLI::App& command, FaceChoice& faces) {
    command
        .add_option(
            "--face", faces.faces,
            "Facades: one face by the beginning of its points' ids, \"way 12 wall 3\"; may be repeated")
        ->allow_extra_args(false)
        ->type_name("ID");
    command
        .add_option_function<std::string>(
            "--facing",
            [&faces](const std::string& text) {
                const auto range = parseAzimuthRange(text);
                if (!range)
                    throw CLI::ValidationError("--facing", range.error().what + ". " + range.error().advice);
                faces.facing = *range;
            },
            "Facades and windows: only those that face these azimuths, degrees from true north, clockwise")
        ->type_name("FROM-TO");
    CLI::Option* place =
        command
            .add_option("--facing-place", faces.place,
                        "Facades and windows: only those from which a level line straight out from the wall "
                        "meets this place")
            ->type_name("NAME");
    command.add_option("--within", faces.withinM, "With --facing-place: at most this far away")
        ->capture_default_str()
        ->check(within(1.0, FaceChoice::mostWithinM))
        ->needs(place)
        ->type_name("M");
}

void addElementOptions(CLI::App& command, StudyOptions& options) {
    addFacadeOptions(command, options);
    addFaceOptions(command, options.elements.faces);
    addWindowFileOptions(command, options.elements);
    addLineOptions(command, options);
    addListOptions(command, options);
    command
        .add_option("--plane-height", options.elements.planeHeightM,
                    "Plane and lines: height above the mean of the ground, of the region or parcel")
        ->check(within(0.0, mostPlaneHeightM))
        ->type_name("M");
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
