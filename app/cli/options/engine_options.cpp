#include "app/cli/options/engine_options.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace noonmark::cli {

namespace {

std::optional<std::pair<std::string, double>> settingFrom(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == 0 || equals == std::string::npos) return std::nullopt;
    const auto value = parseOptionValue(std::string_view(text).substr(equals + 1));
    if (!value) return std::nullopt;
    return std::pair{text.substr(0, equals), *value};
}

CLI::Validator engineSetting() {
    return CLI::Validator(
        [](std::string& text) {
            return settingFrom(text) ? std::string()
                                     : text + " is not NAME=VALUE, like levels=4 or check=yes";
        },
        "");
}

}  // namespace

void addEngineOptions(CLI::App& command, StudySettings& settings) {
    command.add_option("--engine", settings.engine, "Engine to compute with: see noonmark-cli engines")
        ->capture_default_str()
        ->type_name("ENGINE");
    command
        .add_option_function<std::vector<std::string>>(
            "--option",
            [&settings](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) settings.engineSettings.insert(*settingFrom(text));
            },
            "A setting of the engine: levels=4, check=yes; may be repeated")
        ->check(engineSetting())
        ->type_name("NAME=VALUE");
}

}  // namespace noonmark::cli
