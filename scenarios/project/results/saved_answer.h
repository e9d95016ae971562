#pragma once

#include <any>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/measures/statistics.h"
#include "core/study/by_place/sun_by_place.h"
#include "core/study/contributions/place_contributions.h"
#include "core/study/elements/element_tables.h"
#include "core/study/text/breakdown_text.h"
#include "core/sun/stated_period.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/project/project.h"
#include "scenarios/weights/score.h"

namespace noonmark {

/// How a saved result was made, from its settings.
struct SavedOrigin {
    std::string at;  ///< UTC, "2026-11-22T03:10:28Z"; empty in results of versions that did not store it
    std::string citySha256;      ///< hashCity() of the scenario at that time; empty likewise
    std::string baselineSha256;  ///< impact: hashCity() of the baseline
    std::map<std::string, std::string> othersSha256{};  ///< sun by place: of further scenarios, by name
    std::string questionSha256;                         ///< hashQuestion() of its settings; empty likewise
    std::string program;                                ///< "Noonmark 0.1.0"
    std::string engine;                                 ///< name and settings, as text
    StatedPeriod period;
    std::string region;                  ///< its name; may be empty
    std::optional<TimeWeights> weights;  ///< score: the table at that time; empty where not stored
    std::string rule{};                  ///< review: the name of its rule; empty likewise
};

/// The names of a study's layers; with trees they end in layerEnding().
inline const std::string grossLayer = "gross shadow", runLayer = "continuous shadow";
/// ", trees as evergreens"
std::string layerEnding(TreeColumns column);
/// Further layers of a comparison: the shadow that its change is the difference of.
inline const std::string beforeLayer = "gross shadow of the baseline",
                         afterLayer = "gross shadow of the scenario";

struct SavedStudy {
    ShadowField field;  ///< without cost and warnings; with trees where the version stored their maps
    ShadowStatistics statistics;
    std::uint64_t steps = 0;            ///< of the sun
    std::uint64_t belowHorizon = 0;     ///< steps left out because the sun was below the horizon
    double seconds = 0;                 ///< run time of the engine; 0: unknown
    std::string error;                  ///< against the ray reference, as text
    CivilDate start{};                  ///< of its period
    std::vector<MonthShadow> months{};  ///< empty: not asked for
    /// What buildings take from the region, without indices in City::buildings and sets of steps. None: not
    /// asked for, or not stored by the version.
    std::optional<std::vector<Contribution>> contributions{};
    std::vector<TreeContribution> trees{};  ///< what single trees take, without indices; likewise
    std::vector<ShownError>
        errors{};  ///< of the quantities it shows; none where the version did not state them
};

struct SavedImpact {
    Impact impact;  ///< cells that were built over count as outside where the version did not store them
    ComparisonFigures figures;
    /// Gross shadow of both, without trees. None: the version stored the change alone.
    struct Sides {
        ShadowField before, after;
    };
    std::optional<Sides> sides{};
};

struct SavedScore {
    Score score;
    std::string weights;  ///< name of the weight table
};

struct SavedElements {
    ElementMap map;
    ElementFigures figures;
    std::uint64_t steps = 0, belowHorizon = 0;  ///< as of SavedStudy
    double seconds = 0;
    bool byRays = false;  ///< the ray reference measured it
    std::string error;    ///< against rays, as text; empty: not measured
    SourceValues source;  ///< the source columns of its table, as they were when it was saved
};

struct SavedSunByPlace {
    SunOfCities sun;                            ///< without city, cells and sun of the days
    std::uint64_t steps = 0, belowHorizon = 0;  ///< as of SavedStudy
    double seconds = 0;
    std::string error;  ///< against rays, as text; empty: not measured
};

/// A saved result read back, with the figures it was saved with.
struct SavedAnswer {
    SavedOrigin origin;
    std::any content;  ///< of the type that its kind gives: SavedStudy, SavedImpact...
    std::vector<ContributionTable> ofPlaces{};  ///< what buildings take from single places
};

/// Its origin alone, without its maps. Error: the settings are not those of a result.
Result<SavedOrigin> readSavedOrigin(const SavedResult& result);

/// Results of one kind, and what reads them back.
struct SavedKind {
    std::string_view kind;  ///< as of SavedResult
    /// Takes the result and its settings. Throws nlohmann's or other standard exceptions where settings or
    /// layers do not match.
    std::function<std::any(const SavedResult&, const nlohmann::ordered_json&)> read;
};

/// Studies, comparisons, scores, points and sun by place.
std::span<const SavedKind> savedKinds();

/// Copies the layers. Error: the settings or layers do not match the kind, or `kinds` lacks it.
Result<SavedAnswer> readSavedAnswer(const SavedResult& result,
                                    std::span<const SavedKind> kinds = savedKinds());

/// Reasons why the current project would not give this result, one sentence each: other buildings, terrain,
/// places or files. Empty where there is none. Costs a hash of the scenario's city and of the baseline's.
/// In saved_changes.cpp, as the following.
std::vector<std::string> findChangesSince(const SavedResult& result, const SavedOrigin& origin,
                                          const Project& project);

/// Reasons why sun by place that was measured on these places is not that of the project's places and
/// regions: one for each that is gone or renamed, and that has another kind or outline. Outlines count as the
/// same within 5 cm and a thousandth of the area. O(n log n).
std::vector<std::string> findChangedPlaces(const std::vector<Place>& measured, const Project& project);

/// Names of the results that the project would not give now: those of which findChangesSince() would state
/// any, and damaged ones. Costs a hash of the city of each scenario that they are about. Error: cancelled().
Result<std::set<std::string>> findOutdated(const std::vector<std::shared_ptr<const SavedResult>>& results,
                                           const Project& project, const std::stop_token& stop);

/// The same for the weight table of a score; needs no hash.
std::vector<std::string> findWeightChangesSince(const SavedOrigin& origin, const Project& project);

}  // namespace noonmark
