#pragma once

#include "core/engines/api/shadow_field.h"
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
    double meanContinuousMin = 0;  ///< NaN, as the largest, where runs were not counted
    double maxContinuousMin = 0;
};

/// What the figures of several pieces of one field are made from. Pieces have the same period and cell size.
struct ShadowSums {
    std::size_t receivers = 0;
    double grossMin = 0;       ///< sum over the receivers
    double continuousMin = 0;  ///< NaN where runs of a receiver were not counted
    double maxGrossMin = 0;
    double maxContinuousMin = 0;

    void add(const ShadowSums& piece);
};
ShadowSums computeSums(const ShadowField& field);

/// Figures of the sums; `sunlitMinutesPerDay` and `cellAreaM2` as the pieces have them.
ShadowStatistics computeStatistics(const ShadowSums& sums, double sunlitMinutesPerDay, double cellAreaM2);

/// Over all receivers of the field. O(cells), sums in double.
ShadowStatistics computeStatistics(const ShadowField& field);

/// Over the receivers whose centres lie in the region.
ShadowStatistics computeStatistics(const ShadowField& field, const Region& region);

}  // namespace noonmark
