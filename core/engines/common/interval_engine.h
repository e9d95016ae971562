#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/common/shadow_mask.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// A short stretch of the sun's path, as the accrual maps see it: it moves along the great circle from
/// `first` to `last` in equal angles (paper, section 4: the tan law), one step after the other. Unit vectors
/// towards the sun, above the horizon.
struct SunInterval {
    glm::dvec3 first{0, 0, 1};
    glm::dvec3 last{0, 0, 1};
    int steps = 1;  ///< 1 to 64

    /// Direction at step k of 0 .. steps - 1; `first` at 0, `last` at steps - 1.
    [[nodiscard]] glm::dvec3 at(int step) const;
};

/// Who wants to see masks before their interval is finished. Called by the thread that shades.
struct MaskWatcher {
    std::function<bool()> wants;          ///< whether to be shown what is done by now; cheap
    std::function<void(int steps)> show;  ///< in `masks` all steps before this one are final
};

/// City and receivers made ready to be shaded, one interval after the other.
class IntervalScene {
public:
    virtual ~IntervalScene() = default;

    /// masks[i] is the shadow of receivers.cells[i]; `masks` has that size already and any content. Uses all
    /// cores; cancelled() within 0.2 s.
    [[nodiscard]] virtual Result<void> shade(const SunInterval& interval, std::span<ShadowMask> masks,
                                             std::stop_token stop) = 0;

    /// The same bits, shown on the way by engines that take the steps one after the other.
    [[nodiscard]] virtual Result<void> shadeWatched(const SunInterval& interval, std::span<ShadowMask> masks,
                                                    std::stop_token stop, const MaskWatcher& /*watcher*/) {
        return shade(interval, masks, std::move(stop));
    }

    /// What all calls so far cost.
    [[nodiscard]] virtual Cost cost() const = 0;
};

/// An engine that shades one interval at a time; graph_engine.h makes an Engine of it.
class IntervalEngine {
public:
    virtual ~IntervalEngine() = default;

    /// `directions`: every direction of the intervals to come (only SunSteps::steps is read), so that what
    /// cannot matter is left out. City and receivers outlive the scene.
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
