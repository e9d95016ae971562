#pragma once

#include "core/city/city.h"

namespace noonmark {

/// Local z of the ground from which a building's heights are counted: the underside of its lowest part that
/// stands on the ground (reachesGround()); if all parts are overhangs, the terrain under its middle (0
/// without terrain).
float findGroundUnder(const Building& building, const City& city);

/// Height of a building's highest point above that ground, metres.
float heightM(const Building& building, const City& city);

}  // namespace noonmark
