#pragma once

// The folder core/measures turns shadow fields into numbers and colours: means, largest values and shadow
// areas (this file); the error of an engine on a sample of receivers (error_sample.h); the colours of maps
// (palette.h, colour_scale.h) and what a user chose for their legends (legend_choice.h); and whether
// continuous shadow was counted (shadow_figures.h).

#include <span>
#include <vector>

#include "core/describe/answer_page.h"
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

/// How much of the whole gets how many hours of sun a day, in % of it. `sunMin`: minutes of sun a day of
/// parts of equal size; NaN: no part of it. `possibleMin`: the most that is possible. Classes of a quarter,
/// half, one or two hours, at most 14, each with its lower limit; the last one with its upper limit, too. No
/// groups: no part, or no sun.
Bars makeSunHistogram(std::span<const double> sunMin, double possibleMin, std::string_view title);
/// The histogram of the area of a field's receivers.
Bars makeSunHistogram(const ShadowField& field);

/// How much area changes by how many minutes, m2. `minutes`: of each cell of `cellAreaM2`; NaN: no receiver.
/// Cells that change by no more than `noChangeMin` are left out. Classes of equal width, at most 14. Where
/// sun is shown, minutes of sun that are gained or lost.
Bars makeChangeHistogram(std::span<const float> minutes, double cellAreaM2, double noChangeMin,
                         ShownAs show = ShownAs::shadow);

}  // namespace noonmark
