#pragma once

#include "core/city/city.h"
#include "core/city/trees/tree_facts.h"
#include "scenarios/edits/edit.h"

namespace noonmark {

/// A tree that the user states: what is stated counts as designed, the rest is estimated or assumed
/// (completeTree()). Error: a crown's base above the top.
Result<Tree> designTree(const TreeFacts& facts);

/// Most trees of one row.
inline constexpr std::size_t maxTreeRow = 10'000;

/// Places of a row along a line, `spacingM` (> 0) apart, from its first corner on; local metres. Error: a
/// line of fewer than two corners, too many trees.
Result<std::vector<glm::dvec2>> placeTreesAlong(const std::vector<glm::dvec2>& line, double spacingM);

/// Plants the same tree at each place, under ids that are free in the city: "planted 1". O(trees of the
/// city).
std::vector<Edit> makePlantings(const City& city, const Tree& tree, const std::vector<glm::dvec2>& places);

/// The tree after some years; none where it does not grow (growTree()).
std::optional<Edit> makeGrowth(const Tree& tree, double years);

}  // namespace noonmark
