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

/// An engine that was chosen, and why.
struct EngineChoice {
    std::string_view key;  ///< of coreEngines()
    std::unique_ptr<Engine> engine;
    std::string why;  ///< "rays, since there is terrain"

    /// The engine's field, which says that it was chosen and why.
    [[nodiscard]] Result<ShadowField> accumulate(const City& city, const Receivers& receivers,
                                                 const SunSteps& sun, Progress& progress,
                                                 std::stop_token stop) const;
};

/// The ray reference, where the chosen engine refused: it takes every case.
EngineChoice fallBackToRays(const EngineChoice& refused, const Error& error);

/// Chooses the engine and says in the field's `engine` which one and why. On flat ground projected shadows,
/// which are exact, where they are expected to take no longer than the horizon sweep or no more than 2 s; on
/// terrain and roofs the ray reference on the same terms; else the horizon sweep, whose cells are off by 0.04
/// % of a long period in the mean. Where the one chosen refuses the case the ray reference takes it.
class AutoEngine final : public Engine {
public:
    explicit AutoEngine(HorizonSweepSettings sweep = {}) : sweep_(sweep) {}
    [[nodiscard]] Result<ShadowField> accumulate(const City& city, const Receivers& receivers,
                                                 const SunSteps& sun, Progress& progress,
                                                 std::stop_token stop) const override;

    /// One engine for fields that are to be compared with each other, by the city that costs most: fields of
    /// two engines would differ where the cities do not.
    [[nodiscard]] EngineChoice choose(std::span<const City* const> cities, const Receivers& receivers,
                                      const SunSteps& sun) const;

private:
    HorizonSweepSettings sweep_;
};

}  // namespace noonmark
