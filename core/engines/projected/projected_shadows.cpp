#include "core/engines/projected/projected_shadows.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>

#include "core/base/safe_text.h"
#include "core/describe/text.h"
#include "core/engines/api/shadow_field.h"
#include "core/engines/common/receiver_tiles.h"
#include "core/engines/common/shadow_reach.h"
#include "core/engines/projected/counting/shadow_events.h"
#include "core/engines/projected/filling/step_filler.h"
#include "core/engines/projected/masks/projected_masks.h"

namespace noonmark {

/// Combines fields of subsets of a long period's days into the field of the period. Counts steps, so the
/// result is the same bit for bit however the days are divided.
class DaySum {
public:
    /// Both must outlive this object.
    DaySum(const Receivers& receivers, const SunSteps& sun);

    /// `part` is the field of `days`, a subset of the period's days; each day is added once. Its minutes are
    /// whole steps, fewer than 2^24 per cell.
    void add(const ShadowField& part, const SunSteps& days);

    /// Writes grossMin and continuousMin of the days added so far.
    void writeTo(ShadowField& field) const;

    /// The running result of the days added so far.
    [[nodiscard]] PartialField partial() const;

private:
    const Receivers& receivers_;
    const SunSteps& sun_;
    std::vector<std::uint32_t> steps_;  // steps in shadow, per receiver
    std::vector<float> longestMin_;
    std::size_t days_ = 0;
    std::size_t sunlit_ = 0;  // sunlit steps
};

DaySum::DaySum(const Receivers& receivers, const SunSteps& sun)
    : receivers_(receivers), sun_(sun), steps_(receivers.cells.size()), longestMin_(receivers.cells.size()) {}

void DaySum::add(const ShadowField& part, const SunSteps& days) {
    const double stepsAMinute = part.days / part.stepMinutes;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        const std::uint32_t cell = receivers_.cells[i];
        steps_[i] += std::uint32_t(std::lround(double(part.grossMin[cell]) * stepsAMinute));
        longestMin_[i] = std::max(longestMin_[i], part.continuousMin[cell]);
    }
    days_ += days.dayCount();
    sunlit_ += days.steps.size();
}

void DaySum::writeTo(ShadowField& field) const {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        const std::uint32_t cell = receivers_.cells[i];
        field.grossMin[cell] = float(double(steps_[i]) * field.stepMinutes / field.days);
        field.continuousMin[cell] = longestMin_[i];
    }
}

PartialField DaySum::partial() const {
    PartialField partial{makeBlankField(receivers_, sun_), double(days_) / double(sun_.dayCount()),
                         fmt::format("{} of {}", days_, countOf(sun_.dayCount(), "day"))};
    writeTo(partial.field);
    partial.field.sunlitMinutesPerDay = double(sunlit_) * sun_.stepMinutes / partial.field.days;
    return partial;
}

/// Fills the shadows of casters at the steps of a period and counts the receivers' minutes, window by window,
/// so that the raster and the counts of a window stay in cache. Uses all cores.
class ShadowProjection {
public:
    /// All arguments except `stop` must outlive this object.
    ShadowProjection(const ShadowCasters& casters, const Receivers& receivers, const SunSteps& sun,
                     Progress& progress, std::stop_token stop);

    /// Writes minutes to the receivers' cells of a blank field. Error: cancelled().
    Result<FillCount> run(ShadowField& field);

private:
    FillCount count(const FillWindow& window, ShadowField& field);
    bool goOn();

    const ShadowCasters& casters_;
    const Receivers& receivers_;
    const SunSteps& sun_;
    ReceiverCount where_;
    std::vector<RunStarts> starts_;
    std::vector<FillWindow> windows_;
    Progress& progress_;
    std::stop_token stop_;
    std::atomic<std::size_t> done_{0};  // steps x windows
};

ShadowProjection::ShadowProjection(const ShadowCasters& casters, const Receivers& receivers,
                                   const SunSteps& sun, Progress& progress, std::stop_token stop)
    : casters_(casters),
      receivers_(receivers),
      sun_(sun),
      where_(receivers),
      starts_(findRunStarts(sun)),
      windows_(windowsOf(receivers)),
      progress_(progress),
      stop_(std::move(stop)) {}

Result<FillCount> ShadowProjection::run(ShadowField& field) {
    tbb::combinable<FillCount> counts;
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, windows_.size(), 1),
        [&](const auto& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i)
                counts.local() += count(windows_[i], field);
        },
        tbb::simple_partitioner());
    if (stop_.stop_requested()) return cancelled();
    return counts.combine([](FillCount a, const FillCount& b) { return a += b; });
}

FillCount ShadowProjection::count(const FillWindow& window, ShadowField& field) {
    if (stop_.stop_requested()) return {};
    StepFiller filler(casters_, where_, receivers_, sun_, window);
    ShadowEvents events(filler.layout(), window.band, filler.noReceivers());
    std::vector<StepWords> rasters(filler.layout().words());
    const std::span words(rasters.data()->words, rasters.size() * stepsTogether);
    for (std::size_t step = 0; step < sun_.steps.size(); step += stepsTogether) {
        if (!goOn()) return {};
        filler.fill(step, words);
        events.add(words, starts_[step / stepsTogether]);
    }
    events.finish(sun_.steps.size(), field);
    return filler.count();
}

// Reports that eight more steps of a window are done, and returns whether to continue.
bool ShadowProjection::goOn() {
    const double all = double(sun_.steps.size()) * double(windows_.size());
    progress_.report(std::min(1.0, double(done_ += stepsTogether) / all), NM_TEXT("filling shadows"));
    return !stop_.stop_requested();
}

Result<ShadowBreakdown> computeProjectedBreakdown(const City& city, const Receivers& receivers,
                                                  const SunSteps& sun, const StepSets& sets,
                                                  Progress& progress, const std::stop_token& stop) {
    const ShadowCasters casters =
        makeShadowCasters(city, findBuildingsInReach(city, receivers, sun), receivers.grid);
    ShadowBreakdown breakdown{receivers.grid, sets, sets.sunlitMinutes(sun), receivers.cells, {}, {}, {}, {}};
    breakdown.engine =
        NM_TEXT("Projected shadows: exact on flat ground, one run for all months and intervals");
    for (std::size_t set = 0; set < sets.names.size(); ++set) {
        const SunSteps own = sets.stepsOf(set, sun);
        ShadowField field = makeBlankField(receivers, own);
        field.days = 1;  // so that minutes are totals
        ProgressShare share(progress, set, sets.names.size());
        if (const auto filled = ShadowProjection(casters, receivers, own, share, stop).run(field); !filled)
            return tl::make_unexpected(filled.error());
        breakdown.minutes.push_back(valuesAt(receivers.cells, field.grossMin));
    }
    return breakdown;
}

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
    field.engine = NM_TEXT(
        "Projected shadows: each building's shadow filled as polygons at every step, exact on flat ground");
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
    progress.report(1, NM_TEXT("filling shadows"));
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
