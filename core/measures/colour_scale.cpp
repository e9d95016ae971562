#include "core/measures/colour_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace noonmark {

namespace {

using Kind = LegendClasses::Kind;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double wholeSharePct = 100;
constexpr double shareTickPct = 20;

LegendScale fittedScale(const ShownQuantity& quantity, double topMin) {
    if (quantity.as == ShownAs::share) return {wholeSharePct, shareTickPct};
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
std::vector<double> quantileBreaks(const ColourScale& scale, std::span<const float> minutes, int count) {
    std::vector<double> values;
    for (const float one : minutes)
        if (scale.pick(double(one))) values.push_back(scale.quantity.of(double(one)));
    std::ranges::sort(values);
    std::vector<double> breaks;
    for (int i = 1; i < count && !values.empty(); ++i) {
        const double value = values[values.size() * std::size_t(i) / std::size_t(count)];
        const double round = std::round(value * 100) / 100;
        if (breaks.empty() || round > breaks.back()) breaks.push_back(round);
    }
    return breaks;
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
    if (one.low == -infinite) return fmt::format("below {:.6g} {}", one.high, unit);
    if (one.high == infinite) return fmt::format("{:.6g} {} and more", one.low, unit);
    return fmt::format("{:.6g} to {:.6g} {}", one.low, one.high, unit);
}

// Sun is bright at the high end, shadow at the low one.
Rgb colourAlong(const ColourScale& scale, double share) {
    return rampRgb(scale.ramp, scale.quantity.isSun() != scale.reversed ? 1 - share : share);
}

}  // namespace

std::optional<Rgb> ColourScale::pick(double minutes) const {
    if (std::isnan(minutes)) return std::nullopt;
    if (!paintsZero && !quantity.isSun() && minutes <= 0) return std::nullopt;
    return colourOf(quantity.of(minutes));
}

Rgb ColourScale::colourOf(double value) const {
    if (breaks.empty()) return colourAlong(*this, std::clamp((value - low) / (high - low), 0.0, 1.0));
    const auto index = std::size_t(std::ranges::upper_bound(breaks, value) - breaks.begin());
    return colourAlong(*this, shareOfClass(index, breaks.size() + 1));
}

std::vector<ColourClass> ColourScale::classes() const {
    std::vector<ColourClass> list;
    for (std::size_t i = 0; i <= breaks.size() && !breaks.empty(); ++i) {
        ColourClass one{i == 0 ? -infinite : breaks[i - 1],
                        i == breaks.size() ? infinite : breaks[i],
                        colourAlong(*this, shareOfClass(i, breaks.size() + 1)),
                        {}};
        one.label = labelOf(one, quantity.shortUnit());
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

ColourScale plainScale(double topMin) { return {.paintsZero = true, .high = topMin > 0 ? topMin : 1}; }

}  // namespace noonmark
