#pragma once

#include <memory>
#include <stop_token>
#include <vector>

#include "core/accumulate/shadow_field.h"
#include "core/city/city.h"
#include "core/progress.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// The shadow on level ground around a place while a building is being shaped: the city's own is computed
/// once and kept bit by bit for some moments of the period, and each new shape costs its own polygons only.
/// Exact at those moments (projected shadows). Immutable.
class LiveShadow {
public:
    /// Moments looked at, spread evenly over the period's: more cost time at every picture.
    static constexpr std::size_t mostMoments = 120;

    /// `city` without what the shape takes the place of; a square of `halfM` metres to each side of `centre`
    /// in 400 x 400 cells. Error: terrain, a sun that never rises, cancelled(). For 43,000 buildings some 0.1
    /// s.
    static Result<std::shared_ptr<const LiveShadow>> around(const City& city, glm::dvec2 centre, double halfM,
                                                            const Period& period, const Observer& observer,
                                                            Progress& progress, const std::stop_token& stop);

    /// Gross shadow of the city and these buildings; single moments know no runs: continuousMin is NaN. Some
    /// ms.
    [[nodiscard]] ShadowField with(const std::vector<std::shared_ptr<const Building>>& shape) const;

    [[nodiscard]] const Receivers& receivers() const { return receivers_; }
    [[nodiscard]] std::size_t moments() const { return sun_.steps.size(); }
    [[nodiscard]] std::size_t momentsOfPeriod() const { return all_; }

private:
    LiveShadow() = default;

    Receivers receivers_;
    SunSteps sun_;  // the moments
    std::size_t all_ = 0;
    ShadowField blank_;
    std::vector<std::uint64_t> rasters_;
};

}  // namespace noonmark
