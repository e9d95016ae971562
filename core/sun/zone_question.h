#pragma once

#include <optional>

#include "core/base/warnings.h"
#include "core/geo/frame.h"
#include "core/sun/period.h"

namespace noonmark {

/// A warning if the clocks of the period's zone are more than 4 h from the mean solar time at the place: no
/// zone of the world is, summer time included. Nothing for UTC and fixed offsets ("Etc/GMT+5"), which are
/// chosen for other reasons, and for unknown zones.
std::optional<Warning> questionZone(const Period& period, LonLat place);

}  // namespace noonmark
