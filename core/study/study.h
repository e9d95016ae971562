#pragma once

#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/engines/api/engine_registry.h"
#include "core/engines/horizon/attribution/horizon_breakdown.h"
#include "core/io/read_city.h"
#include "core/measures/error_sample.h"
#include "core/measures/statistics.h"
#include "core/receivers/receivers.h"
#include "core/study/provenance/provenance.h"
#include "core/study/terrain_coverage.h"
#include "core/sun/sun_steps.h"

namespace noonmark {

/// What to compute over a city that is already there.
struct StudySettings {
    Region region;
    ReceiverSettings receivers;
    Period period;
    std::string engine = "auto";
    EngineSettings engineSettings;  ///< what differs from the engine's usual settings
    bool byMonth = false;        ///< the shadow of each month too; by the horizon sweep or projected shadows
    bool contributions = false;  ///< and what each building does; by the horizon sweep only
    ErrorSampleSettings errorSample;
    double pressureHPa = 1010;  ///< for refraction
    double temperatureC = 10;
    /// The most memory the study may take, bytes; above it, it is refused with the size it would need. 0 =
    /// 3/4 of what is free.
    std::uint64_t memoryLimit = 0;
    bool operator==(const StudySettings&) const = default;
};

/// One answered question: everything that a report, a file or the window shows of it.
struct Study {
    City city;
    StudySettings settings;
    Receivers receivers;
    SunSteps sun;
    ShadowField field;
    ShadowStatistics statistics;
    TerrainCoverage terrainCoverage;  ///< what of it lies beyond the terrain
    std::optional<ShadowBreakdown>
        breakdown;  ///< by month (else all in one) and by building, where asked for
    /// Against the ray reference; nothing where that was switched off, could not be done (a warning says so)
    /// or the engine is the reference itself.
    std::optional<SampledError> error;
    std::map<std::string, double>
        seconds;        ///< by stage: "read", "sun", "receivers", "accumulate", "error_sample"; and "total"
    Warnings warnings;  ///< of reading and of computing

    [[nodiscard]] bool byReference() const { return field.engineKey == referenceEngine; }
    Provenance provenance;  ///< what the city came from; set by who read it
    HeightFacts heights;    ///< of the inputs' fields
};

/// Receivers, sun and engine (one of `engines`) over `city`; the sun is the one seen from the middle of the
/// region. Fills everything of Study but `provenance` and what reading adds to `seconds` and
/// `warnings`. Error: a setting out of range, an unknown engine, a region without open ground, a sun that
/// never rises in the period, a region or buildings in reach mostly beyond the terrain, or more memory than
/// the limit. Stops with cancelled() within 0.2 s.
Result<Study> runStudy(const City& city, const StudySettings& settings, Progress& progress,
                       std::stop_token stop, const EngineList& engines = coreEngines());

/// Where the sun of a study is seen from: the middle of its region, at the frame's elevation, in the air of
/// its settings.
Observer observerOf(const City& city, const StudySettings& settings);
Observer observerOf(const Study& study);

/// How that sun is told in the frame of the geometry, for reports.
struct SunFrameFacts {
    double convergenceDeg = 0;    ///< of the observer's north against the frame's +y, clockwise positive
    double tiltDeg = 0;           ///< of the observer's vertical against the frame's z; 0 on flat ground
    double farthestM = 0;         ///< from the observer to the farthest corner of the region
    double verticalErrorDeg = 0;  ///< at most, there (core/city/city_observer.h)
};
SunFrameFacts sunFrameOf(const City& city, const StudySettings& settings);

/// The study as the JSON of `study.json`: keys are stable, units in their names. Row order, definitions and
/// what was skipped included.
std::string studyJson(const Study& study);

/// The city as the JSON of `noonmark-cli info --json`: buildings, parts, triangles, height_sources,
/// tallest_m, warnings.
std::string infoJson(const CityRead& read);

}  // namespace noonmark
