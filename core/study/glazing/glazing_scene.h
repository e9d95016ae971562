#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/engines/points/sky_obstacles.h"
#include "core/study/glazing/glazing_study.h"

namespace noonmark {

/// The windows that are judged together, as indices of receivers.
using GlazingGroup = std::vector<std::uint32_t>;

/// What a review of windows evaluates: everything that does not depend on a single window.
struct GlazingScene {
    Rule rule;         ///< its opening is no wider than a bay
    const City& city;  ///< the scenario
    PlacedElements placed;
    RuleSun days;
    ShadedStepFinder::By by = ShadedStepFinder::By::rays;
    std::string engine;  ///< in words, with why it was chosen where a sample decided it
    std::optional<ShadedStepFinder> after;
    std::optional<ShadedStepFinder> before;  ///< none: the baseline is the scenario
    std::optional<SkyTrees> sky, formerSky;  ///< where the rule asks for the sky component
    std::set<std::uint32_t> fresh;           ///< buildings without former values, by index
    std::vector<GlazingGroup> groups;
    double prepareSeconds = 0, buildSeconds = 0;

    [[nodiscard]] PaneSize paneOf(std::uint32_t window) const {
        return placed.facts.empty() ? PaneSize{} : placed.facts[window].pane;
    }
};

/// Cities must outlive the scene, which stays where it is: its parts refer to each other. Errors as of
/// runGlazingReview(). In Midtown some 0.5 s a city.
Result<std::unique_ptr<const GlazingScene>> prepareGlazingScene(const Rule& rule, const City& baseline,
                                                                const City& scenario,
                                                                const GlazingReviewSettings& settings,
                                                                Progress& progress,
                                                                const std::stop_token& stop);

/// Evaluates the rule on a group of windows. Safe on several threads.
GlazingReview reviewGroup(const GlazingScene& scene, const GlazingGroup& group);

}  // namespace noonmark
