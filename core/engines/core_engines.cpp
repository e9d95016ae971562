#include "core/describe/text.h"
#include "core/engines/accrual/shadow_accrual_map.h"
#include "core/engines/api/engine_registry.h"
#include "core/engines/auto_engine.h"
#include "core/engines/graph/graph_engine.h"
#include "core/engines/horizon/horizon_sweep.h"
#include "core/engines/inverse/inverse_accrual_map.h"
#include "core/engines/projected/projected_shadows.h"
#include "core/engines/ray/ray_intervals.h"
#include "core/engines/ray/ray_reference.h"

namespace noonmark {

namespace {

using Made = Result<std::unique_ptr<Engine>>;

EngineEntry rayReference() {
    return {
        {referenceEngine, NM_TEXT("Ray reference"),
         NM_TEXT(
             "One ray per receiver and step, traced by Embree: the truth that others are measured against"),
         RayReference::able},
        [](const EngineSettings&) -> Made { return std::make_unique<RayReference>(); }};
}

EngineEntry projectedShadows() {
    return {
        {"projected", NM_TEXT("Projected shadows"),
         NM_TEXT("Each building's shadow filled as polygons at every step: exact and fast on flat ground"),
         ProjectedShadows::able, 16},
        [](const EngineSettings&) -> Made { return std::make_unique<ProjectedShadows>(); }};
}

EngineEntry horizonSweep() {
    return engineOf(
        {"horizon", NM_TEXT("Horizon sweep"),
         NM_TEXT(
             "The slope of each receiver's horizon, azimuth by azimuth: a year in moments, on terrain and "
             "roofs too"),
         HorizonSweep::able, 24},
        sweepFields(),
        [](const HorizonSweepSettings& settings) { return std::make_unique<HorizonSweep>(settings); });
}

EngineEntry autoEngine() {
    return engineOf(
        {"auto", NM_TEXT("Automatic"),
         NM_TEXT(
             "Projected shadows, the horizon sweep or rays: the exact one where it is quick, and the result "
             "says which and why"),
         AutoEngine().capabilities(), 24},
        sweepFields(),
        [](const HorizonSweepSettings& settings) { return std::make_unique<AutoEngine>(settings); });
}

EngineEntry inverseAccrualMap() {
    return engineOf(
        {"iam",
         NM_TEXT("Inverse accrual map"),
         NM_TEXT("Occluders at both ends of each hour, their shadows moved along straight lines between; "
                 "hours that "
                 "look alike computed once"),
         {},
         // Sources of two instants, masks, and some 30 maps of runs alive in a year.
         200},
        throughGraph(inverseFields()), [](const ThroughGraph<InverseAccrualSettings>& settings) -> Made {
            const auto map = InverseAccrualMap::make(settings.own);
            if (!map) return tl::make_unexpected(map.error());
            return std::make_unique<GraphEngine>(*map, settings.graph);
        });
}

EngineEntry rayGraph() {
    return engineOf({"ray-graph", NM_TEXT("Ray reference through the direction graph"),
                     NM_TEXT("Rays, with hours that look alike traced once: what the graph alone does to the "
                             "error"),
                     RayIntervals::able,
                     // Masks, and some 30 maps of runs alive in a year.
                     130},
                    graphFields(), [](const DirectionGraphSettings& settings) {
                        return std::make_unique<GraphEngine>(std::make_shared<RayIntervals>(), settings);
                    });
}

EngineEntry shadowAccrualMap() {
    return engineOf(
        {"sam",
         NM_TEXT("Shadow accrual map"),
         NM_TEXT("A depth map of each step of an hour, drawn from a city placed once; hours that look alike "
                 "computed once"),
         {},
         accrualBytesPerCell},
        throughGraph(accrualFields()), [](const ThroughGraph<AccrualSettings>& settings) -> Made {
            const auto map = ShadowAccrualMap::make(settings.own);
            if (!map) return tl::make_unexpected(map.error());
            return std::make_unique<GraphEngine>(*map, settings.graph);
        });
}

}  // namespace

const EngineList& coreEngines() {
    static const EngineList list{rayReference(),      projectedShadows(), horizonSweep(), shadowAccrualMap(),
                                 inverseAccrualMap(), rayGraph(),         autoEngine()};
    return list;
}

}  // namespace noonmark
