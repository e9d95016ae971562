#pragma once

#include <cstdint>

namespace noonmark {

/// sRGB, 8 bits per channel.
struct Rgb {
    std::uint8_t red = 0, green = 0, blue = 0;
    bool operator==(const Rgb&) const = default;
};

/// Colours for a field of minutes: from warm light (sun) to deep indigo (shadow). Sequential, safe for
/// colour-blind readers and readable in grey print: CIELAB lightness decreases evenly from no shadow to most
/// shadow. A table look-up, for use per cell.
Rgb shadowRgb(double share);  ///< share of the legend's range, 0 to 1, clamped; NaN counts as 0

/// Colours of a legend.
enum class Ramp {
    // From much sun (bright) to much shadow (dark).
    noonmark,
    viridis,
    cividis,
    magma,
    grey,
    trafficLight,
    violetOrange,  ///< orange changes to violet in the middle, where a threshold may lie
    // Around a pale middle, which is no change, from less shadow to more.
    greenBrown,  ///< impactRgb()
    orangePurple,
    blueRed,
    greenRed,
};
/// Whether its colours are told apart by readers who see no difference of red and green.
constexpr bool isColourBlindSafe(Ramp ramp) { return ramp != Ramp::trafficLight && ramp != Ramp::greenRed; }
/// The colour at a share of the ramp, 0 to 1, clamped: 0 is bright and 1 dark, or 0 is least and 1 most
/// shadow. NaN counts as 0. Ramp::noonmark is shadowRgb().
Rgb rampRgb(Ramp ramp, double share);

/// Colours for a field of changes: green-blue is less shadow (-1), nearly white no change (0), red-brown more
/// (1). Equal steps on both sides are equally dark and can be distinguished without red and green.
Rgb impactRgb(double share);  ///< -1 to 1, clamped; NaN counts as 0

/// A round upper end for a legend, and its ticks: 360 -> 360 by 60; 47 -> 50 by 10. Four to eight ticks, in
/// steps that are natural for minutes. A value of zero or below gives {1, 1}.
struct LegendScale {
    double top = 1;
    double tick = 1;
};
LegendScale legendScale(double largestValue);

}  // namespace noonmark
