#include "core/engines/common/engine_in_use.h"

#include <utility>

#include "core/base/progress.h"

namespace noonmark {

EngineInUse::EngineInUse(const Engine& asked, std::span<const City* const> cities, const Receivers& receivers,
                         const SunSteps& sun)
    : asked_(asked),
      cities_(cities),
      receivers_(receivers),
      sun_(sun),
      choice_(asked.choose(cities, receivers, sun)) {}

Result<ShadowField> EngineInUse::accumulate(const City& city, Progress& progress,
                                            const std::stop_token& stop) {
    if (!choice_) return asked_.accumulate(city, receivers_, sun_, progress, stop);
    auto field = choice_->accumulate(city, receivers_, sun_, progress, stop);
    if (field) return field;
    auto other = asked_.chooseInstead(*choice_, field.error());
    if (!other) return field;
    choice_ = std::move(other);
    return choice_->accumulate(city, receivers_, sun_, progress, stop);
}

std::optional<EngineChoice> EngineInUse::chooseMoreExact(const SampledDeviation& deviation) const {
    if (!choice_) return std::nullopt;
    return asked_.chooseMoreExact(*choice_, deviation, cities_, receivers_, sun_);
}

bool EngineInUse::switchToMoreExact(const SampledDeviation& deviation) {
    auto other = chooseMoreExact(deviation);
    if (!other) return false;
    choice_ = std::move(other);
    hasSwitched_ = true;
    return true;
}

bool EngineInUse::sums(bool byBuilding) const {
    const EngineCapabilities able = choice_->engine->capabilities();
    return byBuilding ? able.attribution : able.sets;
}

bool EngineInUse::attributionIsLessExact() const { return hasSwitched_ && !sums(true); }

Result<ShadowBreakdown> EngineInUse::breakDown(const City& city, const StepSets& sets, bool byBuilding,
                                               Progress& progress, const std::stop_token& stop) const {
    if (hasSwitched_ && sums(byBuilding))
        return choice_->engine->breakDown(city, receivers_, sun_, sets, byBuilding, progress, stop);
    if (hasSwitched_ && !byBuilding) return sumSetBySet(city, sets, progress, stop);
    const Engine& engine = byBuilding ? asked_ : summing();
    return engine.breakDown(city, receivers_, sun_, sets, byBuilding, progress, stop);
}

// The choice for all cities where it sums sets; the engine asked for would choose for each city anew.
const Engine& EngineInUse::summing() const { return choice_ && sums(false) ? *choice_->engine : asked_; }

Result<ShadowBreakdown> EngineInUse::breakDownPart(const City& city, const Receivers& part,
                                                   const StepSets& sets, Progress& progress,
                                                   const std::stop_token& stop) const {
    return summing().breakDown(city, part, sun_, sets, false, progress, stop);
}

bool EngineInUse::isIndependent() const {
    if (hasSwitched_ && !sums(false)) return false;
    const Independence how = summing().capabilities().independence;
    return how == Independence::always || (how == Independence::onLevelGround && receivers_.flat());
}

Result<ShadowBreakdown> EngineInUse::sumSetBySet(const City& city, const StepSets& sets, Progress& progress,
                                                 const std::stop_token& stop) const {
    ShadowBreakdown breakdown{.grid = receivers_.grid,
                              .sets = sets,
                              .sunlitMinutes = sets.sunlitMinutes(sun_),
                              .cells = receivers_.cells};
    for (std::size_t set = 0; set < sets.names.size(); ++set) {
        ProgressShare share(progress, set, sets.names.size());
        const SunSteps own = sets.stepsOf(set, sun_);
        auto field = choice_->engine->accumulate(city, receivers_, own, share, stop);
        if (!field) return tl::make_unexpected(field.error());
        auto& minutes = breakdown.minutes.emplace_back(valuesAt(breakdown.cells, field->grossMin));
        for (float& one : minutes) one *= float(own.dayCount());
        breakdown.engine = std::move(field->engine);
    }
    return breakdown;
}

}  // namespace noonmark
