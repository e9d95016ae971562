#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/city/trees/tree.h"

namespace noonmark {

/// Trees that are alike where nothing is known of the single one (resources/trees/defaults.json, which states
/// the sources).
struct TreeGroup {
    std::string key;  ///< "dense"
    CrownShape shape = CrownShape::ellipsoid;
    bool evergreen = false;
    float leafOn = 0, leafOff = 0;  ///< share of the sun that passes on the mean chord
    double crownPerStem = 1;        ///< crown diameter over stem diameter
    double heightPerCrown = 1;      ///< height over crown diameter
    double crownBaseShare = 0;      ///< of the height, below the crown
    double heightM = 1;             ///< where nothing is known
    std::vector<std::string> genera;
};

/// The shipped groups; the first is that of trees whose genus is unknown.
const std::vector<TreeGroup>& listTreeGroups();

/// The group of a species, by its genus: the first word of the text, in any case; null: unknown.
const TreeGroup* findTreeGroup(std::string_view species);
/// The group with this key, which must be there.
const TreeGroup& treeGroup(std::string_view key);

}  // namespace noonmark
