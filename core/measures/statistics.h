#pragma once

#include "core/accumulate/shadow_field.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// Figures of a shadow field over its receivers. All zero where there are none.
struct ShadowStatistics {
    std::size_t receivers = 0;
    double receiverAreaM2 = 0;
    /// Sum over receivers of (share of the sunlit time in shadow x cell area).
    double shadowAreaM2 = 0;
    double meanGrossMin = 0;
    double maxGrossMin = 0;
    double meanContinuousMin = 0;
    double maxContinuousMin = 0;
};

/// Over all receivers of the field. O(cells), sums in double.
ShadowStatistics statisticsOf(const ShadowField& field);

/// Over the receivers whose centres lie in the region.
ShadowStatistics statisticsOf(const ShadowField& field, const Region& region);

}  // namespace noonmark
