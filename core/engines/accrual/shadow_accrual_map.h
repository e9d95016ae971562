#pragma once

#include <memory>

#include "core/engines/accrual/accrual_settings.h"
#include "core/engines/common/interval_engine.h"

namespace noonmark {

/// Shadow accrual maps (paper, section 4) on the processor, for flat ground: the city is placed once an
/// interval; each of its steps is a slice, a depth map that differs from the others by a shear alone; one
/// slice a task, on all cores. A slice is looked up as soon as it is drawn, so that no more than one a thread
/// is in memory. Error: the sun's straight path, and, where texels do not lie on cells, half a texel.
class ShadowAccrualMap final : public IntervalEngine {
public:
    /// Error when a setting is out of range.
    static Result<std::shared_ptr<const ShadowAccrualMap>> make(const AccrualSettings& settings);

    [[nodiscard]] Result<std::unique_ptr<IntervalScene>> prepare(const City& city, const Receivers& receivers,
                                                                 const SunSteps& directions,
                                                                 std::stop_token stop) const override;
    [[nodiscard]] std::string_view name() const override { return "Shadow accrual map"; }
    [[nodiscard]] std::string describe() const override;

private:
    explicit ShadowAccrualMap(AccrualSettings settings);
    AccrualSettings settings_;
};

}  // namespace noonmark
