#pragma once

#include "core/engines/points/horizons/bin_horizon.h"

namespace noonmark {

/// Sunlit steps by month: the suns above the horizon of their bin that no gap hides. Gaps must lie above the
/// horizon. Some 5 us for a year of minutes.
SunBins::Months countSunlit(const SunBins& suns, const BinHorizon& horizon);

}  // namespace noonmark
