#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>

namespace noonmark {

/// Minutes of one receiver twice: by an engine, and by the ray reference over the same steps.
struct ComparedCell {
    glm::dvec2 centreM{0};  ///< local metres
    double grossMin = 0;    ///< minutes a day
    double referenceGrossMin = 0;
    double continuousMin = 0;  ///< NaN where runs were not counted
    double referenceContinuousMin = 0;
};

/// How far cells are off, either way: figures of the absolute differences. Minutes; %, of `wholeMin`.
struct CellError {
    double meanMin = 0;
    double p99Min = 0;  ///< 99 % of the cells are off by no more
    double maxMin = 0;
    glm::dvec2 worstM{0};  ///< centre of the cell that is off most, local metres
    double wholeMin = 0;   ///< what is 100 %

    [[nodiscard]] double percent(double minutes) const { return wholeMin > 0 ? 100 * minutes / wholeMin : 0; }
};

/// An engine's error on a sample of receivers. The area error is the engine's shadow area less the
/// reference's, over the area of the receivers; the true one of all receivers lies within two standard errors
/// of it 19 times out of 20. A worst cell is the worst of the sample: others may be worse.
struct SampledError {
    std::size_t receivers = 0;        ///< compared
    std::size_t ofReceivers = 0;      ///< how many there are
    std::uint64_t rays = 0;           ///< traced to know the truth
    double areaPct = 0;               ///< of the receivers' area
    double areaStandardErrorPct = 0;  ///< of areaPct, from the spread of the sample
    CellError gross;                  ///< of the sunlit minutes of a mean day
    CellError continuous;  ///< of the sunlit minutes of the longest day; minutes are NaN without runs
};

/// Figures of a sample; all zero for an empty one. `sunlitMinutesPerDay` and `longestDayMin` are 100 % of
/// gross and continuous shadow, minutes. O(n log n).
SampledError errorOf(std::span<const ComparedCell> cells, double sunlitMinutesPerDay, double longestDayMin);

}  // namespace noonmark
