#pragma once

#include <vector>

#include "core/samples/sample_random.h"
#include "core/samples/street_axes.h"

namespace noonmark {

/// A lot in a block. Its front is on the street to the south or to the north.
struct Lot {
    StreetBox box;
    bool frontsNorth = false;
    StreetPolygon ground;  ///< the polygon of the box that a skewed avenue leaves

    [[nodiscard]] bool isWhole() const { return computeArea(ground) > 0.999 * box.width() * box.depth(); }
};

struct LotWidths {
    double narrowestM = 7.5;
    double widestM = 30;
    double preferWide = 0;  ///< 0: narrow lots are common; 1: all widths are equally likely
};

/// The lots of a block: two rows back to back, side by side without gaps; together they fill the block.
std::vector<Lot> cutIntoLots(const StreetBox& block, const LotWidths& widths, SampleRandom& random);

/// The lots with their ground cut by an avenue; lots with less than 60 m2 left are removed.
std::vector<Lot> cutBy(const SkewedAvenue& avenue, std::vector<Lot> lots);

}  // namespace noonmark
