#pragma once

#include "core/city/footprints/footprint.h"

namespace noonmark {

/// The part of a ring inside the box (Sutherland and Hodgman); empty where there is none. Pieces that the box
/// separates stay joined along its edges, so that inside and outside by the even-odd rule stay the same
/// within the box, and a ring that crosses itself is no error. O(points).
Ring clipRing(const Ring& ring, const Box2& box);

}  // namespace noonmark
