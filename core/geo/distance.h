#pragma once

#include "core/base/units.h"

namespace noonmark {

/// Metres between two places along the earth's surface, taken as a sphere: accurate to 0.5 %, which is enough
/// to tell near from far. Valid all round the earth, where a local plane folds back beyond its horizon. NaN
/// for NaN.
double computeGreatCircleM(LonLat a, LonLat b);

}  // namespace noonmark
