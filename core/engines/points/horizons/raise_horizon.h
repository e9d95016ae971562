#pragma once

#include <glm/vec3.hpp>

#include "core/engines/points/horizons/bin_directions.h"
#include "core/engines/points/horizons/obstacle_blocks.h"

namespace noonmark {

/// Raises a point's horizon (`eye`, local metres) by every edge that rises above it, from near to far: what
/// lies behind higher obstacles is left out by its box. Boxes and edges are chosen by azimuths that are a
/// 500th of a bin uncertain, with more to spare; whether an edge covers a bin's middle is decided in double
/// precision, so that edges which share a corner leave no bin between them.
void raiseHorizon(const EdgeTree& edges, const BinDirections& bins, glm::vec3 eye, BinTangents& horizon);

/// The same, and raises bounds: `touch` by what an edge reaches anywhere in a bin, `cover` by what one edge
/// hides at every azimuth of a bin. Of farther edges, `cover` misses those that lie behind the horizon.
void raiseHorizonAndBounds(const EdgeTree& edges, const BinDirections& bins, glm::vec3 eye,
                           BinTangents& horizon, BinTangents& touch, BinTangents& cover);

}  // namespace noonmark
