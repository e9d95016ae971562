#include "core/describe/text.h"
#include "core/engines/api/engine_registry.h"
#include "core/engines/auto_engine.h"
#include "core/engines/horizon/horizon_sweep.h"
#include "core/engines/projected/projected_shadows.h"
#include "core/engines/ray/ray_reference.h"

namespace noonmark {

namespace {

using Made = Result<std::unique_ptr<Engine>>;

EngineEntry rayReference() {
    return {
        {referenceEngine, NM_TEXT("Ray reference"),
         NM_TEXT(
             "One ray per receiver and step, traced by Embree: the reference for the errors of the others"),
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
    return engineOf({"horizon", NM_TEXT("Horizon sweep"),
                     NM_TEXT("The slope of each receiver's horizon, azimuth by azimuth: a year takes "
                             "seconds, on terrain and roofs too"),
                     HorizonSweep::able, 24},
                    sweepFields(), [](const HorizonSweepSettings& settings) {
                        return std::make_unique<HorizonSweep>(settings);
                    });
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

}  // namespace

const EngineList& coreEngines() {
    static const EngineList list{rayReference(), projectedShadows(), horizonSweep(), autoEngine()};
    return list;
}

}  // namespace noonmark
