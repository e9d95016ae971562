#include "core/accumulate/projected_shadows.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <new>

#include "core/accumulate/blank_field.h"
#include "core/accumulate/projected/shadow_events.h"
#include "core/accumulate/projected/step_filler.h"
#include "core/accumulate/reach.h"
#include "core/stopwatch.h"

namespace noonmark {

namespace {

// Steps that share a list of the casters in reach, and the least that one task fills.
constexpr std::size_t stepsATask = 15;
// Rasters of this many bytes are filled before they are counted.
constexpr std::size_t batchBytes = std::size_t{64} << 20U;

Result<void> checkFlat(const City& city, const Receivers& receivers) {
    if (city.terrain || !receivers.flat())
        return failure("Projected shadows fall on flat ground only, and this city has terrain", "engine",
                       "Choose the ray reference");
    return {};
}

/// Fills and counts, batch after batch.
class Projection {
public:
    Projection(const ShadowCasters& casters, const Receivers& receivers, const SunSteps& sun,
               Progress& progress, std::stop_token stop)
        : sun_(sun),
          layout_(receivers.grid),
          filler_(casters, receivers, sun),
          events_(receivers),
          progress_(progress),
          stop_(std::move(stop)) {}

    Result<void> run(ShadowField& field) {
        const std::size_t batch = std::clamp(batchBytes / (layout_.words() * sizeof(std::uint64_t)),
                                             std::size_t{1}, std::max<std::size_t>(1, sun_.steps.size()));
        rasters_.resize(batch * layout_.words());
        for (std::size_t first = 0; first < sun_.steps.size(); first += batch) {
            const std::size_t end = std::min(first + batch, sun_.steps.size());
            timed(field, "fill", [&] { fill(first, end); });
            if (stop_.stop_requested()) return cancelled();
            timed(field, "count", [&] { count(first, end); });
        }
        timed(field, "count", [&] { events_.finish(field); });
        return {};
    }

    FillCount total() {
        return counts_.combine([](FillCount a, const FillCount& b) {
            return FillCount{a.polygons + b.polygons, a.rows + b.rows, a.outOfReach + b.outOfReach};
        });
    }

private:
    template <class Work>
    void timed(ShadowField& field, const char* stage, Work&& work) {
        const Stopwatch watch;
        work();
        field.cost.seconds[stage] += watch.seconds();
    }

    void fill(std::size_t first, std::size_t end) {
        const std::size_t tasks = (end - first + stepsATask - 1) / stepsATask;
        tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
            if (stop_.stop_requested()) return;
            const std::size_t from = first + task * stepsATask, to = std::min(from + stepsATask, end);
            const FillCount done = filler_.fill(
                from, to,
                std::span(rasters_).subspan((from - first) * layout_.words(), (to - from) * layout_.words()));
            FillCount& sum = counts_.local();
            sum = {sum.polygons + done.polygons, sum.rows + done.rows, sum.outOfReach + done.outOfReach};
            progress_.report(double(filled_ += to - from) / double(sun_.steps.size()), "filling shadows");
        });
    }

    void count(std::size_t first, std::size_t end) {
        const auto starts = std::make_unique<bool[]>(end - first);
        for (std::size_t step = first; step < end; ++step)
            starts[step - first] = step == 0 || startsRun(step);
        events_.add(std::span(rasters_).first((end - first) * layout_.words()), {starts.get(), end - first});
    }

    [[nodiscard]] bool startsRun(std::size_t step) const {
        const auto day = std::ranges::lower_bound(sun_.days, std::uint32_t(step), {}, &SunDay::first);
        const bool newDay = day != sun_.days.end() && day->first == step;
        return newDay || sun_.steps[step].slot != sun_.steps[step - 1].slot + 1;
    }

    const SunSteps& sun_;
    BitLayout layout_;
    StepFiller filler_;
    ShadowEvents events_;
    Progress& progress_;
    std::stop_token stop_;
    std::vector<std::uint64_t> rasters_;
    std::atomic<std::size_t> filled_{0};
    tbb::combinable<FillCount> counts_;
};

Result<ShadowField> accumulated(const City& city, const Receivers& receivers, const SunSteps& sun,
                                Progress& progress, const std::stop_token& stop) {
    ShadowField field = blankField(receivers, sun);
    field.engine =
        "Projected shadows: each building's shadow filled as polygons at every step, exact on flat ground";
    const Stopwatch watch;
    const std::vector<std::uint32_t> used = buildingsInReach(city, receivers, sun);
    const ShadowCasters casters = shadowCasters(city, used, receivers.grid);
    field.cost.buildingsUsed = std::uint32_t(used.size());
    field.cost.skipped["buildings whose shadow cannot reach a receiver"] =
        city.buildings.size() - used.size();
    field.cost.seconds["build"] = watch.seconds();
    Projection projection(casters, receivers, sun, progress, stop);
    if (const auto done = projection.run(field); !done) return tl::make_unexpected(done.error());
    const FillCount total = projection.total();
    field.cost.skipped["shadows that meet no receiver (casters x steps)"] = total.outOfReach;
    progress.report(1, "filling shadows");
    return field;
}

}  // namespace

Result<ShadowField> ProjectedShadows::accumulate(const City& city, const Receivers& receivers,
                                                 const SunSteps& sun, Progress& progress,
                                                 std::stop_token stop) const {
    if (const auto flat = checkFlat(city, receivers); !flat) return tl::make_unexpected(flat.error());
    try {
        return accumulated(city, receivers, sun, progress, stop);
    } catch (const std::bad_alloc&) {
        return failure("There is not enough memory for this study", "projected shadows",
                       "Choose a smaller region or larger cells");
    }
}

Result<std::vector<std::uint64_t>> projectedRasters(const City& city, const Receivers& receivers,
                                                    const SunSteps& sun) {
    if (const auto flat = checkFlat(city, receivers); !flat) return tl::make_unexpected(flat.error());
    const ShadowCasters casters = shadowCasters(city, buildingsInReach(city, receivers, sun), receivers.grid);
    std::vector<std::uint64_t> rasters(sun.steps.size() * BitLayout(receivers.grid).words());
    StepFiller(casters, receivers, sun).fill(0, sun.steps.size(), rasters);
    return rasters;
}

}  // namespace noonmark
