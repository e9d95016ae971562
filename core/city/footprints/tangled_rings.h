#pragma once

#include <cstddef>
#include <vector>

#include "core/city/footprints/repair_footprint.h"

namespace noonmark {

/// More crossings than this no outline of a building has; making it valid would take seconds to minutes.
inline constexpr std::size_t mostCrossings = 2000;

/// Whether the rings' sides meet more than mostCrossings times, the common points of neighbouring sides not
/// counted; also where so many sides lie beside one another that counting them would take over 0.2 s. Points
/// must be finite.
bool areTangled(const std::vector<RawRing>& rings);

}  // namespace noonmark
