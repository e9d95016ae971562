#include "core/study/by_place/group_measure.h"

#include <tbb/task_arena.h>

#include <algorithm>

#include "core/engines/auto_engine.h"
#include "core/engines/common/changed_buildings.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/horizon/trees/crown_sweep.h"
#include "core/engines/shade_trees.h"

namespace noonmark {

namespace {

constexpr double modelCores = 2;  // of estimateSeconds()
// Months on the cells of places, which lie far apart, against the model's dense regions without months: of
// Midtown and Monaco, a day to a year.
constexpr double sweepOverModel = 4, projectedOverModel = 2.3;
Buildings listChanged(const City& before, const City& after) {
    ChangedBuildings changed = findChangedBuildings(before.buildings, after.buildings);
    changed.removed.insert(changed.removed.end(), changed.added.begin(), changed.added.end());
    return changed.removed;
}

// The receivers that were not swept have the minutes of the first city.
ShadowBreakdown fillFrom(const ShadowBreakdown& first, const ShadowBreakdown& part) {
    ShadowBreakdown all = first;
    all.engine = part.engine;
    for (std::size_t i = 0; i < part.cells.size(); ++i) {
        const std::size_t receiver = findReceiver(first, part.cells[i]);
        for (std::size_t set = 0; set < part.minutes.size(); ++set)
            all.minutes[set][receiver] = part.minutes[set][i];
    }
    return all;
}

}  // namespace

CitySweeps::CitySweeps(const Engine& asked, std::span<const City* const> cities, const Receivers& receivers,
                       const SunSteps& sun, const StepSets& sets)
    : cities_(cities),
      receivers_(receivers),
      sun_(sun),
      sets_(sets),
      engine_(asked, cities, receivers, sun) {}

Result<ShadowBreakdown> CitySweeps::sweepFirst(Progress& progress, const std::stop_token& stop) {
    return engine_.breakDown(*cities_.front(), sets_, false, progress, stop);
}

Result<ShadowBreakdown> CitySweeps::sweepOther(std::size_t city, const ShadowBreakdown& first,
                                               Progress& progress, const std::stop_token& stop) {
    const City& other = *cities_[city];
    const auto reached = findChanged(city);
    if (!reached) return engine_.breakDown(other, sets_, false, progress, stop);
    if (reached->cells.empty()) return first;
    return engine_.breakDownPart(other, *reached, sets_, progress, stop)
        .map([&](const ShadowBreakdown& part) { return fillFrom(first, part); });
}

std::optional<Receivers> CitySweeps::findChanged(std::size_t city) {
    const City& other = *cities_[city];
    if (other.terrain != cities_.front()->terrain || !engine_.isIndependent()) return std::nullopt;
    if (!reach_) reach_.emplace(sun_);
    return findReached(listChanged(*cities_.front(), other), receivers_, *reach_);
}

double CitySweeps::forecast(std::string_view asked, std::size_t sample) {
    double seconds = 0;
    for (std::size_t city = 0; city < cities_.size(); ++city) {
        const auto reached = city == 0 ? std::nullopt : findChanged(city);
        seconds += forecastOne(*cities_[city], reached ? *reached : receivers_, asked, sample);
    }
    return seconds;
}

// All receivers in each city, whatever changed; and rays to the sample.
double CitySweeps::forecastTrees(std::size_t sample) const {
    double seconds = 0;
    for (const City* city : cities_) {
        const TreeSeconds all = estimateTreeSeconds(*city, receivers_, sun_, ShadowCounts::gross);
        const double cells = std::max<double>(1, double(receivers_.cells.size()));
        seconds +=
            (areRaysQuicker(sun_) ? all.rays : all.sweep) + all.rays * std::min(1.0, double(sample) / cells);
    }
    return seconds * modelCores / double(tbb::this_task_arena::max_concurrency());
}

double CitySweeps::forecastOne(const City& city, const Receivers& receivers, std::string_view asked,
                               std::size_t sample) const {
    const City* const cities[]{&city};
    EngineLoad load = measureLoadOfPlaces(cities, receivers, sun_);
    const std::string_view key = engine_.chosenKey().empty() ? asked : engine_.chosenKey();
    const EstimatedSeconds all = estimateSeconds(load);
    const double sweep = receivers.cells.empty() ? 0
                         : key == "projected"    ? all.projected * projectedOverModel
                                                 : all.horizon * sweepOverModel;
    load.receivers = std::min(sample, receivers_.cells.size());
    const double rays = sample == 0 ? 0 : estimateSeconds(load).ray;
    return (sweep + rays) * modelCores / double(tbb::this_task_arena::max_concurrency());
}

}  // namespace noonmark
