#include "core/engines/api/engine_registry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/describe/field_values.h"

namespace noonmark {

namespace {

Result<void> checkKnown(const EngineInfo& engine, std::string_view key) {
    std::vector<std::string_view> keys;
    for (const Field& option : engine.options) keys.push_back(option.key);
    if (std::ranges::find(keys, key) != keys.end()) return {};
    return failure(fmt::format("The engine '{}' has no option '{}'", engine.key, key), "engine option",
                   keys.empty() ? "Leave it out" : fmt::format("Choose from: {}", fmt::join(keys, ", ")));
}

Result<void> check(const EngineInfo& engine, const EngineSettings& settings) {
    for (const auto& [key, value] : settings)
        if (auto known = checkKnown(engine, key); !known) return known;
    return checkRanges({engine.options, &settings});
}

}  // namespace

const EngineEntry* findEngine(const EngineList& engines, std::string_view key) {
    const auto found =
        std::ranges::find(engines, key, [](const EngineEntry& engine) { return engine.info.key; });
    return found == engines.end() ? nullptr : &*found;
}

Result<std::unique_ptr<Engine>> makeEngine(std::string_view key, const EngineSettings& settings,
                                           const EngineList& engines) {
    if (const EngineEntry* engine = findEngine(engines, key))
        return check(engine->info, settings).and_then([&] { return engine->make(settings); });
    std::vector<std::string_view> keys;
    for (const EngineEntry& engine : engines) keys.push_back(engine.info.key);
    return failure(fmt::format("There is no engine '{}'", key), "engine",
                   fmt::format("Choose one of: {}", fmt::join(keys, ", ")));
}

}  // namespace noonmark
