#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/engines/points/point_sunlight.h"
#include "core/engines/points/skyline.h"
#include "core/receivers/points/glazing_pane.h"
#include "core/review/criteria/criterion_days.h"
#include "core/review/places/verdict_text.h"
#include "core/review/rule/glazing_rule.h"
#include "core/review/rule/rule_days.h"

namespace noonmark {

/// A place of a window where a rule takes the sun, on the outside of its wall, with the edges of the opening
/// as seen from there, in metres along PaneAxes.
struct PanePoint {
    SkyPoint point;
    glm::dvec2 low{0}, high{0};
};

/// The points of a rule on a window; `middle` is its receiver. A pane that is not known has the sizes that
/// the rule's opening states. One point, or two at both ends of the sill. A height above the sill ends at the
/// top of the pane.
std::vector<PanePoint> placePanePoints(const RuleGlazing& rule, const SkyPoint& middle, PaneSize pane);

/// The pane with the sizes of the rule's opening where it is not known.
PaneSize sizeOrOpening(const RuleGlazing& rule, PaneSize pane);

/// Whether the sun from that direction comes through the window at that point, if nothing outside hides it:
/// the pane faces it, seen from above they make at least the rule's angle, and, at the inside face, it passes
/// the opening, which is as deep as the wall. What lies outside is looked up from the outside face: the
/// thickness of the wall is small against its distance.
class PaneLimits {
public:
    PaneLimits(const RuleGlazing& rule, const PanePoint& point, PaneSize pane);
    [[nodiscard]] bool admits(glm::dvec3 sun) const;

private:
    glm::dvec3 normal_;
    PaneAxes axes_;
    glm::dvec2 low_, high_;
    double depthM_;        // of the opening; 0: the outside face
    double minSweepSine_;  // 0: any angle
};

/// What windows of a rule are called and where they are.
struct ReviewedGlazing {
    std::string id;  ///< unique; of a room or a dwelling its name with that of the building
    std::string building, buildingName;  ///< id and name; empty: the window is at no building
    int floor = 0;
    std::optional<double> azimuthDeg;  ///< that it faces, from true north; none: a roof light
    int windows = 1;                   ///< how many are judged together
};

/// The share of the sun that crowns let through to a window at each step, 0 where something solid hides it.
/// Empty: no crown can take any, and what is lit has all of it.
using SunShares = std::vector<float>;

/// The sun of one window, or of the windows of a room, at the steps of a rule, and its sky.
struct GlazingSunlight {
    ShadedSteps after;                  ///< in the scenario; by step of RuleSun
    std::optional<ShadedSteps> before;  ///< in the baseline; none: its building is not there
    SunShares shares, formerShares;     ///< the same by what crowns leave; read for Measure::probableSun
    double skyComponentPct = 0;         ///< read only if a criterion asks for it
    double formerSkyComponentPct = 0;
};

/// A rule's answer for one window.
struct GlazingReview {
    ReviewedGlazing window;
    Verdict verdict = Verdict::notChecked;
    Verdict formerVerdict = Verdict::notApplicable;  ///< of the baseline, held against itself
    std::optional<std::size_t> deciding;             ///< the criterion whose result is the verdict
    std::string reasonNotJudged;                     ///< why none decides; a sentence without a full stop
    std::vector<CriterionResult> results;            ///< by criterion of the rule, with former values
    std::vector<Verdict> formerVerdicts;             ///< by criterion
    /// The day of the bands: the one that decides, or the rule's only day; none for sums over the year.
    std::optional<CivilDate> day;
    std::vector<SunBand> bands, formerBands;  ///< times in the sun on that day
};

/// The least error of a vertical sky component that is computed from an exact skyline, in percent of the sky.
inline constexpr double skyComponentErrorPct = 0.1;

/// Evaluates a rule about windows. `engineErrorMin`: as of PlaceEvaluation. A pure function; some 10 ns for a
/// step and criterion. The steps are those of `sun`.
GlazingReview reviewGlazing(const Rule& rule, const RuleSun& sun, const ReviewedGlazing& window,
                            const GlazingSunlight& light, double engineErrorMin = 0);

/// The verdict on a window in a sentence without a full stop, as describeReason() of a place.
std::string describeReason(const Rule& rule, const GlazingReview& review, WriteDate writeDate = formatText);

}  // namespace noonmark
