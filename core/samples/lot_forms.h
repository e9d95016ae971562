#pragma once

#include <vector>

#include "core/samples/sample_random.h"
#include "core/samples/street_axes.h"

namespace noonmark {

/// A floor plan on a lot, in the lot's own axes: x along the street, y from the street inwards, metres, both
/// from 0. An outline counter-clockwise, then holes clockwise.
using Plan = std::vector<StreetPolygon>;

struct LotSize {
    double width, depth;
};

/// Plans that fill the lot's street front from side to side, so that neighbours share party walls. A yard
/// behind them stays free.
Plan rowPlan(LotSize lot, SampleRandom& random);
Plan lPlan(LotSize lot, SampleRandom& random);
Plan uPlan(LotSize lot, SampleRandom& random);
Plan courtPlan(LotSize lot, SampleRandom& random);
/// A front that bulges towards the street, with `points` points between its ends.
Plan bowedPlan(LotSize lot, int points, SampleRandom& random);

/// A rectangle `insetM` inside another plan's bounds on every side.
Plan insetPlan(LotSize lot, double insetM);
/// A circle in the middle of the lot, as a polygon with `sides` sides.
Plan roundPlan(LotSize lot, double radiusM, int sides);

}  // namespace noonmark
