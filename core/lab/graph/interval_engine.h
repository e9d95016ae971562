#pragma once

#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/engine.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/common/run_counter.h"
#include "core/engines/common/sun_interval.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// A city and receivers prepared for shading, one interval after the other.
class IntervalScene {
public:
    virtual ~IntervalScene() = default;

    /// Sets masks[i] to the shadow of receivers.cells[i]. `masks` must already have that size; its content is
    /// overwritten. Uses all cores; returns cancelled() within 0.2 s.
    [[nodiscard]] virtual Result<void> shade(const SunInterval& interval, std::span<ShadowMask> masks,
                                             std::stop_token stop) = 0;

    /// Gives the same bits. Engines that process the steps in order also show intermediate states.
    [[nodiscard]] virtual Result<void> shadeWatched(const SunInterval& interval, std::span<ShadowMask> masks,
                                                    std::stop_token stop, const MaskWatcher& /*watcher*/) {
        return shade(interval, masks, std::move(stop));
    }

    /// Total cost of all calls so far.
    [[nodiscard]] virtual Cost cost() const = 0;
};

/// An engine that shades one interval at a time; graph_engine.h turns it into an Engine.
class IntervalEngine {
public:
    virtual ~IntervalEngine() = default;

    /// `directions`: every direction of the intervals to come (only SunSteps::steps is read), so that
    /// buildings out of reach can be left out. City and receivers must outlive the scene, and be such as
    /// capabilities() takes: GraphEngine, like every Engine, refuses the others before.
    [[nodiscard]] virtual Result<std::unique_ptr<IntervalScene>> prepare(const City& city,
                                                                         const Receivers& receivers,
                                                                         const SunSteps& directions,
                                                                         std::stop_token stop) const = 0;

    /// Names the engine in errors: "Inverse accrual map".
    [[nodiscard]] virtual std::string_view name() const = 0;
    [[nodiscard]] virtual EngineCapabilities capabilities() const { return {}; }
    /// With its settings: "Inverse accrual map, 3 levels, C++".
    [[nodiscard]] virtual std::string describe() const = 0;
};

}  // namespace noonmark
