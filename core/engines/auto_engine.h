#pragma once

// What sits above the single engines: core_engines.cpp lists all engines with their options
// (api/engine_registry.h), and AutoEngine (this file) chooses one by its expected run time.

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/engines/api/engine.h"
#include "core/engines/horizon/horizon_sweep.h"

namespace noonmark {

/// The size of a study, as far as it determines the engines' run time.
struct EngineLoad {
    std::size_t receivers = 0;
    std::size_t rows = 0;  ///< grid rows
    double cellAreaM2 = 1;
    std::size_t steps = 0;              ///< steps of the sun
    std::size_t bins = 0;               ///< azimuth bins under the sweep's settings
    std::size_t buildings = 0;          ///< buildings in reach
    std::size_t overhangTriangles = 0;  ///< triangles of the overhangs of these buildings
    std::size_t terrainCells = 0;
    bool level = true;  ///< no terrain, and all receivers on the ground
    bool runs = true;   ///< the sweep counts the longest runs too
};

/// For several cities, each figure is the largest among them. Visits every step and building: some ms.
EngineLoad measureEngineLoad(std::span<const City* const> cities, const Receivers& receivers,
                             const SunSteps& sun, const HorizonSweepSettings& sweep);

/// The same for sums without longest runs on the cells of places, which lie apart in their grid.
EngineLoad measureLoadOfPlaces(std::span<const City* const> cities, const Receivers& receivers,
                               const SunSteps& sun);

/// Expected run times in seconds on two cores. Only meant for comparing engines with each other; other
/// machines scale all of them alike. The constants (auto_engine.cpp) are fitted to run times for a day, a
/// month and a year on the grid sample and on Midtown.
struct EstimatedSeconds {
    double ray = 0;
    double projected = 0;
    double horizon = 0;
};
EstimatedSeconds estimateSeconds(const EngineLoad& load);

/// Chooses the engine and says in the field's `engine` which one and why. On flat ground projected shadows,
/// which are exact, where they are expected to take no longer than the horizon sweep or no more than 2 s; on
/// terrain and roofs the ray reference on the same terms; else the horizon sweep, whose cells are off by 0.04
/// % of a long period in the mean. Where the one chosen refuses the case the ray reference takes it. Where a
/// sample shows that the sweep misses its error target, an exact engine does (chooseMoreExact()); whoever
/// measures the sample asks for it.
class AutoEngine final : public Engine {
public:
    explicit AutoEngine(HorizonSweepSettings sweep = {}) : sweep_(sweep) {}
    [[nodiscard]] std::string_view name() const override { return "The automatic choice"; }
    /// Derived from those of the engines it chooses among.
    [[nodiscard]] EngineCapabilities capabilities() const override;

    [[nodiscard]] std::optional<EngineChoice> choose(std::span<const City* const> cities,
                                                     const Receivers& receivers,
                                                     const SunSteps& sun) const override;
    [[nodiscard]] std::string_view stepMaskEngineName(std::span<const City* const> cities,
                                                      const Receivers& receivers) const override;
    /// The ray reference, which takes every case; none where it, or the user, ended the work.
    [[nodiscard]] std::optional<EngineChoice> chooseInstead(const EngineChoice& failed,
                                                            const Error& error) const override;
    /// The quicker of the exact engines that take the case, where the sweep misses its error target by more
    /// than chance explains: two standard errors of the sample, but no more than the target itself. None
    /// where the width of bins was set, which leaves no target.
    [[nodiscard]] std::optional<EngineChoice> chooseMoreExact(const EngineChoice& used,
                                                              const SampledDeviation& deviation,
                                                              std::span<const City* const> cities,
                                                              const Receivers& receivers,
                                                              const SunSteps& sun) const override;

protected:
    [[nodiscard]] Result<ShadowField> compute(const City& city, const Receivers& receivers,
                                              const SunSteps& sun, Progress& progress,
                                              std::stop_token stop) const override;
    [[nodiscard]] Result<ShadowBreakdown> computeBreakdown(const City& city, const Receivers& receivers,
                                                           const SunSteps& sun, const StepSets& sets,
                                                           bool byBuilding, Progress& progress,
                                                           std::stop_token stop) const override;
    [[nodiscard]] Result<void> computeStepMasks(std::span<const City* const> cities,
                                                const Receivers& receivers, const SunSteps& sun,
                                                const TakeDay& take, Progress& progress,
                                                std::stop_token stop) const override;

private:
    HorizonSweepSettings sweep_;
};

}  // namespace noonmark
