#include "core/engines/projected/casters/projection.h"

#include <tbb/blocked_range.h>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/engines/projected/counting/shadow_events.h"

namespace noonmark {

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
    progress_.report(std::min(1.0, double(done_ += stepsTogether) / all), "filling shadows");
    return !stop_.stop_requested();
}

}  // namespace noonmark
