#pragma once

#include <limits>
#include <optional>
#include <string>

#include "core/measures/legend_choice.h"

namespace noonmark {

/// Values of one colour, in the unit shown: low is included, high is not.
struct ColourClass {
    double low = 0, high = 0;  ///< infinite in the outermost ones
    Rgb colour;
    std::string label;  ///< "2 to 4 h"
};

/// How one map colours its minutes: a legend's choice fitted to the map. Pictures, legends and styles of QGIS
/// all take their colours from here. A value.
struct ColourScale {
    ShownQuantity quantity;
    Ramp ramp = Ramp::noonmark;
    bool reversed = false;
    bool paintsZero = false;             ///< false: cells without any shadow stay free, where shadow is shown
    double low = 0, high = 1, tick = 1;  ///< in the unit shown
    std::vector<double> breaks{};        ///< ascending, between the classes; empty: continuous

    /// The colour of gross minutes a day, or of continuous minutes where these are shown; none for NaN and
    /// for what stays free. O(log classes).
    [[nodiscard]] std::optional<Rgb> pick(double minutes) const;
    /// Of a value in the unit shown.
    [[nodiscard]] Rgb colourOf(double value) const;
    /// Empty for a continuous scale.
    [[nodiscard]] std::vector<ColourClass> classes() const;
};

/// The scale of a map. `topMin`: minutes of the end of a fitted scale of shadow, which becomes round;
/// `minutes`: of its cells, for quantiles. Fitted scales of sun and share end at the sunlit time. O(1), with
/// quantiles O(cells log cells).
ColourScale makeColourScale(const LegendChoice& choice, const ShownQuantity& quantity, double topMin,
                            std::span<const float> minutes);

/// A scale of minutes of shadow from 0 to `topMin` in the usual colours.
ColourScale plainScale(double topMin);

}  // namespace noonmark
