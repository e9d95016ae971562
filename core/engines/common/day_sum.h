#pragma once

#include <cstdint>
#include <vector>

#include "core/engines/api/partial_field.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

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

}  // namespace noonmark
