#pragma once

// The folder core/study answers one question: the shadow over a region, in a period, by an engine. runStudy()
// (this file) runs the steps and returns a Study; study_cost.h and terrain_coverage.h refuse studies that
// cannot succeed, and study_cost.h estimates the remaining time. tiles/ does the same for regions that do not
// fit into memory. text/ turns results into JSON, CSV and words, provenance/ records what a result was made
// from.

#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/engines/api/engine_registry.h"
#include "core/engines/api/tree_shade.h"
#include "core/engines/horizon/attribution/horizon_breakdown.h"
#include "core/engines/ray/tree_rays.h"
#include "core/engines/shade_trees.h"
#include "core/io/read_city.h"
#include "core/measures/error_sample.h"
#include "core/measures/shown_error.h"
#include "core/measures/statistics.h"
#include "core/receivers/receivers.h"
#include "core/study/provenance/provenance.h"
#include "core/study/terrain_coverage.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// Settings of a study of a given city.
struct StudySettings {
    Region region;
    ReceiverSettings receivers;
    Period period;
    std::string engine = "auto";
    EngineSettings engineSettings;  ///< settings that differ from the engine's defaults
    bool byMonth = false;  ///< also compute the shadow of each month; horizon sweep or projected shadows only
    TreeColumns trees = TreeColumns::all;  ///< where the city has trees
    bool contributions = false;  ///< also compute the contribution of each building; horizon sweep only
    ErrorSampleSettings errorSample;
    double pressureHPa = 1010;  ///< for refraction
    double temperatureC = 10;
    /// Maximum memory of the study, bytes; a study that needs more is refused, and the error states how much
    /// it needs. 0 = 3/4 of the available memory.
    std::uint64_t memoryLimit = 0;
    bool operator==(const StudySettings&) const = default;
};

/// The result of a study: everything that a report, a file or the window displays.
struct Study {
    City city;
    StudySettings settings;
    Receivers receivers;
    SunSteps sun;
    ShadowField field;
    ShadowStatistics statistics;
    TerrainCoverage terrainCoverage;  ///< how much of the study lies beyond the terrain
    std::optional<ShadowBreakdown>
        breakdown;  ///< by month (else one set) and by building, if the settings ask for it
    /// The shadow of each month with trees, if the settings ask for months and a tree reaches a receiver.
    std::optional<ShadedSets> shadedMonths;
    /// What single trees take, if the settings ask for contributions and a tree reaches a receiver.
    std::optional<TakenByTree> byTree;
    /// Error against the ray reference; nothing if it was switched off, could not be measured (a warning says
    /// so) or the engine is the reference itself.
    std::optional<SampledError> error;
    std::optional<ShownError> monthError;  ///< of the shadow of cells by month, likewise
    std::map<std::string, double>
        seconds;        ///< by stage: "read", "sun", "receivers", "accumulate", "error_sample"; and "total"
    Warnings warnings;  ///< from reading and from computing

    [[nodiscard]] bool byReference() const { return field.engineKey == referenceEngine; }
    Provenance provenance;  ///< what the city was made from; set by the caller
    HeightFacts heights;    ///< heights in the inputs
};

/// Computes receivers, sun and field, by one of `engines`, over `city`; the sun is the one seen from the
/// middle of the region. Fills everything in Study except `provenance` and what reading adds to `seconds` and
/// `warnings`. Error: a setting out of range, an unknown engine, a region without open ground, a sun that
/// never rises in the period, most of the region or of the buildings in reach beyond the terrain, or more
/// memory than the limit. Stops with cancelled() within 0.2 s.
Result<Study> runStudy(const City& city, const StudySettings& settings, Progress& progress,
                       std::stop_token stop, const EngineList& engines = coreEngines());

/// The errors of all quantities that it shows; none where they were not measured.
std::vector<ShownError> listErrors(const Study& study);

/// The observer of a study's sun: at the middle of its region, at the frame's elevation, in the air of its
/// settings.
Observer makeObserver(const City& city, const StudySettings& settings);
Observer makeObserver(const Study& study);

/// How the observer's directions differ from the frame of the geometry, for reports.
struct SunFrameFacts {
    double convergenceDeg = 0;    ///< angle of the observer's north from the frame's +y, clockwise positive
    double tiltDeg = 0;           ///< angle of the observer's vertical from the frame's z; 0 on flat ground
    double farthestM = 0;         ///< from the observer to the farthest corner of the region
    double verticalErrorDeg = 0;  ///< the largest error, at that corner (core/city/city_position.h)
};
SunFrameFacts computeSunFrame(const City& city, const StudySettings& settings);

/// The study as the JSON of `study.json`: keys are stable, units are in their names. Includes row order,
/// definitions and what was left out.
std::string studyJson(const Study& study);

/// The city as the JSON of `noonmark-cli info --json`: buildings, parts, triangles, height_sources,
/// tallest_m, warnings.
std::string infoJson(const CityRead& read);

}  // namespace noonmark
