#pragma once

#include <array>
#include <string_view>

#include "core/describe/choice.h"
#include "core/describe/text.h"

namespace noonmark {

/// Which shadow is measured beside that without trees, where a city has trees.
enum class TreeColumns {
    all,        ///< both that follow
    without,    ///< none: as if there were no tree
    evergreen,  ///< every tree in leaf all year
    seasonal,   ///< trees that lose their leaves are bare out of season
};

inline constexpr std::array treeColumnChoices{
    Choice{TreeColumns::all, "all", NM_TEXT("without trees, as evergreens, with seasons")},
    Choice{TreeColumns::without, "without", NM_TEXT("without trees")},
    Choice{TreeColumns::evergreen, "evergreen", NM_TEXT("as evergreens")},
    Choice{TreeColumns::seasonal, "seasonal", NM_TEXT("with seasons")}};

}  // namespace noonmark
