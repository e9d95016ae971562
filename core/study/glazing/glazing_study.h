#pragma once

// The folder core/study/glazing evaluates rules about windows. runGlazingReview() (this file) returns a
// GlazingStudy, prepared by a GlazingScene; glazing_text.h turns it into tables and
// JSON and says which of its values elevations show.

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "core/engines/points/point_sunlight.h"
#include "core/engines/points/sky_factors.h"
#include "core/engines/points/sky_obstacles.h"
#include "core/engines/trees/crowns.h"
#include "core/engines/trees/crowns_around.h"
#include "core/receivers/points/facade_elevations.h"
#include "core/review/glazing/building_review.h"
#include "core/study/elements/place_elements.h"

namespace noonmark {

struct GlazingReviewSettings {
    /// Windows of a file, or facades: a window in each bay and storey, of the sizes that the rule's opening
    /// states. Its aboveFloorM is not read.
    ElementSettings elements;
    Region region;     ///< windows outside are left out
    std::string zone;  ///< IANA name
    int year = 2026;   ///< of rules that name none
    /// None: rays up to maxTracedSteps, which take no longer then, else horizons; and rays again where a
    /// sample of the windows shows that horizons are off (glazing_scene.cpp).
    std::optional<ShadedStepFinder::By> by{};
};
inline constexpr std::size_t maxTracedSteps = 2000;

/// A window of a review where it is, to draw it. A room or a dwelling has several.
struct ReviewedPane {
    ElevationPane pane;          ///< with the sizes of the rule's opening where the file states none
    std::size_t window = 0;      ///< index in GlazingStudy::windows
    std::uint32_t building = 0;  ///< index in the scenario's buildings, or PointElement::noBuilding
};

/// A rule's answers for windows.
struct GlazingStudy {
    Rule rule;
    GlazingReviewSettings settings;
    std::vector<GlazingReview> windows;     ///< or rooms or dwellings, as the rule judges them
    std::vector<glm::dvec3> places;         ///< of these: longitude, latitude (degrees), elevation (metres)
    std::vector<ReviewedPane> panes;        ///< of these, in their order
    std::vector<BuildingReview> buildings;  ///< of these windows
    VerdictChanges windowChanges, buildingChanges;
    DayClock clock;
    int year = 0;
    double stepMinutes = 1;
    std::size_t steps = 0;  ///< with the sun up in the rule's hours
    std::string engine;     ///< "horizons with ends by rays", "rays", "rays, since horizons of ..."
    std::vector<std::string> notChecked;    ///< of the rule, and what this run adds to it
    std::map<std::string, double> seconds;  ///< by stage, and "total"
    Warnings warnings;
    std::string trees{};  ///< which trees count, and how many those are: a sentence without a full stop
    std::optional<InputFile> glazingInput{};  ///< set by the caller
};

/// What a review of windows is expected to take.
struct GlazingForecast {
    std::size_t windows = 0;  ///< windows that are measured
    std::size_t steps = 0;    ///< with the sun up in the rule's hours
    double seconds = 0;       ///< of the whole review, without its files
};
using AnnounceGlazing = std::function<void(const GlazingForecast&)>;

/// Prepares the review and measures 64 of its windows, evenly chosen, so that the forecast holds for the
/// city and the machine: its error was not measured. Errors as of runGlazingReview().
Result<GlazingForecast> forecastGlazingReview(const Rule& rule, const City& baseline, const City& scenario,
                                              const GlazingReviewSettings& settings, Progress& progress,
                                              const std::stop_token& stop);

/// Evaluates a rule on the windows of the scenario. A window is compared with the baseline where its building
/// is the same in both; the windows of new and changed buildings have no former values. Uses all cores.
/// Error: a rule about places, what placeElements()
/// refuses, or cancelled(). In Midtown some 0.5 ms a window for a day, 10 ms for a year, 2 ms more where
/// the rule asks for the sky component. `announce`, if given, is called once with the forecast before the
/// windows are evaluated.
Result<GlazingStudy> runGlazingReview(const Rule& rule, const City& baseline, const City& scenario,
                                      const GlazingReviewSettings& settings, Progress& progress,
                                      const std::stop_token& stop, const AnnounceGlazing& announce = {});

/// The windows that are judged together, as indices of receivers.
using GlazingGroup = std::vector<std::uint32_t>;

/// The crowns that a rule counts, as windows of one city see them.
struct GlazingCrowns {
    GlazingCrowns(const City& city, const SurfacePoints& windows, const SunSteps& sun)
        : sunward(findCrowns(city, windows, sun)), sky(city) {}
    CrownScene sunward;  ///< that can shade a window
    SkyCrowns sky;
};

/// What a review of windows evaluates: everything that does not depend on a single window.
struct GlazingScene {
    Rule rule;         ///< its opening is no wider than a bay
    const City& city;  ///< the scenario
    PlacedElements placed;
    RuleSun days;
    ShadedStepFinder::By by = ShadedStepFinder::By::rays;
    std::string trees;   ///< as of GlazingStudy
    std::string engine;  ///< in words, with why it was chosen where a sample decided it
    std::optional<ShadedStepFinder> after;
    std::optional<ShadedStepFinder> before;             ///< none: the baseline is the scenario
    std::optional<SkyTrees> sky, formerSky;             ///< where the rule asks for the sky component
    std::optional<SunPatches> patches;                  ///< where the rule counts trees, and there are some
    std::optional<GlazingCrowns> crowns, formerCrowns;  ///< likewise; former as `before`
    std::set<std::uint32_t> newBuildings;               ///< buildings without former values, by index
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
