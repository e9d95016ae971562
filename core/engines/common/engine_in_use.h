#pragma once

#include <optional>
#include <span>
#include <stop_token>

#include "core/engines/api/engine.h"

namespace noonmark {

/// The engine that answers one question: the one asked for or, if that one chooses others, its choice for
/// these cities, and what it switches to where the choice refuses or a sample shows that it is off. All that
/// it is made from must outlive it.
class EngineInUse {
public:
    /// Chooses. Visits every step and building: some ms.
    EngineInUse(const Engine& asked, std::span<const City* const> cities, const Receivers& receivers,
                const SunSteps& sun);

    /// The field of one of the cities. Where the choice refuses it switches to another engine.
    [[nodiscard]] Result<ShadowField> accumulate(const City& city, Progress& progress,
                                                 const std::stop_token& stop);

    /// Months, and shadow by building if wanted, by the engine that made the field where it sums them, months
    /// by rays one after the other; else by the engine that was asked for.
    [[nodiscard]] Result<ShadowBreakdown> breakDown(const City& city, const StepSets& sets, bool byBuilding,
                                                    Progress& progress, const std::stop_token& stop) const;
    /// Sets of another of the cities, over some of the receivers alone, by the same engine. Only where
    /// isIndependent().
    [[nodiscard]] Result<ShadowBreakdown> breakDownPart(const City& city, const Receivers& part,
                                                        const StepSets& sets, Progress& progress,
                                                        const std::stop_token& stop) const;
    /// The engine that was chosen for all cities; empty: the one asked for chooses none.
    [[nodiscard]] std::string_view chosenKey() const {
        return choice_ ? std::string_view(choice_->key) : std::string_view();
    }
    /// Whether breakDown() finds the same minutes for a receiver whichever other receivers there are.
    [[nodiscard]] bool isIndependent() const;
    /// Whether breakDown() sums by building although a sample showed that what it sums with is off.
    [[nodiscard]] bool attributionIsLessExact() const;

    /// Switches to a more exact engine if a sample of the field is off by more than the choice aims at.
    /// False: the field stands.
    bool switchToMoreExact(const SampledDeviation& deviation);
    [[nodiscard]] bool wouldSwitch(const SampledDeviation& deviation) const {
        return chooseMoreExact(deviation).has_value();
    }

private:
    [[nodiscard]] std::optional<EngineChoice> chooseMoreExact(const SampledDeviation& deviation) const;
    [[nodiscard]] bool sums(bool byBuilding) const;
    [[nodiscard]] const Engine& summing() const;
    [[nodiscard]] Result<ShadowBreakdown> sumSetBySet(const City& city, const StepSets& sets,
                                                      Progress& progress, const std::stop_token& stop) const;

    const Engine& asked_;
    std::span<const City* const> cities_;
    const Receivers& receivers_;
    const SunSteps& sun_;
    std::optional<EngineChoice> choice_;
    bool hasSwitched_ = false;  // to a more exact engine
};

}  // namespace noonmark
