#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/engines/api/engine.h"
#include "core/engines/horizon/horizon_sweep.h"

namespace noonmark {

/// What engines have to do in a study.
struct EngineLoad {
    std::size_t receivers = 0;
    std::size_t rows = 0;  ///< of the grid
    double cellAreaM2 = 1;
    std::size_t steps = 0;              ///< of the sun
    std::size_t bins = 0;               ///< of azimuth, by the sweep's settings
    std::size_t buildings = 0;          ///< in reach
    std::size_t overhangTriangles = 0;  ///< of parts of these that hang
    std::size_t terrainCells = 0;
    bool level = true;  ///< no terrain, and receivers on the ground
    bool runs = true;   ///< the sweep counts the longest runs too
};

/// Of some cities the most of each. Looks at every step and building: some ms.
EngineLoad measureEngineLoad(std::span<const City* const> cities, const Receivers& receivers,
                             const SunSteps& sun, const HorizonSweepSettings& sweep);

/// Seconds that engines are expected to take on two cores: to compare them with each other, no more; other
/// machines differ alike. The constants (auto_engine.cpp) are fitted to times of a day, a month and a year on
/// the grid sample and on Midtown.
struct EstimatedSeconds {
    double ray = 0;
    double projected = 0;
    double horizon = 0;
};
EstimatedSeconds estimateSeconds(const EngineLoad& load);

/// Chooses the engine and says in the field's `engine` which one and why. On flat ground projected shadows,
/// which are exact, where they are expected to take no longer than the horizon sweep or no more than 2 s; on
/// terrain and roofs the ray reference on the same terms; else the horizon sweep, whose cells are off by 0.04
/// % of a long period in the mean. Where the one chosen refuses the case the ray reference takes it.
class AutoEngine final : public Engine {
public:
    explicit AutoEngine(HorizonSweepSettings sweep = {}) : sweep_(sweep) {}
    [[nodiscard]] std::string_view name() const override { return "The automatic choice"; }
    [[nodiscard]] EngineCapabilities capabilities() const override { return able; }
    static constexpr EngineCapabilities able{.terrain = true,
                                             .roofs = true,
                                             .sets = true,
                                             .attribution = true,
                                             .cache = true,
                                             .choosesEngine = true};

    [[nodiscard]] std::optional<EngineChoice> choose(std::span<const City* const> cities,
                                                     const Receivers& receivers,
                                                     const SunSteps& sun) const override;
    /// The ray reference, which takes every case; none where it, or the user, ended the work.
    [[nodiscard]] std::optional<EngineChoice> chooseInstead(const EngineChoice& failed,
                                                            const Error& error) const override;

protected:
    [[nodiscard]] Result<ShadowField> compute(const City& city, const Receivers& receivers,
                                              const SunSteps& sun, Progress& progress,
                                              std::stop_token stop) const override;
    [[nodiscard]] Result<ShadowBreakdown> computeBreakdown(const City& city, const Receivers& receivers,
                                                           const SunSteps& sun, const StepSets& sets,
                                                           bool byBuilding, Progress& progress,
                                                           std::stop_token stop) const override;

private:
    HorizonSweepSettings sweep_;
};

}  // namespace noonmark
