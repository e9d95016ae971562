#pragma once

#include <cstddef>
#include <vector>

#include "core/city/footprints/repair_footprint.h"

namespace noonmark {

/// No building outline has more crossings than this; making such a polygon valid would take seconds to
/// minutes.
inline constexpr std::size_t maxCrossings = 2000;

/// Whether the sides of the rings cross or touch more than maxCrossings times, not counting the common
/// points of neighbouring sides. Also true if so many sides lie beside one another that counting would take
/// over 0.2 s. Points must be finite.
bool areTangled(const std::vector<RawRing>& rings);

}  // namespace noonmark
