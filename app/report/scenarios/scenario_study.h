#pragma once

// The folder app/report/scenarios puts the same study of several scenarios side by side: this file as
// tables for programs, scenario_book.h as sheets and as the complete set of files.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/review/glazing/building_review.h"
#include "core/study/by_place/sun_by_place.h"
#include "core/study/study.h"
#include "scenarios/impact/impact_figures.h"
#include "scenarios/massing/tower_design.h"
#include "scenarios/scenario.h"
#include "scenarios/weights/score.h"

namespace noonmark {

/// The change from a baseline, on the receivers of both.
struct ScenarioImpact {
    std::string baseline;
    ImpactFigures figures;
};

struct ScenarioScore {
    std::string weights;  ///< name of the table
    ScoreTotals totals;
    std::vector<MonthFigures> months{};    ///< empty: of a result saved before they were kept
    std::vector<ShownError> errors{};      ///< of Score::errors
    std::vector<ShadedScore> withTrees{};  ///< of Score::withTrees, without their maps
};

/// Sun of all places that were measured, as one.
struct ScenarioSun {
    std::size_t places = 0;
    double enoughHours = 0;           ///< a day, of the share of the area that has enough
    std::vector<std::string> months;  ///< of SunOfPlace::monthHours
    SunOfPlace mean;                  ///< averagePlaces()
};
ScenarioSun makeScenarioSun(const SunByPlace& sun);

/// What a study measured with trees.
struct ShadedFigures {
    TreeColumns column = TreeColumns::seasonal;  ///< or evergreen
    ShadowStatistics figures;
};

/// The review by a rule: the number of places or windows with each verdict.
struct ScenarioVerdicts {
    std::string rule;  ///< its name
    std::string baseline;
    VerdictCounts counts;
};

/// Figures of a scenario that are computed one by one; none: not computed for its present buildings.
struct ScenarioAnswers {
    std::optional<ScenarioImpact> impact{};
    std::optional<ScenarioScore> score{};
    std::optional<ScenarioVerdicts> verdicts{};
    std::optional<ShadowStatistics> measured{};  ///< of an earlier study, which is not in memory
    std::optional<ScenarioSun> sun{};            ///< of the places that were measured last
};

/// A scenario with its study. Those that are put side by side have the same settings, so that their figures
/// can be compared; the first is what the others are compared with.
struct ScenarioStudy {
    std::string name;
    std::shared_ptr<const Study> study;  ///< not null; states its provenance
    ScenarioUses uses{};                 ///< of its towers
    std::optional<double> heightM{};     ///< of the highest building that it adds; none: it adds none
    ScenarioAnswers answers{};
    std::vector<ShadedFigures> withTrees{};  ///< empty: no tree reaches a receiver, or none is wanted
};
using ScenarioStudies = std::vector<ScenarioStudy>;

/// What could not be computed of a scenario, and why.
struct FailedScenario {
    std::string name;
    Error error;
};
using FailedScenarios = std::vector<FailedScenario>;

/// A scenario of a project with its study and what its towers add; without its other answers. Some ms per
/// tower; O(cells) with trees.
ScenarioStudy makeScenarioStudy(const std::vector<Scenario>& scenarios, std::string name,
                                std::shared_ptr<const Study> study);

/// Steps from the existing city to the scenario, including those of its bases.
std::size_t countChanges(const ScenarioStudy& scenario);

/// Whether two studies alone give what a comparison of their cities does: the same settings, cells and
/// engine.
bool areComparable(const Study& before, const Study& after);
/// The change from one to the other, on the receivers of both. They have the same cells.
ImpactFigures compareStudies(const Study& before, const Study& after,
                             double thresholdMin = defaultThresholdsMin.front());

/// Change of the shadow area from the first scenario on the receivers of both, m2: ground that is built over
/// in either does not count, as in a comparison. NaN: they were measured on different cells. O(cells)
double computeShadowAreaChange(const ScenarioStudies& scenarios, const ScenarioStudy& scenario);

/// The noonmark-cli command line that measures the scenarios again, with their impact and score. Error, with
/// advice: the project was not saved in the state that was measured, or only some of them were compared or
/// scored. Verdicts are not computed again: a review has a record of its own.
Result<std::string> makeRepeatCommand(const ScenarioStudies& scenarios, std::size_t width = 120);

/// Columns of scenariosCsv() that this command leaves empty.
std::vector<std::string> verdictColumns();

/// Columns: name,changes,receiver_area_m2,shadow_area_m2,shadow_area_change_m2,mean_gross_min,
/// mean_continuous_min,max_continuous_min,height_m,gross_floor_m2, those of the impact
/// (impact_baseline,impact_m2,impact_threshold_min,gained_m2,lost_m2), of the score
/// (weights,weighted_shade_m2h,score_m2), those of the study and of the score with trees where one has some
/// (shadow_area_m2_evergreen, ...), of the review (rule,rule_baseline,pass,borderline,fail,not_judged),
/// and the source columns (provenance_texts.h); one row per scenario. RFC 4180; fields are empty where
/// nothing was computed.
std::string scenariosCsv(const ScenarioStudies& scenarios);

/// Columns: scenario,use,storeys,gross_floor_m2; a row for each use in a scenario's towers, an empty use
/// where none is stated. RFC 4180.
std::string scenarioUsesCsv(const ScenarioStudies& scenarios);

/// The settings of the study, figures and provenance of every scenario, and the command that repeats them.
/// Stable keys with their units. `scenarios` has at least one. `failed`: listed with the reason.
std::string scenariosJson(const ScenarioStudies& scenarios, const FailedScenarios& failed = {});

}  // namespace noonmark
