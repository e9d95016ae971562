#pragma once

#include <optional>
#include <stop_token>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/city/city.h"
#include "core/io/shadows/shadow_drawing.h"
#include "core/review/rule/rule_days.h"
#include "core/study/review_study.h"

namespace noonmark {

struct DrawingSettings {
    /// None: a box around what the scenario changes and the places that its shadows reach, cut where these
    /// end; without places, around its shadows; without a change, around the places, or else the city.
    std::optional<Box2> area;
    double longestM = 1500;  ///< of the shadows that bound the area
    double cellM = 1;        ///< on terrain, 0.25 to 10
    bool withFans = true;
    std::optional<double> planeM{};  ///< shadows on a plane above the mean ground; empty: on the ground
};

/// The shadows of a baseline and a scenario (null: the baseline alone) at several times, with buildings,
/// places and, of the scenario, each day's fan. Errors of outlineShadows(), and where there is no area.
Result<ShadowDrawing> drawShadows(const City& baseline, const City* scenario,
                                  const std::vector<Place>& places, const std::vector<DrawnTime>& times,
                                  const DrawingSettings& settings, Progress& progress,
                                  const std::stop_token& stop);

/// The moments of a review to draw: computeRuleMoments(), and of a rule about a range of days also the day of
/// most incremental shadow on any place. Sheets and drawings show the same days.
Result<std::vector<RuleMoment>> computeReviewMoments(const ReviewStudy& study, const City& baseline,
                                                     int maxHoursADay, const std::stop_token& stop);

/// The moments of computeReviewMoments() at all full hours, with the casters that it counts.
/// Shadows are on the rule's plane, where it has one. Lines of equal hours and distances from the places come
/// with rules whose diagrams have them.
Result<ShadowDrawing> drawReviewShadows(const ReviewStudy& study, const City& baseline, const City& scenario,
                                        const std::vector<Place>& places, Progress& progress,
                                        const std::stop_token& stop);

}  // namespace noonmark
