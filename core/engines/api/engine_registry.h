#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/describe/field_values.h"
#include "core/engines/api/engine.h"

namespace noonmark {

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
    /// What a user may set: rows whose object is an EngineSettings. engineOf() makes them of the fields of
    /// the engine's settings.
    std::vector<Field> options = {};
};

/// An engine in the list: what it is, and how it is made. Its Engine::capabilities() are those of `info`.
struct EngineEntry {
    EngineInfo info;
    /// Called with values of options of `info`, each within its range.
    std::function<Result<std::unique_ptr<Engine>>(const EngineSettings&)> make;
};

/// An engine whose options are these fields of its settings S. `make` takes an S and gives a Result of the
/// engine.
template <class S, class Make>
EngineEntry engineOf(EngineInfo info, Fields<S> fields, Make make) {
    info.options = asNamedNumbers(fields.rows());
    return {
        std::move(info),
        [fields = std::move(fields), make](const EngineSettings& values) -> Result<std::unique_ptr<Engine>> {
            S settings;
            const auto read = readNamedNumbers(fields.of(settings), values);
            if (!read) return tl::make_unexpected(read.error());
            return make(settings);
        }};
}

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
