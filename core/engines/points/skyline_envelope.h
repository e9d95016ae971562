#pragma once

#include <vector>

#include "core/engines/points/seen_edge.h"

namespace noonmark {

/// The highest of the edges at every azimuth: pieces of edges in ascending order of azimuth within 0 to 2 pi,
/// without overlaps; between them there is no edge. Where two edges cross, the piece ends exactly there.
/// Edges across north are cut there. O(n log n).
std::vector<SeenEdge> findHighest(std::vector<SeenEdge> edges);

}  // namespace noonmark
