#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/cli/base/command.h"
#include "app/cli/base/terminal_text.h"
#include "app/cli/study/study_request.h"
#include "app/input/load_project.h"
#include "core/base/safe_text.h"
#include "core/io/footprints/footprint_scan.h"
#include "core/study/provenance/command_text.h"
#include "core/study/text/error_text.h"
#include "core/study/text/height_facts_text.h"
#include "core/study/text/terrain_text.h"

namespace noonmark::cli {

namespace {

struct InfoOptions {
    ReadOptions read;
    bool fields = false;
    bool json = false;
};

std::string describeRange(const nlohmann::ordered_json& range) {
    return fmt::format("{:.1f} to {:.1f} m", range[0].get<double>(), range[1].get<double>());
}

// "88 mesh (2.8 to 16.1 m)"
std::string describeSources(const nlohmann::ordered_json& info) {
    std::string text;
    for (const auto& [name, count] : info["height_sources"].items()) {
        if (count == 0) continue;
        text += fmt::format("{}{} {} ({})", text.empty() ? "" : ", ", withCommas(count.get<std::size_t>()),
                            name, describeRange(info["height_ranges_m"][name]));
    }
    return text.empty() ? "none" : text;
}

// "31.7 m  Town hall": from the lowest ground under the building. Parts that stand higher are less high.
std::string describeTallest(const nlohmann::ordered_json& info) {
    const auto tallestM = info["tallest_m"].get<double>();
    double partM = 0;
    for (const auto& range : info["height_ranges_m"]) partM = std::max(partM, range[1].get<double>());
    const bool isApart = std::abs(partM - tallestM) >= 0.1;
    return fmt::format("{:.1f} m  {}{}", tallestM, info["tallest"].get<std::string>(),
                       isApart
                           ? fmt::format(" (from its lowest ground; the highest part has {:.1f} m)", partM)
                           : std::string());
}

nlohmann::ordered_json nextStepsJson(const std::vector<NextStep>& steps) {
    auto json = nlohmann::ordered_json::array();
    for (const NextStep& step : steps) json.push_back({{"why", step.why}, {"command", step.command}});
    return json;
}

void printNextSteps(const std::vector<NextStep>& steps, std::ostream& out) {
    if (!steps.empty()) out << "\nNext\n";
    for (const NextStep& step : steps) out << "  " << step.command << "\n      " << step.why << '\n';
}

// Warns of assumed heights and names the fields that may hold heights.
void printHeights(std::ostream& out, const CityRead& read) {
    for (const GeometryHeadline& headline : listGeometryHeadlines(read.city, read.heights))
        out << "\n" << headline.text << '\n';
    if (read.heights.unknown.empty()) return;
    out << "fields that may hold heights or storeys; select one with:\n";
    for (const UnknownField& field : read.heights.unknown)
        out << "  " << selectingOptions(field) << ": " << describe(field) << '\n';
}

// The layers with polygons of the files that have several, and which of them were read. A file whose layers
// cannot be listed holds one city and no layers.
nlohmann::ordered_json layersJson(const ReadOptions& options) {
    auto json = nlohmann::ordered_json::array();
    const std::string& chosen = options.settings.layer;
    for (const std::string& file : options.files) {
        const auto layers = listLayers(file, {});
        if (!layers || layers->size() < 2 || isProjectFile(file)) continue;
        for (const ListedLayer& layer : *layers)
            json.push_back({{"file", file},
                            {"layer", layer.name},
                            {"features", layer.features},
                            {"read", chosen.empty() ? layer.isRead
                                                    : CLI::detail::to_lower(layer.name) ==
                                                          CLI::detail::to_lower(chosen)}});
    }
    return json;
}

// "buildings (144); not read: plots (407)".
std::string describeLayers(const nlohmann::ordered_json& layers) {
    std::vector<std::string> read, others;
    for (const auto& layer : layers)
        (layer["read"].get<bool>() ? read : others)
            .push_back(fmt::format("{} ({})", layer["layer"].get<std::string>(),
                                   withCommas(layer["features"].get<std::size_t>())));
    return fmt::format("{}{}{}", fmt::join(read, ", "),
                       others.empty() ? "" : "; not read: ", fmt::join(others, ", "));
}

nlohmann::ordered_json describeCity(const CityRead& read, const ReadOptions& options) {
    auto info = nlohmann::ordered_json::parse(infoJson(read));
    info["layers"] = layersJson(options);
    return info;
}

// Prints the figures of the JSON as text.
void print(const CityRead& read, const nlohmann::ordered_json& info, std::ostream& out) {
    const auto number = [&](const char* key) { return withCommas(info[key].get<std::size_t>()); };
    Table table;
    table.add("format", read.format);
    if (!info["layers"].empty()) table.add("layers", describeLayers(info["layers"]));
    table.add("features", number("features"));
    table.add("buildings", number("buildings"));
    table.add("parts", fmt::format("{} ({} overhanging)", number("parts"), number("parts_hanging")));
    table.add("triangles", number("triangles"));
    table.add("heights of parts", describeSources(info));
    const bool several = std::ranges::any_of(read.heights.fields, [&](const HeightField& field) {
        return field.file != read.heights.fields.front().file;
    });
    for (const HeightField& field : read.heights.fields)
        table.add("heights from", (several ? field.file + ": " : "") + describe(field));
    for (const BaseFit& fit : read.heights.bases) table.add("bases", describe(fit));
    table.add("tallest", describeTallest(info));
    if (const auto& ground = info["ground_m"]; !ground.is_null())
        table.add("ground", describeRange(ground) + " above the datum, under the buildings");
    table.add("terrain", read.city.terrain ? formatText(*read.city.terrain) : "none: flat ground");
    if (const auto& range = info["terrain_m"]; !range.is_null())
        table.add("elevations", describeRange(range) + " above the datum, of the terrain");
    if (!read.crs.empty()) table.add("coordinates", read.crs);
    if (const auto& town = info["nearest_town"]; !town.is_null())
        table.add("place", fmt::format("{:.1f} km from {}, {}", town["away_m"].get<double>() / 1000,
                                       town["name"].get<std::string>(), town["country"].get<std::string>()));
    if (const auto& box = info["extent_lonlat"]; !box.is_null())
        table.add("extent",
                  fmt::format("{:.5f},{:.5f},{:.5f},{:.5f} (west,south,east,north)", box[0].get<double>(),
                              box[1].get<double>(), box[2].get<double>(), box[3].get<double>()));
    if (read.city.trees) table.add("trees", describeTrees(*read.city.trees));
    if (!read.attribution.empty()) table.add("data", read.attribution);
    table.add("changed", describeChanges(read.warnings));
    table.print(out);
    printHeights(out, read);
    printWarnings(out, read.warnings);
}

void printProjectAdvice(const std::string& file, std::ostream& out) {
    if (isProjectFile(file))
        out << "\n"
               "Other contents of the project: noonmark-cli project info "
            << file << '\n';
}

struct FileFields {
    std::string file;
    std::vector<ListedLayer> layers;
};

Result<std::vector<FileFields>> listFieldsOf(const std::vector<std::string>& files) {
    std::vector<FileFields> all;
    for (const std::string& file : files) {
        auto layers = listLayers(file, {});
        if (!layers) return tl::make_unexpected(layers.error());
        all.push_back({file, *std::move(layers)});
    }
    return all;
}

nlohmann::ordered_json fieldJson(const ListedField& field) {
    nlohmann::ordered_json json{{"name", field.name}, {"values", field.values}, {"samples", field.samples}};
    if (!field.alias.empty()) json["alias"] = field.alias;
    if (field.low) json["range"] = {*field.low, *field.high};
    if (const auto role = nameOfRole(field.role); !role.empty()) json["taken_for"] = role;
    return json;
}

nlohmann::ordered_json fieldsJsonOf(const std::vector<FileFields>& files) {
    auto json = nlohmann::ordered_json::array();
    for (const auto& [file, layers] : files)
        for (const ListedLayer& layer : layers) {
            auto fields = nlohmann::ordered_json::array();
            for (const ListedField& field : layer.fields) fields.push_back(fieldJson(field));
            json.push_back({{"file", file},
                            {"layer", layer.name},
                            {"features", layer.features},
                            {"sampled", layer.sampled},
                            {"holds_buildings", layer.isRead},
                            {"fields", fields}});
        }
    return {{"layers", json}};
}

void printFields(const FileFields& file, std::ostream& out) {
    if (file.layers.empty()) out << file.file << ": no layers with fields to choose from\n";
    for (const ListedLayer& layer : file.layers) {
        out << fmt::format("{}: layer {}, {}{}\n", file.file, layer.name, countOf(layer.features, "feature"),
                           layer.isRead ? "" : ", not read");
        for (const ListedField& field : layer.fields) {
            const std::string_view role = nameOfRole(field.role);
            out << fmt::format("  {}{}: {}\n", field.name, role.empty() ? "" : fmt::format(" [{}]", role),
                               describeValues(field, layer.sampled));
        }
    }
}

int runInfoFields(const InfoOptions& options, const Console& console) {
    const auto files = listFieldsOf(options.read.files);
    if (!files) return fail(console, files.error(), exitUsage);
    if (options.json)
        console.out << toJsonText(fieldsJsonOf(*files)) << '\n';
    else
        for (const FileFields& file : *files) printFields(file, console.out);
    return exitOk;
}

int runInfo(const InfoOptions& options, const Console& console) {
    if (options.fields) return runInfoFields(options, console);
    const auto loaded = loadCity(options.read, console);
    if (!loaded) return fail(console, loaded.error(), exitUsage);
    const bool isProject = namesProject(options.read);
    const auto steps = isProject ? std::vector<NextStep>()
                                 : listNextSteps(loaded->read, options.read.files, options.read.settings);
    auto info = describeCity(loaded->read, options.read);
    if (options.json) {
        info["next"] = nextStepsJson(steps);
        console.out << toJsonText(info) << '\n';
    } else {
        print(loaded->read, info, console.out);
        printNextSteps(steps, console.out);
        printProjectAdvice(options.read.files.front(), console.out);
    }
    return exitOk;
}

}  // namespace

void addInfoCommand(CLI::App& app, Run& run) {
    const auto options = std::make_shared<InfoOptions>();
    CLI::App* command =
        app.add_subcommand("info", "Describe the contents of city files, and what was repaired or left out");
    addReadOptions(*command, options->read);
    command->add_flag("--fields", options->fields,
                      "List the layers of the files and their fields with sample values instead, to choose "
                      "one with --height-field, --levels-field or --building-name-field");
    addJsonFlag(*command, options->json);
    command->callback(
        [options, &run] { run = [options](const Console& console) { return runInfo(*options, console); }; });
}

}  // namespace noonmark::cli
