#pragma once

#include "core/geo/frame.h"

namespace noonmark {

/// A box in longitude and latitude. West is the smaller number: boxes do not cross the antimeridian.
struct LonLatBox {
    double westDeg = 0, southDeg = 0, eastDeg = 0, northDeg = 0;
    bool operator==(const LonLatBox&) const = default;

    [[nodiscard]] bool touches(const LonLatBox& other) const {
        return westDeg <= other.eastDeg && eastDeg >= other.westDeg && southDeg <= other.northDeg &&
               northDeg >= other.southDeg;
    }
    void add(LonLat place);
};

/// A box without a point in it, to add places to.
inline constexpr LonLatBox emptyLonLatBox{1e9, 1e9, -1e9, -1e9};

/// A box around the local box from `lowM` to `highM`, with a margin of a metre. It covers all longitudes
/// where the local box reaches across the antimeridian.
LonLatBox makeLonLatBox(const Frame& frame, glm::dvec2 lowM, glm::dvec2 highM);

}  // namespace noonmark
