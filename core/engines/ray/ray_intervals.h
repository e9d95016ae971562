#pragma once

#include "core/engines/common/interval_engine.h"

namespace noonmark {

/// Rays at every step of an interval's own straight sun: with the direction graph around it, what the graph
/// and the straight sun alone do to the ray reference (paper, figure 7). Any ground. Cost: that of the ray
/// reference for each edge.
class RayIntervals final : public IntervalEngine {
public:
    [[nodiscard]] Result<std::unique_ptr<IntervalScene>> prepare(const City& city, const Receivers& receivers,
                                                                 const SunSteps& directions,
                                                                 std::stop_token stop) const override;
    [[nodiscard]] std::string describe() const override;
};

}  // namespace noonmark
