#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/accumulate/shadow_field.h"
#include "core/city/city.h"
#include "core/progress.h"
#include "core/receivers/receivers.h"
#include "core/result.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// An engine: city, receivers and sun in, minutes of shadow out. Const and stateless across calls: one
/// accumulator may run on several threads. Uses all cores. Reports progress, and stops within 0.2 s of a stop
/// request with cancelled().
class Accumulator {
public:
    virtual ~Accumulator() = default;
    [[nodiscard]] virtual Result<ShadowField> accumulate(const City& city, const Receivers& receivers,
                                                         const SunSteps& sun, Progress& progress,
                                                         std::stop_token stop) const = 0;
};

/// What a user chooses from.
struct EngineInfo {
    std::string_view key;    ///< of --engine and the project file: "ray"
    std::string_view name;   ///< in the window: "Ray reference"
    std::string_view about;  ///< one line for a tooltip
    /// Memory of the engine's own at its peak, bytes a cell of the region's box, beyond the field and the ray
    /// scene.
    double bytesPerCell = 0;
};

/// Every engine of core, in the order to show them. To add one: engines.cpp and nothing else.
const std::vector<EngineInfo>& engines();

/// Error for an unknown key, naming the known ones.
Result<std::unique_ptr<Accumulator>> makeAccumulator(std::string_view key);

}  // namespace noonmark
