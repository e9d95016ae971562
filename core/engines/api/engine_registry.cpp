#include "core/engines/api/engine_registry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace noonmark {

namespace {

std::string rangeOf(const EngineOption& option) {
    if (option.kind == OptionKind::yesNo) return "yes or no";
    return fmt::format("{:g} to {:g}{}{}{}", option.min, option.max, option.unit.empty() ? "" : " ",
                       option.unit, option.kind == OptionKind::wholeNumber ? ", whole numbers" : "");
}

Result<void> check(const EngineOption& option, double value) {
    const bool inRange = value >= option.min && value <= option.max;  // false for NaN
    if (inRange && (option.kind == OptionKind::number || value == std::floor(value))) return {};
    return failure(fmt::format("{:g} is out of range for {}", value, option.key), "engine option",
                   fmt::format("Choose {}", rangeOf(option)));
}

Result<void> checkKnown(const EngineInfo& engine, std::string_view key) {
    std::vector<std::string_view> keys;
    for (const EngineOption& option : engine.options) keys.push_back(option.key);
    if (std::ranges::find(keys, key) != keys.end()) return {};
    return failure(fmt::format("The engine '{}' has no option '{}'", engine.key, key), "engine option",
                   keys.empty() ? "Leave it out" : fmt::format("Choose from: {}", fmt::join(keys, ", ")));
}

Result<EngineSettings> complete(const EngineInfo& engine, EngineSettings settings) {
    for (const auto& [key, value] : settings)
        if (const auto known = checkKnown(engine, key); !known) return tl::make_unexpected(known.error());
    for (const EngineOption& option : engine.options) {
        const auto [place, added] = settings.try_emplace(std::string(option.key), option.standard);
        if (const auto fits = check(option, place->second); !fits) return tl::make_unexpected(fits.error());
    }
    return settings;
}

}  // namespace

std::string formatOptionValue(const EngineOption& option, double value) {
    if (option.kind == OptionKind::yesNo) return value != 0 ? "yes" : "no";
    return fmt::format("{:g}", value);
}

const EngineEntry* findEngine(const EngineList& engines, std::string_view key) {
    const auto found =
        std::ranges::find(engines, key, [](const EngineEntry& engine) { return engine.info.key; });
    return found == engines.end() ? nullptr : &*found;
}

Result<std::unique_ptr<Engine>> makeEngine(std::string_view key, const EngineSettings& settings,
                                           const EngineList& engines) {
    if (const EngineEntry* engine = findEngine(engines, key))
        return complete(engine->info, settings).and_then(engine->make);
    std::vector<std::string_view> keys;
    for (const EngineEntry& engine : engines) keys.push_back(engine.info.key);
    return failure(fmt::format("There is no engine '{}'", key), "engine",
                   fmt::format("Choose one of: {}", fmt::join(keys, ", ")));
}

}  // namespace noonmark
