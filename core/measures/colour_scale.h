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

/// Minutes of change a day at the ends of scales that are not fitted to one difference.
inline constexpr double lockedChangeMin = 60;

/// How one map colours its values: a legend's choice fitted to the map. Pictures, legends and styles of QGIS
/// all take their colours from here. A value.
struct ColourScale {
    enum class Of {
        minutes,  ///< of shadow a day
        change,   ///< minutes a day more or less than before
        wanted,   ///< of which more is better: a score, light at a window
    };

    ShownQuantity quantity;
    Ramp ramp = Ramp::noonmark;
    bool reversed = false;
    bool paintsZero = false;             ///< false: cells without any shadow, change or score have no colour
    double low = 0, high = 1, tick = 1;  ///< in the unit shown
    std::vector<double> breaks{};        ///< ascending, between the classes; empty: continuous
    Of of = Of::minutes;
    double zero = 0;  ///< values up to this, of either sign, count as 0

    /// The colour of a value as files hold it: gross or continuous minutes, their change, what is wanted.
    /// None for NaN and for values that have no colour. O(log classes).
    [[nodiscard]] std::optional<Rgb> pick(double value) const;
    /// What the legend shows of such a value, and back.
    [[nodiscard]] double shownOf(double value) const;
    [[nodiscard]] double valueOf(double shown) const;
    /// The colour of a value in the unit shown.
    [[nodiscard]] Rgb colourOf(double shown) const;
    /// The classes between the breaks; empty for a continuous scale.
    [[nodiscard]] std::vector<ColourClass> classes() const;
    [[nodiscard]] std::string_view unit() const;  ///< "h"; empty of what is wanted
    /// Whether the colours run against the values of files: more of what is shown is less shadow.
    [[nodiscard]] bool isWanted() const { return quantity.isSun() || of == Of::wanted; }
    /// Whether cells of 0 stay without colour: never where sun is shown, since no shadow is the most sun.
    [[nodiscard]] bool leavesZeroUncoloured() const {
        return !paintsZero && (of != Of::minutes || !quantity.isSun());
    }
};

/// The scale of a map. `topMin`: minutes of the end of a fitted scale of shadow, which becomes round;
/// `minutes`: of its cells, for quantiles. Fitted scales of sun and share end at the sunlit time. O(1), with
/// quantiles O(cells log cells).
ColourScale makeColourScale(const LegendChoice& choice, const ShownQuantity& quantity, double topMin,
                            std::span<const float> minutes);

/// The scale of values around zero, from -ends.top to ends.top; those up to `zero` have no colour.
/// `quantity`: of a change. Cost as of makeColourScale().
ColourScale makeSignedScale(const LegendChoice& choice, ColourScale::Of of, const ShownQuantity& quantity,
                            LegendScale ends, double zero, std::span<const float> values);

/// The scale of hours of sun a day of places: the classes of the choice or, while it is continuous, three on
/// each side of a threshold, the outermost of which are open. In violet below the threshold and orange from
/// it on, unless the choice names other colours. Its range and typed numbers count where it shows hours of
/// sun. `hours`: of the places, for the fitted range and quantiles; NaN: none. O(places log places)
ColourScale makeThresholdScale(const LegendChoice& choice, double thresholdHours,
                               std::span<const double> hours);

/// The scale of the change of sun of places, minutes of sun a day: with the choice's equal classes or, where
/// it shows sun, typed numbers.
ColourScale makePlaceChangeScale(const LegendChoice& choice);

/// The scale of values in a unit of their own of which more is better, from 0, or around zero from -ends.top,
/// to ends.top: with the choice's colours and equal classes; its other classes and its range are of minutes.
ColourScale makeWantedScale(const LegendChoice& choice, LegendScale ends, bool aroundZero);

/// A scale of minutes of shadow from 0 to `topMin` in the default colours.
ColourScale plainScale(double topMin);

}  // namespace noonmark
