#pragma once

#include "core/city/city.h"

namespace noonmark {

/// Local z of the ground that a building's heights are counted from: the underside of its lowest part that
/// stands; where all hang, the terrain under its middle (0 without terrain).
float findGroundUnder(const Building& building, const City& city);

/// Height of a building's highest point above that ground, metres.
float heightM(const Building& building, const City& city);

}  // namespace noonmark
