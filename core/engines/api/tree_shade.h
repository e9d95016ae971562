#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/engines/api/shadow_field.h"
#include "core/engines/api/tree_columns.h"

namespace noonmark {

/// The shadow of a period with trees, on the receivers of the field that holds it. Gross minutes are weighted
/// by what buildings and crowns take from the sun at each step; longest runs count the steps at which at
/// least `shadedFrom` of it is taken. The fields' costs and warnings are empty. At least one is there.
struct TreeShade {
    static constexpr double defaultShadedFrom = 0.5;
    std::optional<ShadowField> evergreen;  ///< every tree in leaf all year
    std::optional<ShadowField> seasonal;   ///< trees bare out of season
    double shadedFrom = defaultShadedFrom;
    std::size_t treesUsed = 0;  ///< trees whose shadow can reach a receiver
    std::string how;            ///< in words, for the report
};

/// One of them, with its name.
struct ShadeColumn {
    TreeColumns column;  ///< evergreen or seasonal
    const ShadowField* field;
};

/// Those that a field has, evergreens first. They point into the field.
inline std::vector<ShadeColumn> listShadeColumns(const ShadowField& field) {
    std::vector<ShadeColumn> columns;
    if (field.trees && field.trees->evergreen)
        columns.push_back({TreeColumns::evergreen, &*field.trees->evergreen});
    if (field.trees && field.trees->seasonal)
        columns.push_back({TreeColumns::seasonal, &*field.trees->seasonal});
    return columns;
}

/// What keys of files end in: "_evergreen".
inline std::string suffixOf(TreeColumns column) {
    std::string suffix("_");
    suffix += keyOf<TreeColumns>(treeColumnChoices, column);
    return suffix;
}

}  // namespace noonmark
