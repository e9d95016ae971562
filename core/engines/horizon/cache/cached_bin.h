#pragma once

#include <algorithm>
#include <vector>

#include "core/engines/horizon/cache/baseline_codes.h"
#include "core/engines/horizon/geometry/azimuth_bins.h"
#include "core/engines/horizon/overhangs/gaps.h"

namespace noonmark {

/// The cached horizons of a tile at one azimuth, exact for suns above `lowest`. Gaps that end exactly at a
/// sun's level are included, because a gap that begins one level higher adjoins them.
struct CachedBin {
    HorizonCode lowest = 0;
    std::vector<HorizonCode> codes;  ///< of obstacles on the ground, one per number; empty: not cached
    std::vector<Gap> gaps;  ///< gaps of receivers, by number: all overhangs that reach above the horizon
    BaselineCodes base;     ///< where the last change added buildings

    static HorizonCode below(const AzimuthBin& bin) {
        return HorizonCode(std::max(int(noHorizon), int(bin.lowest()) - 1));
    }
    [[nodiscard]] std::size_t bytes() const {
        return codes.capacity() * sizeof(HorizonCode) + gaps.capacity() * sizeof(Gap) + base.bytes();
    }
    [[nodiscard]] bool holds(const AzimuthBin& bin) const { return !codes.empty() && lowest <= below(bin); }
};

}  // namespace noonmark
