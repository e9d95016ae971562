#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/accumulate/accumulator.h"
#include "core/accumulate/graph_accumulator.h"
#include "core/accumulate/horizon_sweep.h"
#include "core/accumulate/inverse_accrual_map.h"
#include "core/accumulate/projected_shadows.h"
#include "core/accumulate/ray_reference.h"

namespace noonmark {

namespace {

struct Engine {
    EngineInfo info;
    std::unique_ptr<Accumulator> (*make)();
};

template <class T>
std::unique_ptr<Accumulator> made() {
    return std::make_unique<T>();
}

std::unique_ptr<Accumulator> inverseAccrual() {
    return std::make_unique<GraphAccumulator>(InverseAccrualMap::make({}).value(), DirectionGraphSettings{});
}

const std::vector<Engine>& all() {
    static const std::vector<Engine> list{
        {{"ray", "Ray reference",
          "One ray per receiver and step, traced by Embree: the truth that others are measured against"},
         made<RayReference>},
        {{"projected", "Projected shadows",
          "Each building's shadow filled as polygons at every step: exact and fast on flat ground", 16},
         made<ProjectedShadows>},
        {{"horizon", "Horizon sweep",
          "The slope of each receiver's horizon, azimuth by azimuth: a year in moments, on flat ground, of "
          "buildings that stand on it",
          24},
         made<HorizonSweep>},
        {{"iam", "Inverse accrual map",
          "Rays at the ends of each hour, shadows drawn as lines between; hours that look alike computed "
          "once",
          // Sources of two instants, masks, and some 30 maps of runs alive in a year.
          200},
         inverseAccrual},
    };
    return list;
}

}  // namespace

const std::vector<EngineInfo>& engines() {
    static const std::vector<EngineInfo> infos = [] {
        std::vector<EngineInfo> list;
        for (const Engine& engine : all()) list.push_back(engine.info);
        return list;
    }();
    return infos;
}

Result<std::unique_ptr<Accumulator>> makeAccumulator(std::string_view key) {
    std::vector<std::string_view> keys;
    for (const Engine& engine : all()) {
        if (engine.info.key == key) return engine.make();
        keys.push_back(engine.info.key);
    }
    return failure(fmt::format("There is no engine '{}'", key), "engine",
                   fmt::format("Choose one of: {}", fmt::join(keys, ", ")));
}

}  // namespace noonmark
