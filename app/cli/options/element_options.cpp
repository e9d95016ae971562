#include <fmt/format.h>

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

void addFacadeOptions(CLI::App& command, StudyOptions& options) {
    ElementSettings& elements = options.elements;
    command
        .add_option_function<std::vector<std::string>>(
            "--facades-of",
            [&command, &options](const std::vector<std::string>& names) {
                if (names.size() == 1 && names.front() == "all") return;
                options.elements.buildings = names;
                makeRegionOptional(command, options);
            },
            "Facades: buildings of the region by name or id (default: all, those whose middle is in the "
            "region); may be repeated")
        ->allow_extra_args(false)
        ->type_name("NAME,...|all");
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

void addElementOptions(CLI::App& command, StudyOptions& options) {
    addFacadeOptions(command, options);
    addWindowFileOptions(command, options.elements);
    command
        .add_option("--plane-height", options.elements.planeHeightM,
                    "Plane: its height above the mean of the region's ground")
        ->check(within(0.0, mostPlaneHeightM))
        ->type_name("M");
}

Result<void> checkElementOptions(const StudyOptions& options) {
    const ElementSettings& elements = options.elements;
    if (auto ok = checkBelongs(!elements.buildings.empty(), options, ElementPlaces::facades, "--facades-of");
        !ok)
        return ok;
    if (auto ok = checkBelongs(!elements.windows.empty(), options, ElementPlaces::windows, "--windows"); !ok)
        return ok;
    if (auto ok = checkBelongs(elements.planeHeightM > 0, options, ElementPlaces::plane, "--plane-height");
        !ok)
        return ok;
    if (!options.points) return {};
    if (options.points == ElementPlaces::windows && elements.windows.empty())
        return failure("The windows are missing", "--receivers windows", "Give --windows FILE");
    if (options.settings.contributions || options.cellsCsv)
        return unsupported("Contributions and cells.csv are of cells, not of points", "--receivers",
                           "Omit --contributions and --cells-csv");
    return {};
}

}  // namespace noonmark::cli
