#pragma once

#include <string_view>

#include "core/describe/shown_as.h"

namespace noonmark {

/// The one conversion from gross shadow to what legends, pictures, texts and files show of it. Continuous
/// shadow has no such complement, since the longest run in the sun does not follow from the longest run in
/// shadow: it is always shown in minutes.
struct ShownQuantity {
    ShownAs as = ShownAs::shadow;
    double sunlitMin = 0;  ///< minutes a day with the sun up, mean over the days

    [[nodiscard]] bool isSun() const { return as != ShownAs::shadow; }
    /// What is shown of gross minutes a day. Never below 0, but where the argument is; NaN of NaN.
    [[nodiscard]] double of(double grossMin) const;
    /// The minutes of which of() gives this value.
    [[nodiscard]] double minutesOf(double value) const;
    /// What is shown of a difference of gross minutes a day: minutes of shadow, or of sun, which more shadow
    /// takes away.
    [[nodiscard]] double ofChange(double grossMin) const;
    /// What is shown of an error in gross minutes a day, without a sign.
    [[nodiscard]] double ofError(double grossMin) const;

    [[nodiscard]] std::string_view title() const;      ///< "Hours of sun"
    [[nodiscard]] std::string_view unit() const;       ///< "hours of sun a day"
    [[nodiscard]] std::string_view shortUnit() const;  ///< "h"
};

}  // namespace noonmark
