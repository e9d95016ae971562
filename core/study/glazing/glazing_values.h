#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/measures/palette.h"
#include "core/study/glazing/glazing_study.h"

namespace noonmark {

/// A value of windows that elevations show, and its scale. The scale follows from the rule alone, so that all
/// sheets of a rule can be compared: it ends at twice the rule's limit.
struct GlazingMeasure {
    std::size_t criterion = 0;  ///< index in Rule::criteria
    std::string title;          ///< "Sun in the room"
    std::string unit;           ///< "hours", "% of the sky's light", "% of the year's probable sun"
    LegendScale scale;          ///< in that unit
    LegendScale changeScale;    ///< of differences: as far as the limit
};

/// The first deciding criterion about time, the first about the sky and the first about probable sun, as far
/// as the rule has them; of a rule without limits the first of each.
std::vector<GlazingMeasure> listGlazingMeasures(const Rule& rule);

/// The value of a window in the measure's unit, before or after. Of a criterion that asks whether a condition
/// is met it is the sun of the day that decides. None: the window has no such value.
std::optional<double> shownValue(const Rule& rule, const GlazingMeasure& measure, const GlazingReview& review,
                                 bool former);

}  // namespace noonmark
