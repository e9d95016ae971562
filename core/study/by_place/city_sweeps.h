#pragma once

#include <optional>
#include <span>
#include <stop_token>
#include <string_view>

#include "core/engines/common/engine_in_use.h"
#include "core/engines/common/shadow_reach.h"

namespace noonmark {

/// A period's shadow by sets over the same receivers in several cities. All that it is made from must outlive
/// it.
class CitySweeps {
public:
    CitySweeps(const Engine& asked, std::span<const City* const> cities, const Receivers& receivers,
               const SunSteps& sun, const StepSets& sets);

    /// Of the first city, in a sweep over all receivers. Again after goOn().
    Result<ShadowBreakdown> sweepFirst(Progress& progress, const std::stop_token& stop);

    /// Of another one, given those of the first: where its changed buildings cast shadow. Over all receivers
    /// where the engine's receivers depend on each other, or the ground changed.
    Result<ShadowBreakdown> sweepOther(std::size_t city, const ShadowBreakdown& first, Progress& progress,
                                       const std::stop_token& stop);

    /// Seconds that the sweeps of all cities take, each with rays for a sample of so many receivers, by the
    /// model that the automatic engine chooses with. `asked`: key of the engine. Some ms.
    [[nodiscard]] double forecast(std::string_view asked, std::size_t sample);

    /// The engine that was chosen; empty: the one asked for chooses none.
    [[nodiscard]] std::string_view chosenKey() const { return engine_.chosenKey(); }

    /// Goes on to a closer engine where a sample of the first city is off; false: it stands.
    bool goOn(const SampledOff& off) { return engine_.goOn(off); }

private:
    // The receivers on which a city may differ from the first; none: all may.
    [[nodiscard]] std::optional<Receivers> findChanged(std::size_t city);
    [[nodiscard]] double forecastOne(const City& city, const Receivers& receivers, std::string_view asked,
                                     std::size_t sample) const;

    std::span<const City* const> cities_;
    const Receivers& receivers_;
    const SunSteps& sun_;
    const StepSets& sets_;
    EngineInUse engine_;
    std::optional<ShadowReach> reach_;  // created on first use
};

}  // namespace noonmark
