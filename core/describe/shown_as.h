#pragma once

#include <span>

#include "core/describe/choice.h"

namespace noonmark {

/// Results are held in minutes; people read long times in hours.
inline constexpr double minutesPerHour = 60;
/// Shares are held as 0 to 1; people read percent.
inline constexpr double percentOfWhole = 100;

/// How the time that a place spends in shadow is shown.
enum class ShownAs {
    shadow,  ///< minutes in shadow a day
    sun,     ///< hours of sun a day: the sunlit time minus gross shadow
    share,   ///< per cent of the sunlit time that the place lies in the sun
};
std::span<const Choice<ShownAs>> shownChoices();

/// Which of the two complements a figure is about.
enum class ShownWith {
    always,
    shadow,      ///< left out where sun is shown
    sunInstead,  ///< stands for those of shadow where sun is shown; left out elsewhere
};
constexpr bool isShownAs(ShownWith shownWith, ShownAs show) {
    return shownWith == ShownWith::always || (shownWith == ShownWith::shadow) == (show == ShownAs::shadow);
}

}  // namespace noonmark
