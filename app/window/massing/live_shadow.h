#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "core/accumulate/kept_shadows.h"
#include "core/city/city.h"
#include "core/progress.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// The shadow on level ground around a place while a building is being shaped: the city's own is computed
/// once and kept at every step of a day, so that each new shape costs its own polygons only. Of longer
/// periods it is kept at some moments. Exact at all of these (projected shadows). Not for several threads at
/// a time.
class LiveShadow {
public:
    /// A period of so many steps is looked at in whole: twelve hours by the minute.
    static constexpr std::size_t mostSteps = 720;
    /// Moments of a longer one, spread evenly: far apart, each costs more.
    static constexpr std::size_t someMoments = 120;

    /// `city` without what the shape takes the place of; a square of `halfM` metres to each side of `centre`
    /// in 400 x 400 cells. Error: terrain, a sun that never rises, cancelled(). For 43,000 buildings some 0.2
    /// s.
    static Result<std::shared_ptr<LiveShadow>> around(const City& city, glm::dvec2 centre, double halfM,
                                                      const Period& period, const Observer& observer,
                                                      Progress& progress, const std::stop_token& stop);

    /// Shadow of the city and these buildings in place of those before. Single moments know no runs: then
    /// continuousMin is NaN. Error: not enough memory. Some ms.
    [[nodiscard]] Result<ShadowField> with(const std::vector<std::shared_ptr<const Building>>& shape);

    [[nodiscard]] const Receivers& receivers() const { return receivers_; }
    [[nodiscard]] std::size_t moments() const { return moments_; }
    [[nodiscard]] std::size_t momentsOfPeriod() const { return all_; }

private:
    LiveShadow(City around, Receivers receivers, KeptShadows kept)
        : around_(std::move(around)), receivers_(std::move(receivers)), kept_(std::move(kept)) {}

    City around_;  // of the city what shades the square
    Receivers receivers_;
    KeptShadows kept_;
    std::size_t moments_ = 0;
    std::size_t all_ = 0;
    double sunlitMinutesPerDay_ = 0;
};

}  // namespace noonmark
