#include <algorithm>

#include "core/describe/text.h"
#include "core/engines/accrual/interval_options.h"
#include "core/engines/accrual/shadow_accrual_map.h"
#include "core/engines/api/engine_registry.h"
#include "core/engines/auto_engine.h"
#include "core/engines/graph/graph_engine.h"
#include "core/engines/horizon/horizon_sweep.h"
#include "core/engines/horizon/sweep_options.h"
#include "core/engines/inverse/inverse_accrual_map.h"
#include "core/engines/projected/projected_shadows.h"
#include "core/engines/ray/ray_intervals.h"
#include "core/engines/ray/ray_reference.h"
#include "core/engines/ray/ray_scene.h"

namespace noonmark {

namespace {

using Made = Result<std::unique_ptr<Engine>>;

EngineOption levelsOption() {
    const double usual = InverseAccrualSettings{}.levels;
    return {"levels",
            NM_TEXT("Source levels"),
            "",
            1,
            RayScene::maxLevels,
            usual,
            OptionKind::wholeNumber,
            NM_TEXT("How many occluders, nearest first, are followed from each cell")};
}

EngineOption sourcesOption() {
    return {"rays",
            NM_TEXT("Sources by rays"),
            "",
            0,
            1,
            0,
            OptionKind::yesNo,
            NM_TEXT("Embree finds the occluders at an interval's ends; otherwise filled polygons do, which "
                    "is faster")};
}

EngineOption nearestHitOption() {
    return {"nearest",
            NM_TEXT("Nearest hit"),
            "m",
            InverseAccrualSettings::minNearestHitM,
            InverseAccrualSettings::maxNearestHitM,
            double(InverseAccrualSettings{}.nearestHitM),
            OptionKind::number,
            NM_TEXT("Occluders nearer to a cell than this are left out (the paper: 1 m)")};
}

EngineOption deviceOption() {
    return {"device",
            NM_TEXT("OpenCL device"),
            "",
            -1,
            63,
            -1,
            OptionKind::wholeNumber,
            NM_TEXT("Which OpenCL device draws, counted from 0; -1: the processor itself")};
}

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
    return {
        {"horizon", NM_TEXT("Horizon sweep"),
         NM_TEXT(
             "The slope of each receiver's horizon, azimuth by azimuth: a year in moments, on terrain and "
             "roofs too"),
         HorizonSweep::able, 24, sweepOptions()},
        [](const EngineSettings& settings) -> Made {
            return std::make_unique<HorizonSweep>(readSweepSettings(settings));
        }};
}

EngineEntry autoEngine() {
    return {
        {"auto", NM_TEXT("Automatic"),
         NM_TEXT(
             "Projected shadows, the horizon sweep or rays: the exact one where it is quick, and the result "
             "says which and why"),
         AutoEngine().capabilities(), 24, sweepOptions()},
        [](const EngineSettings& settings) -> Made {
            return std::make_unique<AutoEngine>(readSweepSettings(settings));
        }};
}

Made inverseAccrual(const EngineSettings& settings) {
    InverseAccrualSettings map{.levels = int(settings.at("levels")),
                               .nearestHitM = float(settings.at("nearest"))};
    if (settings.at("rays") != 0) map.sourceFinder = SourceFinderKind::rays;
    if (settings.at("device") >= 0) map.openClDevice = int(settings.at("device"));
    const auto engine = InverseAccrualMap::make(map);
    if (!engine) return tl::make_unexpected(engine.error());
    return std::make_unique<GraphEngine>(*engine, readGraphSettings(settings));
}

std::vector<EngineOption> inverseAccrualOptions() {
    std::vector<EngineOption> options = graphOptions();
    options.insert(options.begin(), levelsOption());
    options.insert(options.end(), {nearestHitOption(), sourcesOption(), deviceOption()});
    return options;
}

EngineEntry inverseAccrualMap() {
    return {{"iam",
             NM_TEXT("Inverse accrual map"),
             NM_TEXT("Occluders at both ends of each hour, their shadows moved along straight lines between; "
                     "hours that "
                     "look alike computed once"),
             {},
             // Sources of two instants, masks, and some 30 maps of runs alive in a year.
             200,
             inverseAccrualOptions()},
            inverseAccrual};
}

EngineEntry rayGraph() {
    return {{"ray-graph", NM_TEXT("Ray reference through the direction graph"),
             NM_TEXT("Rays, with hours that look alike traced once: what the graph alone does to the error"),
             RayIntervals::able,
             // Masks, and some 30 maps of runs alive in a year.
             130, graphOptions()},
            [](const EngineSettings& settings) -> Made {
                return std::make_unique<GraphEngine>(std::make_shared<RayIntervals>(),
                                                     readGraphSettings(settings));
            }};
}

Made shadowAccrual(const EngineSettings& settings) {
    const auto map =
        ShadowAccrualMap::make({.mapSize = int(settings.at("map")), .biasM = float(settings.at("bias"))});
    if (!map) return tl::make_unexpected(map.error());
    return std::make_unique<GraphEngine>(*map, readGraphSettings(settings));
}

EngineEntry shadowAccrualMap() {
    return {
        {"sam",
         NM_TEXT("Shadow accrual map"),
         NM_TEXT("A depth map of each step of an hour, drawn from a city placed once; hours that look alike "
                 "computed once"),
         {},
         accrualBytesPerCell,
         accrualOptions(AccrualSettings::maxMapSize)},
        shadowAccrual};
}

}  // namespace

const EngineList& coreEngines() {
    static const EngineList list{rayReference(),      projectedShadows(), horizonSweep(), shadowAccrualMap(),
                                 inverseAccrualMap(), rayGraph(),         autoEngine()};
    return list;
}

}  // namespace noonmark
