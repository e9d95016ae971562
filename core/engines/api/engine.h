#pragma once

// The engine interface and the values that cross it. Engine maps a City, Receivers and SunSteps to a
// ShadowField (shadow_field.h); SurfaceEngine does the same for points on any surface. engine_registry.h
// lists the engines by key with their options. partial_field.h and partial_pace.h carry running results to
// the interface while an engine works; step_sets.h splits a period into months or other sets; blank_field.h
// is the common start of every implementation.

#include <stop_token>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/shadow_field.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// An engine computes minutes of shadow from a city, receivers and sun steps. Const and stateless across
/// calls, so several threads may call one engine. Uses all cores. Reports progress, and returns cancelled()
/// within 0.2 s of a stop request.
class Engine {
public:
    virtual ~Engine() = default;
    [[nodiscard]] virtual Result<ShadowField> accumulate(const City& city, const Receivers& receivers,
                                                         const SunSteps& sun, Progress& progress,
                                                         std::stop_token stop) const = 0;
};

}  // namespace noonmark
