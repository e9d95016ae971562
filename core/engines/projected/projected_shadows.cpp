#include "core/engines/projected/projected_shadows.h"

#include <algorithm>
#include <functional>

#include "core/base/progress_share.h"
#include "core/base/stopwatch.h"
#include "core/engines/api/blank_field.h"
#include "core/engines/api/partial_field.h"
#include "core/engines/common/day_sum.h"
#include "core/engines/common/scattered_order.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/projected/casters/projection.h"
#include "core/engines/projected/filling/step_filler.h"
#include "core/engines/projected/masks/projected_masks.h"
#include "core/engines/projected/projected_breakdown.h"
#include "core/sun/chosen_days.h"

namespace noonmark {

namespace {

using Shade = std::function<Result<FillCount>(const SunSteps&, ShadowField&, Progress&)>;

constexpr double pictureSeconds = 0.1;  // for some seven running results per second

// Processes groups of days scattered over the period, each as large as the time between running
// results allows.
Result<FillCount> shadeInParts(const Shade& shade, const Receivers& receivers, const SunSteps& sun,
                               ShadowField& field, Progress& progress, PartialSink& sink) {
    DaySum sum(receivers, sun);
    FillCount total;
    const std::size_t all = sun.dayCount(), stride = chooseScatteringStride(all);
    for (std::size_t done = 0, count = 1; done < all;) {
        const Stopwatch watch;
        std::vector<std::size_t> numbers(std::min(count, all - done));
        for (std::size_t& number : numbers) number = done++ * stride % all;
        const SunSteps days = chooseDays(sun, numbers);
        ShadowField part = makeBlankField(receivers, days);
        ProgressShare share(progress, done - numbers.size(), all, numbers.size());
        const auto filled = shade(days, part, share);
        if (!filled) return filled;
        total += *filled;
        sum.add(part, days);
        if (sink.wants()) sink.take(sum.partial());
        if (watch.seconds() < pictureSeconds / 2) count *= 2;
        if (watch.seconds() > pictureSeconds) count = std::max<std::size_t>(1, count / 2);
    }
    sum.writeTo(field);
    sink.take(sum.partial());
    return total;
}

Result<ShadowField> fillShadows(const City& city, const Receivers& receivers, const SunSteps& sun,
                                Progress& progress, const std::stop_token& stop) {
    ShadowField field = makeBlankField(receivers, sun);
    field.engine =
        "Projected shadows: each building's shadow filled as polygons at every step, exact on flat ground";
    const Stopwatch watch;
    const std::vector<std::uint32_t> used = findBuildingsInReach(city, receivers, sun, field.cost);
    const ShadowCasters casters = makeShadowCasters(city, used, receivers.grid);
    field.cost.seconds["build"] = watch.seconds();
    const Shade shade = [&](const SunSteps& steps, ShadowField& into, Progress& share) {
        return ShadowProjection(casters, receivers, steps, share, stop).run(into);
    };
    PartialSink* sink = findPartialSink(progress);
    const auto total = sink && sun.dayCount() > 1
                           ? shadeInParts(shade, receivers, sun, field, progress, *sink)
                           : shade(sun, field, progress);
    if (!total) return tl::make_unexpected(total.error());
    field.cost.seconds["fill and count"] = watch.seconds() - field.cost.seconds["build"];
    field.cost.skipped["shadows that meet no receiver (casters x steps x bands of rows)"] = total->outOfReach;
    progress.report(1, "filling shadows");
    return field;
}

}  // namespace

Result<ShadowField> ProjectedShadows::compute(const City& city, const Receivers& receivers,
                                              const SunSteps& sun, Progress& progress,
                                              std::stop_token stop) const {
    return fillShadows(city, receivers, sun, progress, stop);
}

Result<ShadowBreakdown> ProjectedShadows::computeBreakdown(const City& city, const Receivers& receivers,
                                                           const SunSteps& sun, const StepSets& sets,
                                                           bool /*byBuilding*/, Progress& progress,
                                                           std::stop_token stop) const {
    return computeProjectedBreakdown(city, receivers, sun, sets, progress, stop);
}

Result<void> ProjectedShadows::computeStepMasks(std::span<const City* const> cities,
                                                const Receivers& receivers, const SunSteps& sun,
                                                const TakeDay& take, Progress& progress,
                                                std::stop_token stop) const {
    return computeProjectedMasks(cities, receivers, sun, take, progress, stop);
}

Result<std::vector<std::uint64_t>> computeShadowRasters(const City& city, const Receivers& receivers,
                                                        const SunSteps& sun) {
    if (const auto flat =
            checkGround(city, receivers, ProjectedShadows::able, "The raster of projected shadows");
        !flat)
        return tl::make_unexpected(flat.error());
    const ShadowCasters casters =
        makeShadowCasters(city, findBuildingsInReach(city, receivers, sun), receivers.grid);
    const ReceiverCount where(receivers);
    StepFiller filler(casters, where, receivers, sun, {{0, receivers.grid.rows}, 0, receivers.grid.columns});
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
