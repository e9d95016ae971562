#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/describe/value.h"
#include "core/engines/api/engine.h"

namespace noonmark {

/// How an option is set.
enum class OptionKind {
    number,
    wholeNumber,
    yesNo,  ///< 1 or 0; a check box in the window, "yes" and "no" on the command line
};

/// What a user may set on an engine. Values are numbers, whatever the kind: a project file holds them so.
struct EngineOption {
    std::string_view key;   ///< for --option, study.json and the project file: "levels"
    std::string_view name;  ///< shown in the window: "Source levels"
    std::string_view unit;  ///< "deg", "min", "m"; empty for a count
    double min = 0;
    double max = 1;
    double standard = 0;  ///< the default
    OptionKind kind = OptionKind::number;
    std::string_view about;  ///< one line for a tooltip
};

/// "5", "yes".
std::string formatOptionValue(const EngineOption& option, double value);

/// Values by option key; what is left out has its default.
using EngineSettings = NamedNumbers;

/// Description of an engine, shown where the user chooses one.
struct EngineInfo {
    std::string_view key;    ///< of --engine and the project file: "ray"
    std::string_view name;   ///< in the window: "Ray reference"
    std::string_view about;  ///< one line for a tooltip
    EngineCapabilities capabilities;
    /// Memory of the engine's own at its peak, bytes a cell of the region's box, beyond the field and the ray
    /// scene.
    double bytesPerCell = 0;
    std::vector<EngineOption> options = {};
};

/// An engine in the list: what it is, and how it is made. Its Engine::capabilities() are those of `info`.
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
