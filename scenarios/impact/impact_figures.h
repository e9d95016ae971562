#pragma once

#include "core/receivers/region.h"
#include "scenarios/impact/impact.h"

namespace noonmark {

/// Figures of one measure's change (gross or continuous). A gain is more shadow, a loss less.
struct ChangeFigures {
    double gainedM2 = 0;   ///< area where it rose by more than the threshold
    double lostM2 = 0;     ///< area where it fell by more than the threshold
    double touchedM2 = 0;  ///< area where it rose at all
    double easedM2 = 0;    ///< area where it fell at all
    double meanMin = 0;    ///< over all receivers
    double mostGainedMin = 0;
    double mostLostMin = 0;  ///< >= 0
};

struct ImpactFigures {
    double thresholdMin = 30;
    double receiverAreaM2 = 0;  ///< receivers in both cities
    ChangeFigures gross;
    ChangeFigures continuous;       ///< all NaN where runs were not counted
    double shadowAreaChangeM2 = 0;  ///< of the sum of (share of the sunlit time in shadow x cell area)
    double becameBuildingM2 = 0;
    double becameGroundM2 = 0;
};

/// Over all receivers. `thresholdMin`: minutes a day for gross, minutes for continuous, 0 or more; the
/// default of the paper's case study is 30, Boston's rules ask for 60. A change below a thousandth of a
/// minute is none: float32 rounding. O(cells), sums in double.
ImpactFigures computeFigures(const Impact& impact, double thresholdMin = 30);

/// Over the cells whose centres lie in the region.
ImpactFigures computeFigures(const Impact& impact, const Region& region, double thresholdMin = 30);

}  // namespace noonmark
