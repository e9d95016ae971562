#include "core/accumulate/horizon/open_shares.h"

#include <tuple>

namespace noonmark {

std::span<const OwnedGap> OwnedGaps::intervals(std::span<const OpenShapes> shapes, OpenView view,
                                               std::span<const HorizonCode> horizons,
                                               const std::stop_token& stop) {
    gaps_.clear();
    for (const OpenShapes& own : shapes) {
        const OpenShapes* const one[]{&own};
        view.shapes = one;
        for (const Gap& gap : sweep_.intervals(view, horizons, stop))
            gaps_.push_back({gap.number, own.building, gap.low, gap.high});
    }
    sort_.run(
        gaps_, horizons.size(), [](const OwnedGap& gap) { return gap.number; },
        [](const OwnedGap& a, const OwnedGap& b) {
            return std::tie(a.low, a.building) < std::tie(b.low, b.building);
        });
    return gaps_;
}

}  // namespace noonmark
