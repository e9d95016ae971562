#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/city/footprints/footprint.h"

namespace noonmark {

/// The ground between two lines that run around polygons at a distance, metres, 0 <= inner < outer. Corners
/// are rounded by arcs of 16 chords a quarter, so that a line is at most 0.3 % of its distance too near.
/// Error: the polygons cannot be offset. Backend: line_belts_geos.cpp.
Result<std::vector<Footprint>> cutBelt(const std::vector<Footprint>& polygons, double innerM, double outerM);

/// The lines around polygons at a distance, metres, > 0: outer rings and the rings of holes. Corners and
/// errors as of cutBelt().
Result<std::vector<Ring>> drawLines(const std::vector<Footprint>& polygons, double offsetM);

}  // namespace noonmark
