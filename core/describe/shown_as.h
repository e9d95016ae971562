#pragma once

#include <span>

#include "core/describe/choice.h"

namespace noonmark {

/// What is told of the time that a place spends in shadow.
enum class ShownAs {
    shadow,  ///< minutes in shadow a day
    sun,     ///< hours of sun a day: the sunlit time minus gross shadow
    share,   ///< per cent of the sunlit time that the place lies in the sun
};
std::span<const Choice<ShownAs>> shownChoices();

/// Which of the two complements a figure is about.
enum class Tells {
    always,
    shadow,      ///< left out where sun is shown
    sunInstead,  ///< stands for those of shadow where sun is shown; left out elsewhere
};
constexpr bool isTold(Tells tells, ShownAs show) {
    return tells == Tells::always || (tells == Tells::shadow) == (show == ShownAs::shadow);
}

}  // namespace noonmark
