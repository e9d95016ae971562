#include "core/engines/projected/masks/projected_masks.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>

#include "core/describe/text.h"
#include "core/engines/common/changed_buildings.h"
#include "core/engines/common/shadow_reach.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

namespace {

// Consecutive steps of a task, so that the edges that face the sun are mostly those of the last call.
constexpr std::size_t stepsATask = 4 * stepsTogether;

std::vector<std::uint32_t> bothIn(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    std::vector<std::uint32_t> both;
    std::ranges::set_intersection(a, b, std::back_inserter(both));
    return both;
}

/// The casters of all cities whose shadow can reach a receiver.
struct NearCasters {
    NearCasters(std::span<const City* const> cities, const Receivers& receivers, const SunSteps& sun) {
        const SharedBuildings shared = findSharedBuildings(cities);
        own.reserve(cities.size());  // groups refer to them
        for (std::size_t i = 0; i < cities.size(); ++i) {
            const auto near = findBuildingsInReach(*cities[i], receivers, sun);
            if (i == 0) common = makeShadowCasters(*cities[0], bothIn(shared.common, near), receivers.grid);
            own.push_back(makeShadowCasters(*cities[i], bothIn(shared.own[i], near), receivers.grid));
        }
        grouped.common = CasterGroups(common, receivers.grid.cellM);
        for (const ShadowCasters& casters : own) grouped.own.emplace_back(casters, receivers.grid.cellM);
    }
    NearCasters(const NearCasters&) = delete;
    NearCasters& operator=(const NearCasters&) = delete;

    ShadowCasters common;
    std::vector<ShadowCasters> own;
    CityCasters grouped;
};

/// The masks of one day that is being computed.
struct DayInWork {
    std::size_t day = 0;
    SunSteps sun;  // of that day
    std::vector<StepMasks> masks;

    // All receivers lit.
    void reset(std::size_t which, const SunSteps& period, std::size_t cities, std::size_t receivers) {
        day = which;
        const std::size_t numbers[]{which};
        sun = chooseDays(period, numbers);
        masks.resize(cities);
        for (StepMasks& city : masks) {
            city.receivers = receivers;
            city.steps = sun.steps.size();
            city.words.assign(city.steps * city.wordsPerStep(), 0);
        }
    }
    [[nodiscard]] std::size_t tasks() const { return (sun.steps.size() + stepsATask - 1) / stepsATask; }
};

class MaskRun {
public:
    MaskRun(std::span<const City* const> cities, const Receivers& receivers, const SunSteps& sun,
            Progress& progress, const std::stop_token& stop)
        : cities_(cities.size()),
          receivers_(receivers),
          sun_(sun),
          progress_(progress),
          stop_(stop),
          casters_(cities, receivers, sun),
          fillers_([this] { return BlockFiller(casters_.grouped); }) {
        const CasterReach whole(sun, receivers.grid.cellM, 0, sun.steps.size());
        for (ReceiverBlock& window : divideIntoBlocks(receivers))
            plans_.emplace_back(std::move(window), casters_.grouped, whole);
    }

    Result<void> run(const TakeDay& take) {
        std::vector<DayInWork> storage;  // memory that is used again costs no page faults
        for (std::size_t day = 0; day < sun_.days.size();) {
            const std::span<DayInWork> days = begin(day, storage);
            fill(days);
            if (stop_.stop_requested()) return cancelled();
            for (DayInWork& done : days)
                if (auto taken = take(done.day, done.masks); !taken) return taken;
            day += days.size();
            progress_.report(double(day) / double(sun_.days.size()), NM_TEXT("filling shadows of places"));
        }
        return {};
    }

private:
    struct Task {
        DayInWork* day;
        std::size_t first;  // step
    };

    // As many days as keep all cores busy.
    std::span<DayInWork> begin(std::size_t day, std::vector<DayInWork>& storage) const {
        const auto enough = 4 * std::size_t(tbb::info::default_concurrency());
        std::size_t count = 0;
        for (std::size_t tasks = 0; day < sun_.days.size() && tasks < enough; ++day) {
            if (count == storage.size()) storage.emplace_back();
            DayInWork& next = storage[count++];
            next.reset(day, sun_, cities_, receivers_.cells.size());
            tasks += std::max<std::size_t>(1, next.tasks());
        }
        return std::span(storage).first(count);
    }

    void fill(std::span<DayInWork> days) {
        std::vector<Task> tasks;
        for (DayInWork& day : days)
            for (std::size_t i = 0; i < day.tasks(); ++i) tasks.push_back({&day, i * stepsATask});
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, tasks.size(), 1),
            [&](const auto& range) {
                for (std::size_t i = range.begin(); i < range.end(); ++i) fill(tasks[i]);
            },
            tbb::simple_partitioner());
    }

    void fill(const Task& task) {
        const SunSteps& sun = task.day->sun;
        const std::size_t end = std::min(task.first + stepsATask, sun.steps.size());
        std::vector<CasterReach> eights;
        for (std::size_t step = task.first; step < end; step += stepsTogether)
            eights.emplace_back(sun, receivers_.grid.cellM, step, step + stepsTogether);
        const CasterReach all(sun, receivers_.grid.cellM, task.first, end);
        BlockFiller& filler = fillers_.local();
        for (const BlockPlan& plan : plans_) {
            filler.aimAt(plan, all);
            for (std::size_t i = 0; i < eights.size(); ++i) {
                if (stop_.stop_requested()) return;
                filler.fill(eights[i], task.first + i * stepsTogether, task.day->masks);
            }
        }
    }

    std::size_t cities_;
    const Receivers& receivers_;
    const SunSteps& sun_;
    Progress& progress_;
    const std::stop_token& stop_;
    NearCasters casters_;
    std::vector<BlockPlan> plans_;
    tbb::enumerable_thread_specific<BlockFiller> fillers_;
};

}  // namespace

Result<void> computeProjectedMasks(std::span<const City* const> cities, const Receivers& receivers,
                                   const SunSteps& sun, const TakeDay& take, Progress& progress,
                                   const std::stop_token& stop) {
    progress.report(0, NM_TEXT("finding buildings in reach of the places"));
    if (sun.steps.empty() || receivers.cells.empty()) {
        for (std::size_t day = 0; day < sun.days.size(); ++day) {
            std::vector<StepMasks> none(cities.size(),
                                        StepMasks(receivers.cells.size(), sun.days[day].count));
            if (auto taken = take(day, none); !taken) return taken;
        }
        return {};
    }
    return MaskRun(cities, receivers, sun, progress, stop).run(take);
}

}  // namespace noonmark
