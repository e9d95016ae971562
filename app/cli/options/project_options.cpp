#include "app/cli/options/project_options.h"

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "app/cli/options/shared_options.h"
#include "app/input/load_city.h"
#include "core/io/read_region.h"
#include "core/receivers/place_names.h"

namespace noonmark::cli {

namespace {

// As typed: "stained-glass" is one word for a shell.
std::optional<PlaceKind> kindFrom(std::string text) {
    for (char& c : text)
        if (c == '-' || c == '_') c = ' ';
    return parsePlaceKind(text);
}

std::string checkKind(const std::string& text) {
    if (kindFrom(text)) return {};
    std::string names;
    for (const PlaceKind kind : placeKinds) names += (names.empty() ? "" : ", ") + std::string(nameOf(kind));
    return "'" + text + "' is not a kind of place: " + names;
}

}  // namespace

bool PlaceOptions::admits(const Place& place) const {
    return (settings.kinds.empty() || settings.kinds.contains(place.kind)) &&
           area(place) >= settings.minAreaM2;
}

std::vector<CommandOption> listOptions(const PlaceOptions& options) {
    const PlaceSettings& settings = options.settings;
    const PlaceSettings plain;
    std::vector<CommandOption> listed;
    for (const std::string& kind : options.kinds) listed.push_back({"--kind", {kind}});
    const bool byKind = settings.kinds.contains(PlaceKind::street);
    if (settings.streets && !byKind) listed.push_back({"--streets", {}});
    if (settings.wholeStreets) listed.push_back({"--whole-streets", {}});
    if (settings.sidewalkM != defaultSidewalkM)
        listed.push_back({"--sidewalks", {fmt::format("{:g}", settings.sidewalkM)}});
    if (!settings.unnamed) listed.push_back({"--named", {}});
    if (settings.minAreaM2 != plain.minAreaM2)
        listed.push_back({"--least-area", {fmt::format("{:g}", settings.minAreaM2)}});
    if (!settings.nameField.empty()) listed.push_back({"--name-field", {settings.nameField}});
    if (settings.kind != plain.kind) listed.push_back({"--as", {std::string(nameOf(settings.kind))}});
    if (!settings.layer.empty()) listed.push_back({"--place-layer", {settings.layer}});
    if (settings.crs) listed.push_back({"--place-crs", {*settings.crs}});
    return listed;
}

void addPlaceOptions(CLI::App& command, PlaceOptions& options) {
    command
        .add_option("--kind", options.kinds,
                    "Only places of this kind: park, playground, ...; may be repeated")
        ->allow_extra_args(false)
        ->check(checkKind)
        ->each([&options](const std::string& text) {
            const auto kind = kindFrom(text);
            if (kind) options.settings.kinds.insert(*kind);
            if (kind == PlaceKind::street) options.settings.streets = true;
        })
        ->type_name("KIND");
    command.add_flag(
        "--streets", options.settings.streets,
        "Streets too: those of OpenStreetMap, or the lines of a layer, as wide as stated or as is usual");
    options.settings.wholeStreets = false;
    command.add_flag("--whole-streets", options.settings.wholeStreets,
                     "Each street as one place, not cut at its junctions");
    command
        .add_option("--sidewalks", options.settings.sidewalkM,
                    "Of streets also strips of this width on both sides of the carriageway, as "
                    "places of their own, m; 0: none")
        ->capture_default_str()
        ->check(within(0, PlaceSettings::maxSidewalkM))
        ->type_name("M");
    command.add_flag_function(
        "--named", [&options](auto) { options.settings.unnamed = false; }, "Only places with a name");
    command.add_option("--least-area", options.settings.minAreaM2, "Only places of at least this area, m2")
        ->check(within(0, 1e9))
        ->type_name("M2");
    command
        .add_option("--name-field", options.settings.nameField,
                    "Field that holds the names (default: name, or another usual one)")
        ->type_name("FIELD");
    command
        .add_option_function<std::string>(
            "--as",
            [&options](const std::string& text) {
                options.settings.kind = kindFrom(text).value_or(PlaceKind::park);
            },
            "Kind of places whose file does not state one (default: park)")
        ->check(checkKind)
        ->type_name("KIND");
    command.add_option("--place-layer", options.settings.layer, "Layer of the file that holds the places")
        ->type_name("LAYER");
    command
        .add_option("--place-crs", options.settings.crs,
                    "Reference system of places whose file states none: EPSG:2263")
        ->type_name("CRS");
}

namespace {

bool looksLikePlace(const std::string& text) {
    std::error_code ignored;
    return text.find_first_of(",(") != std::string::npos || std::filesystem::exists(text, ignored);
}

}  // namespace

Result<Region> regionIn(const Project& project, const City& city, const std::string& text) {
    auto region = findRegion(project, text);
    if (region) return region;
    if (text == "city") return cityRegion(city);
    if (auto place = findPlace(project.places, text)) return regionOf(*place);
    auto drawn = readRegion(text, project.city->frame);
    if (drawn || looksLikePlace(text)) return drawn;
    const auto close = findPlace(project.places, text);
    const std::string advice = project.places.empty() || !close.error().advice.starts_with("Did you mean")
                                   ? region.error().advice
                                   : close.error().advice;
    const std::string alternative = advice.ends_with('?') ? " Otherwise give" : "; or give";
    return failure("There is no such region or place", region.error().where,
                   advice + alternative + " a box, a polygon or a file");
}

void addNamedPeriod(CLI::App& command, const std::vector<CLI::Option*>& before, std::string& name) {
    CLI::Option* named = command.add_option("--period", name, "A period of the project, instead of --start");
    named->type_name("NAME");
    for (CLI::Option* option : command.get_options())
        if (option != named && std::ranges::find(before, option) == before.end()) named->excludes(option);
}

namespace {

/// Of the study that the window saved as its own; none: the window has not saved the project.
std::optional<std::string> zoneOfView(const Project& project) {
    const auto study = project.view.find("study");
    if (study == project.view.end()) return std::nullopt;
    const auto saved = nlohmann::json::parse(study->second, nullptr, false);
    const auto zone = "/period/zone"_json_pointer;
    if (!saved.is_object() || !saved.contains(zone) || !saved.at(zone).is_string()) return std::nullopt;
    return saved.at(zone).get<std::string>();
}

}  // namespace

std::optional<std::string> commonZone(const Project& project) {
    if (project.periods.empty()) return zoneOfView(project);
    std::set<std::string> zones;
    for (const NamedPeriod& period : project.periods) zones.insert(period.period.zone);
    return zones.size() == 1 ? std::optional(*zones.begin()) : std::nullopt;
}

Result<Period> periodIn(const Project& project, const std::string& name, const PeriodOptions& options) {
    if (!name.empty())
        return findPeriod(project, name).map([](const NamedPeriod& named) { return named.period; });
    if (options.states("--start")) return periodFrom(options);
    return failure("The period is missing", "period", "Give --start DATE, or --period NAME of the project");
}

}  // namespace noonmark::cli
