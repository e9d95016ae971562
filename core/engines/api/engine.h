#pragma once

#include <stop_token>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/shadow_field.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// An engine: city, receivers and sun in, minutes of shadow out. Const and stateless across calls: one
/// accumulator may run on several threads. Uses all cores. Reports progress, and stops within 0.2 s of a stop
/// request with cancelled().
class Engine {
public:
    virtual ~Engine() = default;
    [[nodiscard]] virtual Result<ShadowField> accumulate(const City& city, const Receivers& receivers,
                                                         const SunSteps& sun, Progress& progress,
                                                         std::stop_token stop) const = 0;
};

}  // namespace noonmark
