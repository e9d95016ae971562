#pragma once

// What sits above the single engines. core_engines.cpp lists all engines with their options
// (api/engine_registry.h), engine_ground.h states which of them need level ground, and auto_engine.h chooses
// one by its expected run time.

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

/// Expected run times in seconds on two cores. Only meant for comparing engines with each other; other
/// machines scale all of them alike. The constants (auto_engine.cpp) are fitted to run times for a day, a
/// month and a year on the grid sample and on Midtown.
struct EstimatedSeconds {
    double ray = 0;
    double projected = 0;
    double horizon = 0;
};
EstimatedSeconds estimateSeconds(const EngineLoad& load);

/// A chosen engine and the reason for the choice.
struct EngineChoice {
    std::string_view key;  ///< in coreEngines()
    std::unique_ptr<Engine> engine;
    std::string why;  ///< "rays, since there is terrain"

    /// Runs the engine; the field's `engine` text states that it was chosen automatically and why.
    [[nodiscard]] Result<ShadowField> accumulate(const City& city, const Receivers& receivers,
                                                 const SunSteps& sun, Progress& progress,
                                                 std::stop_token stop) const;
};

/// The ray reference, which accepts every case, for use after the chosen engine refused.
EngineChoice fallBackToRays(const EngineChoice& refused, const Error& error);

/// Chooses an engine and states in the field's `engine` which one and why. On flat ground it chooses
/// projected shadows, which are exact, if they are expected to take no longer than the horizon sweep or at
/// most 2 s; on terrain and roofs it chooses the ray reference under the same condition. Otherwise it chooses
/// the horizon sweep, whose cells are off by 0.04 % of a long period on average. If the chosen engine refuses
/// the case, the ray reference takes over.
class AutoEngine final : public Engine {
public:
    explicit AutoEngine(HorizonSweepSettings sweep = {}) : sweep_(sweep) {}
    [[nodiscard]] Result<ShadowField> accumulate(const City& city, const Receivers& receivers,
                                                 const SunSteps& sun, Progress& progress,
                                                 std::stop_token stop) const override;

    /// Chooses one engine for fields that will be compared with each other, based on the city that costs
    /// most. Fields of two different engines would differ even where the cities do not.
    [[nodiscard]] EngineChoice choose(std::span<const City* const> cities, const Receivers& receivers,
                                      const SunSteps& sun) const;

private:
    HorizonSweepSettings sweep_;
};

}  // namespace noonmark
