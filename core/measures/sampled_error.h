#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>

#include "core/engines/api/engine.h"

namespace noonmark {

/// The minutes of one receiver by an engine, and by the ray reference over the same steps.
struct ComparedCell {
    glm::dvec2 centreM{0};  ///< local metres
    double grossMin = 0;    ///< minutes per day
    double referenceGrossMin = 0;
    double continuousMin = 0;  ///< NaN if runs were not counted
    double referenceContinuousMin = 0;
};

/// Statistics of the absolute differences of cells. In minutes; percent() converts to % of `wholeMin`.
struct CellError {
    double meanMin = 0;
    double meanStandardErrorMin = 0;  ///< standard error of the mean, from the spread of the sample
    double p99Min = 0;                ///< 99 % of the cells differ by no more than this
    double maxMin = 0;
    glm::dvec2 worstM{0};  ///< centre of the cell with the largest difference, local metres
    double wholeMin = 0;   ///< minutes that are 100 %

    [[nodiscard]] double percent(double minutes) const { return wholeMin > 0 ? 100 * minutes / wholeMin : 0; }
};

/// An engine's error on a sample of receivers. The area error is the engine's shadow area minus the
/// reference's, divided by the area of the receivers; the true error over all receivers lies within two
/// standard errors of it 19 times out of 20. The worst cell is the worst of the sample; other cells may be
/// worse.
struct SampledError {
    std::size_t receivers = 0;        ///< number of receivers compared
    std::size_t ofReceivers = 0;      ///< number of all receivers
    std::uint64_t rays = 0;           ///< rays traced for the reference
    double areaPct = 0;               ///< % of the receivers' area
    double areaStandardErrorPct = 0;  ///< standard error of areaPct, from the spread of the sample
    CellError gross;                  ///< 100 % is the sunlit minutes of a mean day
    CellError continuous;  ///< 100 % is the sunlit minutes of the longest day; minutes are NaN without runs

    /// What error targets of engines are about.
    [[nodiscard]] SampledOff grossOff() const {
        return {gross.percent(gross.meanMin), gross.percent(gross.meanStandardErrorMin)};
    }
};

/// Statistics of a sample; all zero for an empty one. `sunlitMinutesPerDay` and `longestDayMin` are 100 % of
/// gross and continuous shadow, minutes. O(n log n).
SampledError errorOf(std::span<const ComparedCell> cells, double sunlitMinutesPerDay, double longestDayMin);

}  // namespace noonmark
