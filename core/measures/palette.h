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

/// Colours from much sun (bright) to much shadow (dark).
enum class Ramp { noonmark, viridis, cividis, magma, grey, trafficLight };
/// Whether its colours are told apart by readers who see no difference of red and green.
constexpr bool isColourBlindSafe(Ramp ramp) { return ramp != Ramp::trafficLight; }
/// The same of any ramp: 0 is bright, 1 dark. Ramp::noonmark is shadowRgb().
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
