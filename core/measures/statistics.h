#pragma once

// The folder core/measures turns shadow fields into numbers and colours: means, largest values and shadow
// areas (this file), the error of an engine on a sample of receivers (error_sample.h selects and compares
// them, sampled_error.h holds the result, compared_cells.h does it in an existing ray scene), the colours of
// maps (palette.h), and whether continuous shadow was counted (has_runs.h).

#include "core/engines/api/shadow_field.h"
#include "core/receivers/receivers.h"

namespace noonmark {

/// Statistics of a shadow field over its receivers. All zero if there are none.
struct ShadowStatistics {
    std::size_t receivers = 0;
    double receiverAreaM2 = 0;
    /// Sum over receivers of (share of the sunlit time in shadow x cell area).
    double shadowAreaM2 = 0;
    double meanGrossMin = 0;
    double maxGrossMin = 0;
    double meanSunMin = 0;  ///< sunlit time minus gross shadow; NaN in results saved before it was stated
    double meanContinuousMin = 0;  ///< NaN, like the largest, if runs were not counted
    double maxContinuousMin = 0;
    double waterM2 = 0;  ///< of the region's cells on water, which are no receivers; of whole fields only
};

/// Sums from which the statistics of a field in several pieces are computed. All pieces have the same period
/// and cell size.
struct ShadowSums {
    std::size_t receivers = 0;
    double grossMin = 0;       ///< sum over the receivers
    double continuousMin = 0;  ///< NaN if the runs of a receiver were not counted
    double maxGrossMin = 0;
    double maxContinuousMin = 0;

    void add(const ShadowSums& piece);
};
ShadowSums computeSums(const ShadowField& field);

/// Statistics from sums; `sunlitMinutesPerDay` and `cellAreaM2` as in the pieces.
ShadowStatistics computeStatistics(const ShadowSums& sums, double sunlitMinutesPerDay, double cellAreaM2);

/// Over all receivers of the field. O(cells), sums in double.
ShadowStatistics computeStatistics(const ShadowField& field);

/// Over the receivers whose centres lie in the region.
ShadowStatistics computeStatistics(const ShadowField& field, const Region& region);

}  // namespace noonmark
