#pragma once

#include <QColor>
#include <span>

namespace noonmark {

/// Colours for a field of minutes: a sequential palette that is safe for the colour-blind and readable in grey print
/// (lightness falls evenly from no shadow to most shadow).
QColor shadowColour(double share);  ///< share of the legend's range, 0 to 1, clamped

/// A round upper end for a legend and its ticks: 360 -> 360 by 60; 47 -> 50 by 10.
struct LegendScale {
    double top = 1;
    double tick = 1;
};
LegendScale legendScale(double largestValue);

}  // namespace noonmark
