#pragma once

#include <vector>

#include "core/io/footprints/part_grouping.h"

namespace noonmark {

/// The area of an outline that its parts leave uncovered.
struct OutlineRemainder {
    std::vector<Footprint> pieces;  ///< none if the parts cover the outline
    double bottomM = 0;             ///< above the ground
    double topM = 0;
    HeightSource source = HeightSource::assumed;
    bool guessed = false;  ///< topM is not the height stated for the outline
};

/// Parts replace the outline of their building where they occupy some of its height; a part that begins above
/// the outline's stated height (a tower on a podium, with the podium as the outline) replaces nothing. The
/// uncovered rest, in pieces of at least 10 m2 that are 1 m wide somewhere, is built too. Its height:
/// - The outline's own height, if that cannot be the height of the building's tallest part: parts rise over
///   10 % above it (50 % if it was counted from storeys), or none reaches half of it.
/// - Otherwise the outline's height is that of the tallest part and says nothing about the rest. It then gets
///   the lowest top of the parts that stand on the ground, or the lowest underside if no part does; never
///   more than the outline's height.
OutlineRemainder computeRemainder(const PlacedFeature& outline,
                                  const std::vector<const PlacedFeature*>& parts);

}  // namespace noonmark
