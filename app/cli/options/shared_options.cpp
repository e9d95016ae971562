#include "app/cli/options/shared_options.h"

#include <fmt/format.h>
#include <cmath>
#include <sstream>

#include "app/cli/options/field_options.h"
#include "app/report/maps/style.h"
#include "core/describe/command_options.h"
#include "core/io/settings/read_settings.h"

namespace noonmark::cli {

CLI::Validator within(double lowest, double highest) {
    const auto check = [=](const std::string& text) -> std::string {
        double number = 0;
        if (CLI::detail::lexical_cast(text, number) && number >= lowest && number <= highest) return {};
        return fmt::format("{} is out of range: give {:g} to {:g}", text, lowest, highest);
    };
    return {check, fmt::format("{:g} to {:g}", lowest, highest)};
}

Result<LonLat> parseLonLat(const std::string& text, std::optional<double>* heightM) {
    LonLat place{};
    char comma = 0;
    std::istringstream stream(text);
    bool read = bool(stream >> place.lonDeg >> comma >> place.latDeg) && comma == ',';
    if (read && heightM != nullptr && stream.peek() == ',') {
        double height = 0;
        read = bool(stream >> comma >> height);
        *heightM = height;
    }
    if (read && (stream >> std::ws).eof() && std::abs(place.lonDeg) <= 180 && std::abs(place.latDeg) <= 90)
        return place;
    return failure(
        "This is no position", text,
        heightM == nullptr
            ? "Give LON,LAT in degrees: -73.98,40.75"
            : "Give LON,LAT in degrees, or LON,LAT,H with metres above the ground: -73.98,40.75,4.5");
}

CLI::Option* addLonLatOption(CLI::App& command, const std::string& name, std::optional<LonLat>& place,
                             const std::string& about) {
    return command
        .add_option_function<std::string>(
            name,
            [name, &place](const std::string& text) {
                const auto parsed = parseLonLat(text);
                if (!parsed) throw CLI::ValidationError(name, parsed.error().text());
                place = *parsed;
            },
            about)
        ->type_name("LON,LAT");
}

void addOverwriteOption(CLI::App& command, bool& overwrite) {
    command.add_flag(flags::overwrite, overwrite,
                     "Replace existing outputs, but never an input, a project or a file of another kind");
}

void addProjectCopyOption(CLI::App& command, bool& withProject) {
    command.add_flag("--with-project", withProject,
                     "Also put a copy of the project into the folder, so that `verify` finds it");
}

void addPictureOption(CLI::App& command, int& widthPx) {
    command
        .add_option("--picture-width", widthPx,
                    "Width of the PNG in pixels; its text grows with it, its height follows the region")
        ->capture_default_str()
        ->check(within(minPictureWidth, maxPictureWidth))
        ->type_name("PX");
}

void addLegendOptions(CLI::App& command, LegendChoice& legend) {
    addFieldOptions(command, legendFields().of(legend));
}

std::vector<std::string> listNamedFiles(const ReadOptions& options) {
    std::vector<std::string> files = options.files;
    files.insert(files.end(), options.settings.treeFiles.begin(), options.settings.treeFiles.end());
    return files;
}

void addReadOptions(CLI::App& command, ReadOptions& options) {
    command.add_option("files", options.files, options.filesHelp)->required()->type_name("FILE");
    addFieldOptions(command, readSettingsFields().of(options.settings));
}

}  // namespace noonmark::cli
