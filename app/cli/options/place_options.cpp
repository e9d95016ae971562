#include "app/cli/options/place_options.h"

#include <fmt/format.h>

#include "app/cli/options/number_range.h"
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
    command.add_flag("--streets", options.settings.streets,
                     "OpenStreetMap: streets too, as wide as tagged or as is usual for their class");
    options.settings.wholeStreets = false;
    command.add_flag("--whole-streets", options.settings.wholeStreets,
                     "OpenStreetMap: each street as one place, not cut at its junctions");
    command
        .add_option(
            "--sidewalks", options.settings.sidewalkM,
            "OpenStreetMap: of streets also strips of this width on both sides of the carriageway, as "
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

}  // namespace noonmark::cli
