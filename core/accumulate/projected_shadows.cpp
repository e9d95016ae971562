#include "core/accumulate/projected_shadows.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <new>

#include "core/accumulate/blank_field.h"
#include "core/accumulate/day_sum.h"
#include "core/accumulate/level_ground.h"
#include "core/accumulate/partial_field.h"
#include "core/accumulate/projected/shadow_events.h"
#include "core/accumulate/projected/step_filler.h"
#include "core/accumulate/reach.h"
#include "core/accumulate/scattered_order.h"
#include "core/progress_share.h"
#include "core/stopwatch.h"
#include "core/sun/chosen_days.h"

namespace noonmark {

namespace {

Result<void> checkFlat(const City& city, const Receivers& receivers) {
    return checkLevelGround(city, receivers, "Projected shadows fall");
}

/// Fills and counts band after band of rows: its raster, and what its cells count, stay in cache.
class Projection {
public:
    Projection(const ShadowCasters& casters, const Receivers& receivers, const SunSteps& sun,
               Progress& progress, std::stop_token stop)
        : casters_(casters),
          receivers_(receivers),
          sun_(sun),
          where_(receivers),
          starts_(startsOfRuns(sun)),
          bands_(bandsOf(receivers.grid)),
          progress_(progress),
          stop_(std::move(stop)) {}

    Result<FillCount> run(ShadowField& field) {
        tbb::parallel_for(
            tbb::blocked_range<std::size_t>(0, bands_.size(), 1),
            [&](const auto& range) {
                for (std::size_t i = range.begin(); i < range.end(); ++i) count(bands_[i], field);
            },
            tbb::simple_partitioner());
        if (stop_.stop_requested()) return cancelled();
        return counts_.combine([](FillCount a, const FillCount& b) { return a += b; });
    }

private:
    void count(const RowBand& band, ShadowField& field) {
        if (stop_.stop_requested()) return;
        StepFiller filler(casters_, where_, receivers_, sun_, band);
        ShadowEvents events(filler.layout(), band, filler.noReceivers());
        std::vector<StepWords> rasters(filler.layout().words());
        const std::span words(rasters.data()->words, rasters.size() * stepsTogether);
        for (std::size_t step = 0; step < sun_.steps.size(); step += stepsTogether) {
            if (!goOn()) return;
            filler.fill(step, words);
            events.add(words, starts_[step / stepsTogether]);
        }
        events.finish(sun_.steps.size(), field);
        counts_.local() += filler.count();
    }

    // Reports eight more steps of a band.
    bool goOn() {
        const double all = double(sun_.steps.size()) * double(bands_.size());
        progress_.report(std::min(1.0, double(done_ += stepsTogether) / all), "filling shadows");
        return !stop_.stop_requested();
    }

    const ShadowCasters& casters_;
    const Receivers& receivers_;
    const SunSteps& sun_;
    ReceiverCount where_;
    std::vector<RunStarts> starts_;
    std::vector<RowBand> bands_;
    Progress& progress_;
    std::stop_token stop_;
    std::atomic<std::size_t> done_{0};
    tbb::combinable<FillCount> counts_;
};

using Shade = std::function<Result<FillCount>(const SunSteps&, ShadowField&, Progress&)>;

constexpr double pictureSeconds = 0.1;  // for some seven pictures a second

// Where somebody looks: some days after the other, scattered over the period, as many as a picture may take.
Result<FillCount> shadeInParts(const Shade& shade, const Receivers& receivers, const SunSteps& sun,
                               ShadowField& field, Progress& progress) {
    DaySum sum(receivers, sun);
    FillCount total;
    const std::size_t all = sun.dayCount(), stride = scatteringStride(all);
    for (std::size_t done = 0, count = 1; done < all;) {
        const Stopwatch watch;
        std::vector<std::size_t> numbers(std::min(count, all - done));
        for (std::size_t& number : numbers) number = done++ * stride % all;
        const SunSteps days = chosenDays(sun, numbers);
        ShadowField part = blankField(receivers, days);
        ProgressShare share(progress, done - numbers.size(), all, numbers.size());
        const auto filled = shade(days, part, share);
        if (!filled) return filled;
        total += *filled;
        sum.add(part, days);
        if (progress.partials()->wants()) progress.partials()->take(sum.partial());
        if (watch.seconds() < pictureSeconds / 2) count *= 2;
        if (watch.seconds() > pictureSeconds) count = std::max<std::size_t>(1, count / 2);
    }
    sum.writeTo(field);
    progress.partials()->take(sum.partial());
    return total;
}

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
    const Shade shade = [&](const SunSteps& steps, ShadowField& into, Progress& share) {
        return Projection(casters, receivers, steps, share, stop).run(into);
    };
    const bool watched = progress.partials() != nullptr && sun.dayCount() > 1;
    const auto total =
        watched ? shadeInParts(shade, receivers, sun, field, progress) : shade(sun, field, progress);
    if (!total) return tl::make_unexpected(total.error());
    field.cost.seconds["fill and count"] = watch.seconds() - field.cost.seconds["build"];
    field.cost.skipped["shadows that meet no receiver (casters x steps x bands of rows)"] = total->outOfReach;
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
    const ReceiverCount where(receivers);
    StepFiller filler(casters, where, receivers, sun, {0, receivers.grid.rows});
    const std::size_t words = filler.layout().words();
    std::vector<std::uint64_t> rasters(sun.steps.size() * words);
    std::vector<StepWords> eight(words);
    for (std::size_t first = 0; first < sun.steps.size(); first += stepsTogether) {
        filler.fill(first, {eight.data()->words, words * stepsTogether});
        for (std::size_t step = first; step < std::min(first + stepsTogether, sun.steps.size()); ++step)
            for (std::size_t word = 0; word < words; ++word)
                rasters[step * words + word] = eight[word].words[step - first];
    }
    return rasters;
}

}  // namespace noonmark
