#pragma once

#include "core/lab/graph/interval_engine.h"

namespace noonmark {

/// Traces rays at every step of an interval's straight sun path. Combined with the direction graph it shows
/// what the graph and the straight path alone do to the ray reference (paper, figure 7). Supports any ground.
/// Costs as much as the ray reference for each edge.
class RayIntervals final : public IntervalEngine {
public:
    [[nodiscard]] Result<std::unique_ptr<IntervalScene>> prepare(const City& city, const Receivers& receivers,
                                                                 const SunSteps& directions,
                                                                 std::stop_token stop) const override;
    [[nodiscard]] std::string_view name() const override {
        return "Ray reference through the direction graph";
    }
    [[nodiscard]] EngineCapabilities capabilities() const override { return able; }
    static constexpr EngineCapabilities able{.terrain = true, .roofs = true};
    [[nodiscard]] std::string describe() const override;
};

}  // namespace noonmark
