#include "app/cli/options/engine_options.h"

#include <charconv>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace noonmark::cli {

namespace {

std::optional<std::pair<std::string, double>> settingFrom(const std::string& text) {
    const auto equals = text.find('=');
    if (equals == 0 || equals == std::string::npos) return std::nullopt;
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data() + equals + 1, end, value);
    if (error != std::errc{} || rest != end) return std::nullopt;
    return std::pair{text.substr(0, equals), value};
}

CLI::Validator engineSetting() {
    return CLI::Validator(
        [](std::string& text) {
            return settingFrom(text) ? std::string() : text + " is not NAME=NUMBER, for example levels=4";
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
            "An option of the engine, for example levels=4; may be repeated")
        ->check(engineSetting())
        ->type_name("NAME=NUMBER");
}

}  // namespace noonmark::cli
