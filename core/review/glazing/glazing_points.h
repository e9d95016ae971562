#pragma once

#include <vector>

#include "core/engines/points/skyline.h"
#include "core/receivers/points/glazing_pane.h"
#include "core/review/rule/glazing_rule.h"

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
/// the pane faces it, it is swept at the rule's least angle, and, at the inside face, it passes the opening,
/// which is as deep as the wall. What lies outside is looked up from the outside face: the thickness of the
/// wall is small against its distance.
class PaneLimits {
public:
    PaneLimits(const RuleGlazing& rule, const PanePoint& point, PaneSize pane);
    [[nodiscard]] bool lets(glm::dvec3 sun) const;

private:
    glm::dvec3 normal_;
    PaneAxes axes_;
    glm::dvec2 low_, high_;
    double depthM_;        // of the opening; 0: the outside face
    double minSweepSine_;  // 0: any angle
};

}  // namespace noonmark
