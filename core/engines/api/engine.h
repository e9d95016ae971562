#pragma once

#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/api/step_sets.h"
#include "core/receivers/point_receivers.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Whether an engine finds the same minutes for a receiver whichever other receivers there are. Those that
/// lay maps over the whole region may not.
enum class Independence {
    none,
    onLevelGround,  ///< on terrain, heights are rounded from the lowest receiver up
    always,
};

/// What an engine can do. Engine refuses everything else before the engine runs.
struct EngineCapabilities {
    bool terrain = false;        ///< takes cities with terrain, and receivers at heights of their own
    bool roofs = false;          ///< takes receivers on roofs
    bool overhangs = true;       ///< lets light through below parts with open air below them
    bool continuous = true;      ///< finds the longest unbroken run, too
    bool sets = false;           ///< sums minutes by sets of steps (months, weights) in one run
    bool attribution = false;    ///< and by building
    bool stepMasks = false;      ///< states which receivers are in shadow at each step (timelines of places)
    bool trees = false;          ///< weighs what crowns take from the sun (ShadowField::trees)
    bool cache = false;          ///< has a cache for edits (HorizonCache, ShadowCache)
    bool choosesEngine = false;  ///< computes nothing itself, but chooses another engine for each case
    Independence independence = Independence::none;
};

/// The capabilities of an engine that chooses one of these for each case: it takes and sums what any of them
/// does, and states only what all of them state.
constexpr EngineCapabilities combineForChoice(std::initializer_list<EngineCapabilities> engines) {
    EngineCapabilities choice{.choosesEngine = true};
    for (const EngineCapabilities& engine : engines) {
        choice.terrain |= engine.terrain;
        choice.roofs |= engine.roofs;
        choice.overhangs &= engine.overhangs;
        choice.continuous &= engine.continuous;
        choice.sets |= engine.sets;
        choice.attribution |= engine.attribution;
        choice.stepMasks |= engine.stepMasks;
        choice.trees |= engine.trees;
        choice.cache |= engine.cache;
    }
    return choice;
}

struct EngineChoice;

/// How far a sample of a field's cells is off from the ray reference, percent of the period.
struct SampledDeviation {
    double meanPct = 0;
    double standardErrorPct = 0;  ///< of the mean, from the spread of the sample
};

/// Takes the masks of one day, one entry a city, which it may move away. `day`: index in SunSteps::days. An
/// error ends the computation and is returned from it.
using TakeDay = std::function<Result<void>(std::size_t day, std::span<StepMasks> ofCities)>;

/// An engine: city, receivers and sun in, minutes of shadow out. Const and without state: one engine may run
/// on several threads at a time. Uses all cores. Reports progress; stops within 0.2 s of a stop request with
/// cancelled().
///
/// The public functions check what holds for every engine and then call the protected ones, which an engine
/// implements: they refuse terrain and roofs where the engine does not take them (ErrorKind::unsupported),
/// and turn a lack of memory into an error (ErrorKind::limit).
class Engine {
public:
    virtual ~Engine() = default;

    /// Names the engine in errors: "Projected shadows".
    [[nodiscard]] virtual std::string_view name() const = 0;
    [[nodiscard]] virtual EngineCapabilities capabilities() const = 0;

    [[nodiscard]] Result<ShadowField> accumulate(const City& city, const Receivers& receivers,
                                                 const SunSteps& sun, Progress& progress,
                                                 std::stop_token stop) const;

    /// Minutes by sets of steps, and by building if wanted. `sets.ofStep`: one entry a step. Error
    /// (ErrorKind::unsupported) from engines without EngineCapabilities::sets, or attribution.
    [[nodiscard]] Result<ShadowBreakdown> breakDown(const City& city, const Receivers& receivers,
                                                    const SunSteps& sun, const StepSets& sets,
                                                    bool byBuilding, Progress& progress,
                                                    std::stop_token stop) const;

    /// Which receivers are in shadow at each step, one day after the other, in time order and never two at a
    /// time: a year of masks is not held in memory. Several cities (a baseline and scenarios) are measured in
    /// one run, and what they share is computed once; the receivers must be receivers in each. Days without
    /// steps have masks without steps. Error of kind unsupported from engines without
    /// EngineCapabilities::stepMasks; the error of `take`.
    [[nodiscard]] Result<void> shadeSteps(std::span<const City* const> cities, const Receivers& receivers,
                                          const SunSteps& sun, const TakeDay& take, Progress& progress,
                                          std::stop_token stop) const;

    /// The engine whose masks shadeSteps() would state: its own name, unless it chooses another.
    [[nodiscard]] virtual std::string_view stepMaskEngineName(std::span<const City* const> /*cities*/,
                                                              const Receivers& /*receivers*/) const {
        return name();
    }

    /// Engines that choose others (EngineCapabilities::choosesEngine): one engine for fields that are to be
    /// compared with each other, by the city that costs most. None from all others.
    [[nodiscard]] virtual std::optional<EngineChoice> choose(std::span<const City* const> cities,
                                                             const Receivers& receivers,
                                                             const SunSteps& sun) const;
    /// What is chosen where the choice failed with this error; none: the error stands.
    [[nodiscard]] virtual std::optional<EngineChoice> chooseInstead(const EngineChoice& failed,
                                                                    const Error& error) const;
    /// What is chosen where a sample of the choice's field is so far off; none: that is what it aims at.
    [[nodiscard]] virtual std::optional<EngineChoice> chooseMoreExact(const EngineChoice& used,
                                                                      const SampledDeviation& deviation,
                                                                      std::span<const City* const> cities,
                                                                      const Receivers& receivers,
                                                                      const SunSteps& sun) const;

protected:
    [[nodiscard]] virtual Result<ShadowField> compute(const City& city, const Receivers& receivers,
                                                      const SunSteps& sun, Progress& progress,
                                                      std::stop_token stop) const = 0;
    [[nodiscard]] virtual Result<ShadowBreakdown> computeBreakdown(const City& city,
                                                                   const Receivers& receivers,
                                                                   const SunSteps& sun, const StepSets& sets,
                                                                   bool byBuilding, Progress& progress,
                                                                   std::stop_token stop) const;
    [[nodiscard]] virtual Result<void> computeStepMasks(std::span<const City* const> cities,
                                                        const Receivers& receivers, const SunSteps& sun,
                                                        const TakeDay& take, Progress& progress,
                                                        std::stop_token stop) const;
};

/// An engine that was chosen, and why.
struct EngineChoice {
    std::string_view key;  ///< of coreEngines()
    std::unique_ptr<Engine> engine;
    std::string why;  ///< "rays, since there is terrain"

    /// The engine's field, which states that the engine was chosen and why.
    [[nodiscard]] Result<ShadowField> accumulate(const City& city, const Receivers& receivers,
                                                 const SunSteps& sun, Progress& progress,
                                                 std::stop_token stop) const;
};

/// Error (ErrorKind::unsupported) where the city has terrain, or receivers lie on roofs, and the engine of
/// this name does not take them.
Result<void> checkGround(const City& city, const Receivers& receivers, const EngineCapabilities& capabilities,
                         std::string_view name);

struct StepMemory;  // core/lab/graph/interval_tally.h

/// Shadow on surface points for one period: what ShadowField is for a grid.
struct SurfaceShadow {
    std::vector<float> grossMin;  ///< minutes in shadow per day, mean over the period's days; one per point
    std::vector<float> continuousMin;  ///< longest unbroken run on any day, minutes; one per point
    double sunlitMinutesPerDay = 0;    ///< mean minutes per day with the sun above the horizon

    std::string engine;  ///< name and settings in words
    Cost cost;
};

/// An engine for receivers on arbitrary surfaces. A surface that faces away from the sun, or is edge-on to
/// it, is in its own shadow. Const and stateless across calls; uses all cores; reports progress, and returns
/// cancelled() within 0.2 s of a stop request. Error: positions and normals differ in number.
class SurfaceEngine {
public:
    virtual ~SurfaceEngine() = default;
    [[nodiscard]] virtual Result<SurfaceShadow> accumulate(const City& city, const SurfacePoints& points,
                                                           const SunSteps& sun, Progress& progress,
                                                           std::stop_token stop) const = 0;

    /// The same result. Engines that process a day in intervals, like the accrual maps, store its steps in
    /// `memory` and base running results on the steps of a coarser view (interval_tally.h).
    [[nodiscard]] virtual Result<SurfaceShadow> accumulate(const City& city, const SurfacePoints& points,
                                                           const SunSteps& sun, Progress& progress,
                                                           std::stop_token stop,
                                                           const StepMemory& /*memory*/) const {
        return accumulate(city, points, sun, progress, std::move(stop));
    }
};

/// A result with 0 minutes and the period's figures, from which every surface engine starts. Error: positions
/// and normals differ in number.
Result<SurfaceShadow> makeBlankSurfaceShadow(const SurfacePoints& points, const SunSteps& sun);

}  // namespace noonmark
