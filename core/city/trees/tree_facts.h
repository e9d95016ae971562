#pragma once

#include <optional>
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

/// TreeFacts::sourceId of the cells of a canopy raster.
inline constexpr std::string_view canopyRasterId = "canopy";

/// What data state of a tree; metres.
struct TreeFacts {
    std::string sourceId;
    std::string species;  ///< Latin or common, as stated; genus first if both are
    std::optional<double> heightM;
    std::optional<double> crownDiameterM;
    std::optional<double> crownBaseM;  ///< above its foot
    std::optional<double> stemDiameterM;
    std::optional<bool> evergreen;                                           ///< leaf cycle
    std::optional<bool> needles;                                             ///< leaf type
    std::optional<int> leafOnDay = std::nullopt, leafOffDay = std::nullopt;  ///< as those of Tree
    /// Area of the cell, where the tree is one cell of a canopy raster, or of a wood (coverWithCanopy()). The
    /// tree is a cylinder of that area.
    std::optional<double> canopyCellM2;
};

/// The tree with these facts; what they do not state is estimated from what they do, else the default of its
/// group (findTreeGroup()). The facts must be plausible; readers leave others out with a warning.
Tree completeTree(const TreeFacts& facts);

/// What a user states of a new tree: species, height, crown, crown base, stem and leaves.
const Fields<TreeFacts>& treeFactFields();

/// The tree after `years`, 0 to 200: its crown grows as its stem does, by the same width each year, its
/// height with the crown, the crown's base with the height (resources/trees/defaults.json). Grows up to 35 m
/// high. A higher one, and a cell of a canopy raster, comes back as it is; of the others both sources are
/// "estimated".
Tree growTree(const Tree& tree, double years);

/// Whether a tree may measure so many metres: within the ranges of treeFactFields().
bool isPlausibleTreeHeight(double metres);
bool isPlausibleCrown(double metres);
bool isPlausibleStem(double metres);

}  // namespace noonmark
