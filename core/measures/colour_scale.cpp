#include "core/measures/colour_scale.h"
#include "core/describe/shown_as.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace noonmark {

namespace {

using Kind = LegendClasses::Kind;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double shareTickPct = 20;

LegendScale fittedScale(const ShownQuantity& quantity, double topMin) {
    if (quantity.as == ShownAs::share) return {percentOfWhole, shareTickPct};
    return legendScale(quantity.isSun() ? quantity.of(0) : topMin);
}

// Round ticks if they meet both ends, else four.
double tickWithin(const LegendRange& range) {
    const double width = range.high - range.low;
    const LegendScale round = legendScale(width);
    return round.top == width && std::fmod(range.low, round.tick) == 0 ? round.tick : width / 4;
}

std::vector<double> equalBreaks(const ColourScale& scale, int count) {
    std::vector<double> breaks;
    for (int i = 1; i < count; ++i) breaks.push_back(std::lerp(scale.low, scale.high, double(i) / count));
    return breaks;
}

// Two decimals are enough for all units, and can be read.
std::vector<double> quantilesOf(std::vector<double> values, int count) {
    std::ranges::sort(values);
    std::vector<double> breaks;
    for (int i = 1; i < count && !values.empty(); ++i) {
        const double value = values[values.size() * std::size_t(i) / std::size_t(count)];
        const double round = std::round(value * 100) / 100;
        if (breaks.empty() || round > breaks.back()) breaks.push_back(round);
    }
    return breaks;
}

std::vector<double> quantileBreaks(const ColourScale& scale, std::span<const float> minutes, int count) {
    std::vector<double> values;
    for (const float one : minutes)
        if (scale.pick(double(one))) values.push_back(scale.shownOf(double(one)));
    return quantilesOf(std::move(values), count);
}

std::vector<double> breaksOf(const LegendClasses& classes, const ColourScale& scale,
                             std::span<const float> minutes) {
    switch (classes.kind) {
        case Kind::continuous:
            return {};
        case Kind::equal:
            return equalBreaks(scale, classes.count);
        case Kind::quantiles:
            return quantileBreaks(scale, minutes, classes.count);
        case Kind::breaks:
            return classes.breaks;
    }
    return {};
}

// The outermost classes are not at the very ends of the ramp, where paper and ink lie.
double shareOfClass(std::size_t index, std::size_t count) {
    constexpr double margin = 0.06;
    return margin + (1 - 2 * margin) * double(index) / double(count - 1);
}

std::string labelOf(const ColourClass& one, std::string_view unit) {
    const std::string in = unit.empty() ? std::string() : fmt::format(" {}", unit);
    if (one.low == -infinite) return fmt::format("below {:.6g}{}", one.high, in);
    if (one.high == infinite) return fmt::format("{:.6g}{} and more", one.low, in);
    return fmt::format("{:.6g} to {:.6g}{}", one.low, one.high, in);
}

// Sun is bright at the high end, shadow at the low one.
Rgb colourAlong(const ColourScale& scale, double share) {
    return rampRgb(scale.ramp, scale.isWanted() != scale.reversed ? 1 - share : share);
}

// Of two decimals, as those of quantiles.
std::vector<double> thirdsOf(double from, double to) {
    const auto round = [](double value) { return std::round(value * 100) / 100; };
    return {round(std::lerp(from, to, 1.0 / 3)), round(std::lerp(from, to, 2.0 / 3))};
}

}  // namespace

std::optional<Rgb> ColourScale::pick(double value) const {
    if (std::isnan(value)) return std::nullopt;
    const double amount = of == Of::minutes ? value : std::abs(value);
    if (leavesZeroUncoloured() && amount <= zero) return std::nullopt;
    return colourOf(shownOf(value));
}

double ColourScale::shownOf(double value) const {
    if (of == Of::wanted) return value;
    return of == Of::change ? quantity.ofChange(value) : quantity.of(value);
}

double ColourScale::valueOf(double shown) const {
    if (of == Of::wanted) return shown;
    return of == Of::change ? quantity.ofChange(shown) : quantity.minutesOf(shown);
}

std::string_view ColourScale::unit() const {
    if (of == Of::wanted) return {};
    return of == Of::change ? ShownQuantity{}.shortUnit() : quantity.shortUnit();
}

Rgb ColourScale::colourOf(double shown) const {
    if (breaks.empty()) return colourAlong(*this, std::clamp((shown - low) / (high - low), 0.0, 1.0));
    const auto index = std::size_t(std::ranges::upper_bound(breaks, shown) - breaks.begin());
    return colourAlong(*this, shareOfClass(index, breaks.size() + 1));
}

std::vector<ColourClass> ColourScale::classes() const {
    std::vector<ColourClass> list;
    for (std::size_t i = 0; i <= breaks.size() && !breaks.empty(); ++i) {
        ColourClass one{i == 0 ? -infinite : breaks[i - 1],
                        i == breaks.size() ? infinite : breaks[i],
                        colourAlong(*this, shareOfClass(i, breaks.size() + 1)),
                        {}};
        if (!(one.low < one.high)) continue;  // a threshold at the scale's end leaves no room beyond
        if (of == Of::minutes && one.high <= 0) continue;  // there is no less than none
        one.label = labelOf(one, unit());
        list.push_back(std::move(one));
    }
    return list;
}

ColourScale makeColourScale(const LegendChoice& choice, const ShownQuantity& quantity, double topMin,
                            std::span<const float> minutes) {
    ColourScale scale{.quantity = quantity, .ramp = choice.ramp, .reversed = choice.reversed};
    const LegendScale fitted = fittedScale(quantity, topMin);
    const LegendRange range = choice.range.value_or(LegendRange{0, fitted.top});
    scale.low = range.low;
    scale.high = range.high;
    scale.tick = choice.range ? tickWithin(range) : fitted.tick;
    scale.breaks = breaksOf(choice.classes, scale, minutes);
    return scale;
}

ColourScale makeSignedScale(const LegendChoice& choice, ColourScale::Of of, const ShownQuantity& quantity,
                            LegendScale ends, double zero, std::span<const float> values) {
    ColourScale scale{.quantity = quantity, .ramp = choice.changeRamp, .reversed = choice.changeReversed};
    scale.of = of;
    scale.zero = zero;
    scale.low = -ends.top;
    scale.high = ends.top;
    scale.tick = ends.tick;
    scale.breaks = breaksOf(choice.changeClasses, scale, values);
    return scale;
}

ColourScale makeThresholdScale(const LegendChoice& choice, double thresholdHours,
                               std::span<const double> hours) {
    const auto isHours = choice.show == ShownAs::sun;  // else what was typed is minutes, or per cent
    std::vector<double> known;
    std::ranges::copy_if(hours, std::back_inserter(known), [](double one) { return !std::isnan(one); });
    const double maximum = known.empty() ? 0 : std::ceil(std::ranges::max(known));
    ColourScale scale{.quantity = {ShownAs::sun}, .reversed = choice.reversed};
    scale.ramp = choice.ramp == LegendChoice{}.ramp ? Ramp::violetOrange : choice.ramp;
    const LegendRange range =
        isHours && choice.range ? *choice.range : LegendRange{0, std::max(maximum, thresholdHours + 1)};
    scale.low = range.low;
    scale.high = range.high;
    if (choice.classes.kind == Kind::equal) scale.breaks = equalBreaks(scale, choice.classes.count);
    if (choice.classes.kind == Kind::quantiles)
        scale.breaks = quantilesOf(std::move(known), choice.classes.count);
    if (choice.classes.kind == Kind::breaks && isHours) scale.breaks = choice.classes.breaks;
    if (!scale.breaks.empty()) return scale;
    scale.breaks = thirdsOf(range.low, thresholdHours);
    scale.breaks.push_back(thresholdHours);
    for (const double above : thirdsOf(thresholdHours, range.high)) scale.breaks.push_back(above);
    return scale;
}

ColourScale makePlaceChangeScale(const LegendChoice& choice) {
    ColourScale scale{
        .quantity = {ShownAs::sun}, .ramp = choice.changeRamp, .reversed = choice.changeReversed};
    scale.of = ColourScale::Of::change;
    scale.breaks = {-30, -10, -1, 1, 10, 30};
    scale.high = scale.breaks.back();
    scale.low = -scale.high;
    const LegendClasses& classes = choice.changeClasses;
    if (classes.kind == Kind::equal) scale.breaks = equalBreaks(scale, classes.count);
    if (classes.kind == Kind::breaks && choice.show == ShownAs::sun) scale.breaks = classes.breaks;
    return scale;
}

ColourScale makeWantedScale(const LegendChoice& choice, LegendScale ends, bool aroundZero) {
    ColourScale scale{.ramp = aroundZero ? choice.changeRamp : choice.ramp,
                      .reversed = aroundZero ? choice.changeReversed : choice.reversed,
                      .paintsZero = true,
                      .low = aroundZero ? -ends.top : 0,
                      .high = ends.top,
                      .tick = ends.tick};
    scale.of = ColourScale::Of::wanted;
    const LegendClasses& classes = aroundZero ? choice.changeClasses : choice.classes;
    if (classes.kind == Kind::equal) scale.breaks = equalBreaks(scale, classes.count);
    return scale;
}

ColourScale plainScale(double topMin) { return {.paintsZero = true, .high = topMin > 0 ? topMin : 1}; }

}  // namespace noonmark
