#include "core/lab/lab_engines.h"

#include "core/describe/text.h"
#include "core/lab/accrual/shadow_accrual_map.h"
#include "core/lab/graph/graph_engine.h"
#include "core/lab/graph/ray_intervals.h"
#include "core/lab/inverse/inverse_accrual_map.h"

namespace noonmark {

namespace {

using Made = Result<std::unique_ptr<Engine>>;

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

const EngineList& labEngines() {
    static const EngineList list{shadowAccrualMap(), inverseAccrualMap(), rayGraph()};
    return list;
}

const EngineList& coreAndLabEngines() {
    static const EngineList all = [] {
        EngineList engines = coreEngines();
        engines.insert(engines.end() - 1, labEngines().begin(), labEngines().end());
        return engines;
    }();
    return all;
}

}  // namespace noonmark
