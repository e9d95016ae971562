#include <algorithm>

#include "core/accumulate/auto_engine.h"
#include "core/accumulate/engine_ground.h"
#include "core/accumulate/engine_list.h"
#include "core/accumulate/graph_accumulator.h"
#include "core/accumulate/horizon_sweep.h"
#include "core/accumulate/interval_options.h"
#include "core/accumulate/inverse_accrual_map.h"
#include "core/accumulate/projected_shadows.h"
#include "core/accumulate/ray_interval.h"
#include "core/accumulate/ray_reference.h"
#include "core/accumulate/ray_scene.h"
#include "core/accumulate/shadow_accrual_map.h"
#include "core/accumulate/sweep_options.h"

namespace noonmark {

namespace {

using Made = Result<std::unique_ptr<Accumulator>>;

EngineOption levelsOption() {
    const double usual = InverseAccrualSettings{}.levels;
    return {"levels",
            "Source levels",
            "",
            1,
            RayScene::maxLevels,
            usual,
            true,
            "How many occluders, nearest first, are followed from each cell"};
}

EngineOption sourcesOption() {
    return {"rays",
            "Sources by rays",
            "",
            0,
            1,
            0,
            true,
            "1: Embree finds what throws the shadow at an interval's ends; 0: filled polygons do, faster"};
}

EngineOption nearestHitOption() {
    return {"nearest",
            "Nearest hit",
            "m",
            InverseAccrualSettings::lowestNearestHitM,
            InverseAccrualSettings::highestNearestHitM,
            double(InverseAccrualSettings{}.nearestHitM),
            false,
            "Occluders nearer to a cell than this are left out (the paper: 1 m)"};
}

EngineOption deviceOption() {
    return {"device",
            "OpenCL device",
            "",
            -1,
            63,
            -1,
            true,
            "Which OpenCL device draws, as 'noonmark-cli devices' counts them; -1: the processor itself"};
}

Engine rayReference() {
    return {{referenceEngine, "Ray reference",
             "One ray per receiver and step, traced by Embree: the truth that others are measured against"},
            [](const EngineSettings&) -> Made { return std::make_unique<RayReference>(); }};
}

Engine projectedShadows() {
    return {{"projected", "Projected shadows",
             "Each building's shadow filled as polygons at every step: exact and fast on flat ground", 16},
            [](const EngineSettings&) -> Made { return std::make_unique<ProjectedShadows>(); }};
}

Engine horizonSweep() {
    return {{"horizon", "Horizon sweep",
             "The slope of each receiver's horizon, azimuth by azimuth: a year in moments, on terrain and "
             "roofs too",
             24, sweepOptions()},
            [](const EngineSettings& settings) -> Made {
                return std::make_unique<HorizonSweep>(sweepSettings(settings));
            }};
}

Engine autoEngine() {
    return {{"auto", "Automatic",
             "Projected shadows, the horizon sweep or rays: the exact one where it is quick, and the result "
             "says which and why",
             24, sweepOptions()},
            [](const EngineSettings& settings) -> Made {
                return std::make_unique<AutoEngine>(sweepSettings(settings));
            }};
}

Made inverseAccrual(const EngineSettings& settings) {
    InverseAccrualSettings map{.levels = int(settings.at("levels")),
                               .nearestHitM = float(settings.at("nearest"))};
    if (settings.at("rays") != 0) map.sourceFinder = SourceFinderKind::rays;
    if (settings.at("device") >= 0) map.openClDevice = int(settings.at("device"));
    const auto engine = InverseAccrualMap::make(map);
    if (!engine) return tl::make_unexpected(engine.error());
    return std::make_unique<GraphAccumulator>(*engine, graphSettings(settings));
}

std::vector<EngineOption> inverseAccrualOptions() {
    std::vector<EngineOption> options = graphOptions();
    options.insert(options.begin(), levelsOption());
    options.insert(options.end(), {nearestHitOption(), sourcesOption(), deviceOption()});
    return options;
}

Engine inverseAccrualMap() {
    return {
        {"iam", "Inverse accrual map",
         "What throws the shadows at the ends of each hour, moved along straight lines between; hours that "
         "look alike computed once",
         // Sources of two instants, masks, and some 30 maps of runs alive in a year.
         200, inverseAccrualOptions()},
        inverseAccrual};
}

Engine rayGraph() {
    return {{"ray-graph", "Ray reference through the direction graph",
             "Rays, with hours that look alike traced once: what the graph alone does to the error",
             // Masks, and some 30 maps of runs alive in a year.
             130, graphOptions()},
            [](const EngineSettings& settings) -> Made {
                return std::make_unique<GraphAccumulator>(std::make_shared<RayIntervals>(),
                                                          graphSettings(settings));
            }};
}

Made shadowAccrual(const EngineSettings& settings) {
    const auto map =
        ShadowAccrualMap::make({.mapSize = int(settings.at("map")), .biasM = float(settings.at("bias"))});
    if (!map) return tl::make_unexpected(map.error());
    return std::make_unique<GraphAccumulator>(*map, graphSettings(settings));
}

Engine shadowAccrualMap() {
    return {{"sam", "Shadow accrual map",
             "A depth map of each step of an hour, drawn from a city placed once; hours that look alike "
             "computed once",
             accrualBytesPerCell, accrualOptions(AccrualSettings::maxMapSize)},
            shadowAccrual};
}

}  // namespace

const EngineList& coreEngines() {
    static const EngineList list{rayReference(),      projectedShadows(), horizonSweep(), shadowAccrualMap(),
                                 inverseAccrualMap(), rayGraph(),         autoEngine()};
    return list;
}

bool onLevelGroundOnly(std::string_view engineKey) {
    constexpr std::string_view keys[] = {"projected", "sam", "iam"};
    return std::ranges::find(keys, engineKey) != std::end(keys);
}

}  // namespace noonmark
