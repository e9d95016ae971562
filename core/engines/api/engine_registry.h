#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/engines/api/engine.h"

namespace noonmark {

/// A numeric setting of an engine that the user can change.
struct EngineOption {
    std::string_view key;   ///< for --option, study.json and the project file: "levels"
    std::string_view name;  ///< shown in the window: "Source levels"
    std::string_view unit;  ///< "deg", "min", "m"; empty for a count
    double lowest = 0;
    double highest = 1;
    double usual = 0;        ///< default value
    bool whole = false;      ///< accepts whole numbers only
    std::string_view about;  ///< one-line tooltip
};

/// Values by option key; a missing key means the option's default.
using EngineSettings = std::map<std::string, double, std::less<>>;

/// Description of an engine, shown where the user chooses one.
struct EngineInfo {
    std::string_view key;    ///< for --engine and the project file: "ray"
    std::string_view name;   ///< shown in the window: "Ray reference"
    std::string_view about;  ///< one-line tooltip
    /// The engine's own peak memory, bytes per cell of the region's bounding box, in addition to the field
    /// and the ray scene.
    double bytesPerCell = 0;
    std::vector<EngineOption> options;
};

struct EngineEntry {
    EngineInfo info;
    /// Called with a value for every option of `info`, each within its range.
    std::function<Result<std::unique_ptr<Engine>>(const EngineSettings&)> make;
};

/// In display order. Keys are unique.
using EngineList = std::vector<EngineEntry>;

/// Key of the reference engine, against which errors of the others are measured.
inline constexpr std::string_view referenceEngine = "ray";

/// All engines of core. A new engine is added in core_engines.cpp.
const EngineList& coreEngines();

/// Null for an unknown key.
const EngineEntry* findEngine(const EngineList& engines, std::string_view key);

/// Creates the engine with this key and these settings. Error, listing the valid choices: unknown key,
/// unknown option, or value out of range.
Result<std::unique_ptr<Engine>> makeEngine(std::string_view key, const EngineSettings& settings = {},
                                           const EngineList& engines = coreEngines());

}  // namespace noonmark
