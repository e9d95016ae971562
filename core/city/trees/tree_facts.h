#pragma once

#include <optional>
#include <string>

#include "core/city/trees/tree.h"

namespace noonmark {

/// What data state of a tree; metres.
struct TreeFacts {
    std::string sourceId;
    std::string species;  ///< Latin or common, as stated; genus first if both are
    std::optional<double> heightM;
    std::optional<double> crownDiameterM;
    std::optional<double> crownBaseM;  ///< above its foot
    std::optional<double> stemDiameterM;
    std::optional<bool> evergreen;  ///< leaf cycle
    std::optional<bool> needles;    ///< leaf type
    /// Of a cell of a canopy raster: its area. The tree is a cylinder of that area.
    std::optional<double> canopyCellM2;
};

/// The tree with these facts; what they do not state is estimated from what they do, else the default of its
/// group (tree_defaults.h). The facts must be plausible; readers leave others out with a warning.
Tree completeTree(const TreeFacts& facts);

/// Height 0.5 to 120 m, crown 0.3 to 50 m wide, stem 0.01 to 5 m thick.
bool isPlausibleTreeHeight(double metres);
bool isPlausibleCrown(double metres);
bool isPlausibleStem(double metres);

}  // namespace noonmark
