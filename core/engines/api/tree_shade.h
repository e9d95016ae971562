#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/describe/choice.h"
#include "core/describe/text.h"
#include "core/engines/api/shadow_field.h"

namespace noonmark {

/// Which shadow is measured beside that without trees, where a city has trees.
enum class TreeColumns {
    all,        ///< evergreen and seasonal
    without,    ///< none: as if there were no tree
    evergreen,  ///< every tree in leaf all year
    seasonal,   ///< trees that lose their leaves are bare out of season
};

inline constexpr std::array treeColumnChoices{
    Choice{TreeColumns::all, "all", NM_TEXT("without trees, as evergreens, with seasons")},
    Choice{TreeColumns::without, "without", NM_TEXT("without trees")},
    Choice{TreeColumns::evergreen, "evergreen", NM_TEXT("as evergreens")},
    Choice{TreeColumns::seasonal, "seasonal", NM_TEXT("with seasons")}};

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

/// One column of a TreeShade, with its name.
struct ShadeColumn {
    TreeColumns column;  ///< evergreen or seasonal
    const ShadowField* field;
};

/// The columns that a field has, evergreens first. They point into the field.
inline std::vector<ShadeColumn> listShadeColumns(const ShadowField& field) {
    std::vector<ShadeColumn> columns;
    if (field.trees && field.trees->evergreen)
        columns.push_back({TreeColumns::evergreen, &*field.trees->evergreen});
    if (field.trees && field.trees->seasonal)
        columns.push_back({TreeColumns::seasonal, &*field.trees->seasonal});
    return columns;
}

/// The ending of keys in files: "_evergreen".
inline std::string suffixOf(TreeColumns column) {
    std::string suffix("_");
    suffix += keyOf<TreeColumns>(treeColumnChoices, column);
    return suffix;
}

}  // namespace noonmark
