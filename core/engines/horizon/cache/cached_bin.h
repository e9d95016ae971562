#pragma once

#include <algorithm>
#include <vector>

#include "core/engines/horizon/cache/baseline_codes.h"
#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/overhangs/gaps.h"

namespace noonmark {

/// Horizons of a tile at one azimuth, exact for suns above `lowest`: what ends at a sun's own level is kept,
/// since a gap that begins one level above is joined to it.
struct CachedBin {
    HorizonCode lowest = 0;
    std::vector<HorizonCode> codes;  ///< of what stands, one a number; none: not there
    std::vector<Gap> gaps;  ///< of receivers, by number: all that hangs and reaches above the horizon
    BaselineCodes base;     ///< where buildings came last

    static HorizonCode below(const AzimuthBin& bin) {
        return HorizonCode(std::max(int(noHorizon), int(bin.lowest()) - 1));
    }
    [[nodiscard]] std::size_t bytes() const {
        return codes.capacity() * sizeof(HorizonCode) + gaps.capacity() * sizeof(Gap) + base.bytes();
    }
    [[nodiscard]] bool holds(const AzimuthBin& bin) const { return !codes.empty() && lowest <= below(bin); }
};

}  // namespace noonmark
