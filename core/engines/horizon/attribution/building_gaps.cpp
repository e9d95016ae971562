#include "core/engines/horizon/attribution/building_gaps.h"

#include <tuple>

namespace noonmark {

std::span<const BuildingGap> BuildingGapFinder::intervals(std::span<const OverhangShapes> shapes,
                                                          OverhangView view,
                                                          std::span<const HorizonCode> horizons,
                                                          const std::stop_token& stop) {
    gaps_.clear();
    for (const OverhangShapes& own : shapes) {
        const OverhangShapes* const one[]{&own};
        view.shapes = one;
        for (const Gap& gap : sweep_.intervals(view, horizons, stop))
            gaps_.push_back({gap.number, own.building, gap.low, gap.high});
    }
    sort_.run(
        gaps_, horizons.size(), [](const BuildingGap& gap) { return gap.number; },
        [](const BuildingGap& a, const BuildingGap& b) {
            return std::tie(a.low, a.building) < std::tie(b.low, b.building);
        });
    return gaps_;
}

}  // namespace noonmark
