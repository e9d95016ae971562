#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/engines/common/engine_in_use.h"
#include "core/engines/common/shadow_reach.h"
#include "core/measures/error_sample.h"
#include "core/study/by_place/cell_groups.h"
#include "core/study/by_place/place_errors.h"
#include "core/study/by_place/sun_by_place.h"

namespace noonmark {

/// A period's shadow by sets over the same receivers in several cities. All that it is made from must outlive
/// it.
class CitySweeps {
public:
    CitySweeps(const Engine& asked, std::span<const City* const> cities, const Receivers& receivers,
               const SunSteps& sun, const StepSets& sets);

    /// The sums of the first city, by a sweep over all receivers; made again after switchToMoreExact().
    Result<ShadowBreakdown> sweepFirst(Progress& progress, const std::stop_token& stop);

    /// The sums of another city, given those of the first: where its changed buildings cast shadow. Over all
    /// receivers where the engine's receivers depend on each other, or the ground changed.
    Result<ShadowBreakdown> sweepOther(std::size_t city, const ShadowBreakdown& first, Progress& progress,
                                       const std::stop_token& stop);

    /// Seconds that the sweeps of all cities take, each with rays for a sample of so many receivers, by the
    /// model that the automatic engine chooses with. `asked`: key of the engine. Some ms.
    [[nodiscard]] double forecast(std::string_view asked, std::size_t sample);

    /// Seconds that the shade of trees takes in all cities on top of that (shadeTreeSets()), likewise with
    /// rays for a sample. 0 without trees. Some ms.
    [[nodiscard]] double forecastTrees(std::size_t sample) const;

    /// The engine that was chosen; empty: the one asked for chooses none.
    [[nodiscard]] std::string_view chosenKey() const { return engine_.chosenKey(); }

    /// Switches to a more exact engine where a sample of the first city is off; false: it stands.
    bool switchToMoreExact(const SampledDeviation& off) { return engine_.switchToMoreExact(off); }

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

/// An engine that the one asked for chose; null: it chooses none, or one that sums no months.
struct ChosenEngine {
    std::string key;
    std::unique_ptr<Engine> engine;
};

/// What is measured, in the course of it.
struct Measuring {
    std::vector<const City*> cities;  ///< the first is the baseline
    const Engine& engine;
    std::vector<SunByPlace>& made;  ///< of each city
    Progress& progress;
    std::stop_token stop;
    SunSteps daylight{};
    StepSets months{};
    std::vector<SunSteps> dates{};
    std::function<void(double)> takeForecast{};  ///< empty: none is wanted
    std::optional<Observer> observer{};          ///< of a tile; none: in the middle of the places
    Stopwatch watch{};
    /// For the cells of all places, over the period and on each date. Small places are measured by the same.
    std::vector<ChosenEngine> chosen{};
    std::vector<SampledDeviation> missed{};       ///< samples after which a more exact engine took over
    std::vector<ComparedSets> compared{};         ///< the period in the cities sampled so far
    std::vector<std::vector<double>> smallOff{};  ///< of each city: how far means of small places are off
    bool hasTrees = false;                        ///< some city has trees, and they are wanted
    bool treesReached = false;                    ///< and one has reached a place

    [[nodiscard]] const SunByPlaceSettings& settings() const { return made.front().settings; }
    [[nodiscard]] const std::vector<Place>& places() const { return made.front().places; }
    Warnings& warnings() { return made.front().warnings; }
};

template <class Stage>
Result<void> timeStage(SunByPlace& made, const char* name, Stage&& stage) {
    const Stopwatch watch;
    auto done = std::forward<Stage>(stage)();
    made.seconds[name] += watch.seconds();
    return done;
}

/// Of small places rays are traced to some in a few groups: each group needs a scene of its own.
inline constexpr std::size_t sampledSmallGroups = 3;

/// A group of places that is measured. The main one is that of all places.
struct MeasuredGroup {
    const CellGroup& cells;
    bool isMain = true;
    bool isSampled = true;  ///< its figures are held against rays; the main one's always
};

/// Measures the places of a group in all cities: their sun over the period, by month and on each date, and
/// the errors of it. Error: cancelled(), those of the engine.
Result<void> measureGroup(Measuring& m, const MeasuredGroup& group, Progress& progress);

/// Seconds that this is expected to take, if no sample is off.
double forecastGroup(Measuring& m, const MeasuredGroup& group);

}  // namespace noonmark
