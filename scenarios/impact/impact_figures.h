#pragma once

#include "core/describe/figure.h"
#include "core/measures/shadow_figures.h"
#include "core/receivers/receivers.h"
#include "scenarios/impact/impact.h"

namespace noonmark {

/// Totals of the change of one measure (gross or continuous shadow).
struct ChangeFigures {
    double moreShadowM2 = 0;     ///< area where shadow rose by more than the threshold
    double lessShadowM2 = 0;     ///< area where shadow fell by more than the threshold
    double anyMoreShadowM2 = 0;  ///< area where shadow rose at all
    double anyLessShadowM2 = 0;  ///< area where shadow fell at all
    double meanMin = 0;          ///< over all receivers
    double maxMoreShadowMin = 0;
    double maxLessShadowMin = 0;  ///< >= 0
};

/// The same with trees.
struct ShadeChange {
    TreeColumns column = TreeColumns::seasonal;  ///< or evergreen
    ChangeFigures gross;
    ChangeFigures continuous;
    double shadowAreaChangeM2 = 0;
};

struct ImpactFigures {
    double thresholdMin = 30;
    double receiverAreaM2 = 0;  ///< area of the receivers common to both cities
    ChangeFigures gross;
    ChangeFigures continuous;       ///< all NaN where continuous shadow was not computed
    double shadowAreaChangeM2 = 0;  ///< sum of (share of sunlit time in shadow x cell area)
    double becameBuildingM2 = 0;
    double becameGroundM2 = 0;
    std::vector<ShadeChange> withTrees{};  ///< where trees reach a receiver
};

/// Figures over all receivers. `thresholdMin`: minutes a day for gross shadow, minutes for continuous shadow,
/// 0 or more. The default 30 is that of the paper's case study; Boston's rules use 60. Changes below a
/// thousandth of a minute are float32 rounding and do not count. O(cells), sums in double.
ImpactFigures computeFigures(const Impact& impact, double thresholdMin = 30);

/// The same, with the change of each shade of trees.
ImpactFigures computeFigures(const ImpactStudy& study, double thresholdMin);

/// Figures over the cells whose centres lie in the region.
ImpactFigures computeFigures(const Impact& impact, const Region& region, double thresholdMin = 30);

/// Figures over these cells of the grid, each listed once. O(cells listed).
ImpactFigures computeFigures(const Impact& impact, const std::vector<std::uint32_t>& cells,
                             double thresholdMin = 30);

/// Whether continuous shadow was computed for both fields, as in core/measures/shadow_figures.h. Where it was
/// not, files hold its change as null or an empty field.
inline bool hasRuns(const Impact& impact) { return hasRuns(impact.continuousMin); }
inline bool hasRuns(const ImpactFigures& figures) { return !std::isnan(figures.continuous.meanMin); }

const Figures<ChangeFigures>& changeFigures();

/// The figures of a comparison other than the changes of its two measures (changeFigures()).
const Figures<ImpactFigures>& impactFigures();

/// The figures of a change that files state by threshold: the areas with more and with less shadow.
const std::vector<Figure>& figuresByThreshold();

/// The change of a measure that was not computed: all NaN.
ChangeFigures notComputed();

}  // namespace noonmark
