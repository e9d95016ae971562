#pragma once

#include <memory>
#include <optional>
#include <stop_token>

#include "app/window/massing/live_receivers.h"
#include "app/window/massing/live_rule.h"
#include "app/window/view/shared_horizon_cache.h"
#include "core/base/progress.h"
#include "core/engines/projected/shadow_cache.h"
#include "scenarios/edits/apply_edits.h"

namespace noonmark {

/// What the live shadow is asked: as a study is.
struct LiveQuestion {
    SunQuestion sun;
    Region region;
    ReceiverSettings receivers;
    bool onRegion = false;  ///< on the region's cells where it can be; else in a square around the shape
    bool operator==(const LiveQuestion&) const = default;
};

/// Where something is shaped.
struct LivePlace {
    City rest;             ///< the city without what the shape takes the place of
    ChangedVolume volume;  ///< around what goes and comes first; not empty
    double halfM = 200;    ///< of the square, to each side
};

/// The shadow with a shape, and how it was worked out.
struct LiveAnswer {
    ShadowField field;  ///< without `runs` its continuousMin is NaN
    Receivers receivers;
    LiveEngine engine = LiveEngine::shadows;
    std::size_t counted = 0;  ///< steps that it is of
    std::size_t steps = 0;    ///< of the period
    bool runs = true;
};

/// The shadow around a place while something is shaped there: the city's own is worked out once and stays, so
/// that each new shape costs what it changes only. By the first engine of liveEngines() that can do it.
class LiveShadow {
public:
    /// `horizons` outlives it. On the region's cells where the question says so, they are not too many and a
    /// shadow from the place can reach them; else in a square of 400 x 400 cells. Error: a sun that never
    /// rises, what no engine can do, cancelled(). Polygons: for 43,000 buildings some 0.2 s; horizons of a
    /// year: up to some seconds.
    static Result<std::shared_ptr<LiveShadow>> at(LivePlace place, const LiveQuestion& question,
                                                  std::shared_ptr<SharedHorizonCache> horizons,
                                                  Progress& progress, const std::stop_token& stop);

    /// Shadow of the city and these buildings in place of those before. `counts`: of horizons; polygons
    /// always know the runs, and single moments never do. Error: too little memory, more that hangs than
    /// horizons take, cancelled(). By polygons for one thread at a time.
    [[nodiscard]] Result<LiveAnswer> with(const LiveReceivers::Shape& shape, ShadowCounts counts,
                                          Progress& progress, const std::stop_token& stop);

    [[nodiscard]] const Receivers& receivers() const { return receivers_.base(); }
    [[nodiscard]] LiveEngine engine() const { return engine_; }

private:
    LiveShadow(City city, LiveReceivers receivers, const LiveQuestion& question,
               std::shared_ptr<SharedHorizonCache> horizons)
        : city_(std::move(city)),
          receivers_(std::move(receivers)),
          sun_(question.sun),
          places_(question.receivers.places),
          horizons_(std::move(horizons)) {}
    Result<void> begin(const SunSteps& sun, Progress& progress, const std::stop_token& stop);
    Result<void> begin(LiveEngine engine, const SunSteps& sun, Progress& progress,
                       const std::stop_token& stop);
    Result<ShadowField> fieldOf(const City& city, const Receivers& receivers, ShadowCounts counts,
                                Progress& progress, const std::stop_token& stop);
    void spreadMoments(ShadowField& field) const;
    void leaveGroundOut(LiveAnswer& answer) const;

    City city_;
    LiveReceivers receivers_;
    SunQuestion sun_;
    ReceiverPlaces places_;
    std::shared_ptr<SharedHorizonCache> horizons_;
    std::optional<ShadowCache> shadows_;  // of engines that keep them
    LiveEngine engine_ = LiveEngine::shadows;
    std::size_t counted_ = 0;
    std::size_t steps_ = 0;
    double sunlitMinutesPerDay_ = 0;
};

}  // namespace noonmark
