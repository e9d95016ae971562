#pragma once

#include <vector>

#include "core/io/footprints/part_grouping.h"

namespace noonmark {

/// What is left of an outline between its parts.
struct OutlineRemainder {
    std::vector<Footprint> pieces;  ///< none where the parts cover it
    double bottomM = 0;             ///< above the ground
    double topM = 0;
    HeightSource source = HeightSource::assumed;
    bool guessed = false;  ///< topM is not the outline's own height
};

/// Parts replace their building's outline where they take up some of its height; a part that only begins
/// above the outline's stated height (a tower on a podium that is the outline) replaces nothing. What stays
/// uncovered, in pieces of at least 10 m2 that are 1 m wide somewhere, is built too. Its height:
/// - the outline's own, where that can not be the height of the building's tallest part: parts rise over 10 %
/// above it (50 % if it
///   was counted from storeys), or none comes to half of it;
/// - else the tallest part explains the outline's height, which says nothing of the rest: the lowest top
/// among the parts that stand on
///   the ground, or the lowest underside where none does; never above the outline's height.
OutlineRemainder computeRemainder(const PlacedFeature& outline,
                                  const std::vector<const PlacedFeature*>& parts);

}  // namespace noonmark
