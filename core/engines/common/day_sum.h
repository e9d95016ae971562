#pragma once

#include <cstdint>
#include <vector>

#include "core/engines/api/partial_field.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Puts the field of a long period together from fields of some of its days. Counts steps: the result is the
/// same bit for bit however the days are parted.
class DaySum {
public:
    /// Both outlive this.
    DaySum(const Receivers& receivers, const SunSteps& sun);

    /// `part` is the field of `days`, some of the period's, each added once; its minutes count whole steps,
    /// fewer than 2^24 a cell.
    void add(const ShadowField& part, const SunSteps& days);

    /// grossMin and continuousMin of the days so far.
    void writeTo(ShadowField& field) const;

    /// What is known so far.
    [[nodiscard]] PartialField partial() const;

private:
    const Receivers& receivers_;
    const SunSteps& sun_;
    std::vector<std::uint32_t> steps_;  // in shadow, of each receiver
    std::vector<float> longestMin_;
    std::size_t days_ = 0;
    std::size_t sunlit_ = 0;  // steps
};

}  // namespace noonmark
