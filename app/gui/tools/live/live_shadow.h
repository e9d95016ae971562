#pragma once

#include <QString>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

#include "app/gui/session/study/shared_horizon_cache.h"
#include "app/gui/tools/live/live_change.h"
#include "core/base/progress.h"
#include "core/city/city.h"
#include "core/engines/projected/shadow_cache.h"
#include "core/receivers/receivers.h"
#include "scenarios/edits/apply_edits.h"

namespace noonmark {

/// The method of the live shadow.
enum class LiveEngine {
    /// The projected polygons of each building at every step are cached (shadow_cache.h): exact, on level
    /// ground only.
    shadows,
    /// Horizons are cached (shared_horizon_cache.h): any period, any receivers; the azimuth is off by up to
    /// half a bin.
    horizons,
    /// As `shadows`, at some moments spread over the period: exact at these only.
    moments,
};

struct LiveLimits {
    /// Up to this many steps, polygons of each step are cached: twelve hours minute by minute.
    static constexpr std::size_t maxSteps = 720;
    /// Number of moments of a longer period. Fewer than maxSteps, since moments far apart cost more each.
    static constexpr std::size_t sampledMoments = 120;
    /// A region with more cells is too slow to follow, and the horizons of a year would not fit into the
    /// cache: a square around the shape is used instead.
    static constexpr std::size_t maxCells = std::size_t{1} << 20U;
};

/// The methods for a city, receivers and number of steps, the best first; if one refuses (too many overhangs,
/// too little memory) the next is tried. Polygons where they are exact, else horizons; moments only on level
/// ground and if horizons cannot be cached.
std::vector<LiveEngine> liveEngines(const City& city, ReceiverPlaces places, std::size_t steps);

/// How exact a live shadow is, for the note beside the legend. `counted` of `steps` steps are computed;
/// `runs`: continuous shadow is included.
QString describeExactness(LiveEngine engine, std::size_t counted, std::size_t steps, bool runs);

/// The receivers of a city in which one shape changes. The receivers of the rest are computed once; for each
/// shape only the cells around it are updated.
class LiveReceivers {
public:
    using Shape = std::vector<std::shared_ptr<const Building>>;

    /// `city` is the city without the shape. Errors as of placeReceivers().
    static Result<LiveReceivers> of(const City& city, const Region& region, const ReceiverSettings& settings,
                                    const std::stop_token& stop);

    [[nodiscard]] const Receivers& base() const { return base_; }
    /// The receivers of the city with these buildings: the same, cell for cell, as those of placeReceivers().
    [[nodiscard]] Receivers with(const Shape& shape) const;

private:
    void patch(Receivers& receivers, const Building& added, const Shape& shape) const;

    City near_;  // the buildings in the region's bounding box
    Region region_;
    ReceiverPlaces places_ = ReceiverPlaces::ground;
    Receivers base_;
};

/// The settings of the live shadow, as those of a study.
struct LiveQuestion {
    SunQuestion sun;
    Region region;
    ReceiverSettings receivers;
    /// On the region's cells if possible; else in a square around the shape.
    bool onRegion = false;
    /// Where the change is measured too.
    std::vector<Place> places{};
    bool operator==(const LiveQuestion&) const = default;
};

/// The place where a shape is edited.
struct LivePlace {
    City rest;             ///< the city without the buildings that the shape replaces
    ChangedVolume volume;  ///< around the buildings removed and added first; not empty
    double halfM = 200;    ///< half width of the square
    /// The city that the shape is compared with; null: none.
    std::shared_ptr<const City> baseline{};
};

/// The shadow with a shape, and how it was computed.
struct LiveAnswer {
    ShadowField field;  ///< NaN in continuousMin if `runs` is false
    Receivers receivers;
    LiveEngine engine = LiveEngine::shadows;
    std::size_t counted = 0;  ///< steps computed
    std::size_t steps = 0;    ///< steps of the period
    bool runs = true;
    /// Against the baseline; none: there is none, or receivers are on roofs only.
    std::optional<LiveChange> change{};
};

/// The shadow around a place while a shape is edited there. The shadow of the rest of the city is computed
/// once and cached, so that each new shape costs only what it changes. Uses the first of liveEngines() that
/// succeeds.
class LiveShadow {
public:
    /// Uses the region's cells if the question says so, they are not too many and a shadow from the place can
    /// reach them; else a square of 400 x 400 cells. The baseline's shadow is computed too. Error: the
    /// sun never rises, no method succeeds, cancelled(). Polygons take about 0.2 s for 43,000 buildings;
    /// horizons of a year up to some seconds.
    static Result<std::shared_ptr<LiveShadow>> at(LivePlace place, const LiveQuestion& question,
                                                  std::shared_ptr<SharedHorizonCache> horizons,
                                                  Progress& progress, const std::stop_token& stop);

    /// The shadow of the city with these buildings instead of those before. `counts` applies to horizons
    /// only: polygons always include continuous shadow, moments never do. Error: too little memory, too many
    /// overhangs for horizons, cancelled(). With polygons, call it from one thread at a time; with horizons,
    /// a cancelled call may still run beside the next one.
    [[nodiscard]] Result<LiveAnswer> with(const LiveReceivers::Shape& shape, ShadowCounts counts,
                                          Progress& progress, const std::stop_token& stop);

    [[nodiscard]] const Receivers& receivers() const { return receivers_.base(); }
    [[nodiscard]] LiveEngine engine() const { return engine_; }

private:
    /// What each shape is compared with.
    struct Baseline {
        City city;
        Receivers receivers;
        std::shared_ptr<const ShadowField> field{};
    };
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
    Result<void> addBaseline(Baseline baseline, const SunSteps& sun, Progress& progress,
                             const std::stop_token& stop);
    Result<void> compare(ShadowCounts counts, LiveAnswer& answer, Progress& progress,
                         const std::stop_token& stop);
    Result<std::shared_ptr<const ShadowField>> baselineField(ShadowCounts counts, Progress& progress,
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
    std::optional<Baseline> baseline_;
    std::mutex baselineField_;  // of its field, which the next call may read while a cancelled one ends
    std::vector<GridPlace> placeCells_;
    std::optional<ShadowCache> shadows_;  // if the method caches polygons
    LiveEngine engine_ = LiveEngine::shadows;
    std::size_t counted_ = 0;
    std::size_t steps_ = 0;
    double sunlitMinutesPerDay_ = 0;
};

}  // namespace noonmark
