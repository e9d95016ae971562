#include "core/measures/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace noonmark {

namespace {

/// CIELAB in polar form, D65: lightness 0 to 100, chroma, hue in degrees.
struct Lch {
    double lightness;
    double chroma;
    double hue;
};

// The hue runs from yellow over apricot, rose and purple to indigo. Lightness is not in this table: it
// decreases linearly.
constexpr std::array<Lch, 5> shadowStops{
    {{95, 24, 98}, {75, 46, 66}, {55, 55, 14}, {35, 54, -38}, {15, 38, -64}}};
constexpr Lch noChange{96, 0, 80};
constexpr Lch lessShadow{35, 26, 225};
constexpr Lch moreShadow{35, 50, 50};

double labInverse(double t) {
    return t > 6.0 / 29 ? t * t * t : 3 * (6.0 / 29) * (6.0 / 29) * (t - 4.0 / 29);
}

double encoded(double linear) {
    const double c = std::clamp(linear, 0.0, 1.0);
    return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

/// IEC 61966-2-1 (sRGB) from CIE 1976 L*a*b*, D65 white; colours outside sRGB are clipped.
Rgb pickColour(const Lch& lch) {
    const double hue = lch.hue * std::numbers::pi / 180;
    const double fy = (lch.lightness + 16) / 116;
    const double x = 0.95047 * labInverse(fy + lch.chroma * std::cos(hue) / 500);
    const double y = labInverse(fy);
    const double z = 1.08883 * labInverse(fy - lch.chroma * std::sin(hue) / 200);
    const auto rgb = [](double linear) { return std::uint8_t(std::lround(255 * encoded(linear))); };
    return {rgb(3.2404542 * x - 1.5371385 * y - 0.4985314 * z),
            rgb(-0.9692660 * x + 1.8760108 * y + 0.0415560 * z),
            rgb(0.0556434 * x - 0.2040259 * y + 1.0572252 * z)};
}

Lch between(const Lch& a, const Lch& b, double share) {
    return {std::lerp(a.lightness, b.lightness, share), std::lerp(a.chroma, b.chroma, share),
            std::lerp(a.hue, b.hue, share)};
}

constexpr int tableSize = 1024;  // finer than 8 bits per channel can show
using Table = std::array<Rgb, tableSize>;

Table shadowTable() {
    Table table;
    for (int i = 0; i < tableSize; ++i) {
        const double along = double(i) / (tableSize - 1) * (shadowStops.size() - 1);
        const auto from = std::min<std::size_t>(std::size_t(along), shadowStops.size() - 2);
        table[std::size_t(i)] =
            pickColour(between(shadowStops[from], shadowStops[from + 1], along - double(from)));
    }
    return table;
}

// Smaller or larger steps are not needed: a day has 1,440 minutes.
constexpr std::array tickSteps{0.01, 0.02, 0.05, 0.1,  0.2,  0.5,   1.0,  2.0,
                               5.0,  10.0, 15.0, 30.0, 60.0, 120.0, 240.0};
constexpr double mostTicks = 8;

}  // namespace

Rgb shadowRgb(double share) {
    static const Table table = shadowTable();
    const double clamped = share > 0 ? std::min(share, 1.0) : 0.0;  // NaN is not above 0
    return table[std::size_t(std::lround(clamped * (tableSize - 1)))];
}

Rgb impactRgb(double share) {
    const double clamped = std::isnan(share) ? 0 : std::clamp(share, -1.0, 1.0);
    Lch end = clamped < 0 ? lessShadow : moreShadow;
    Lch middle = noChange;
    middle.hue = end.hue;  // white has no hue
    return pickColour(between(middle, end, std::abs(clamped)));
}

LegendScale legendScale(double largestValue) {
    if (!(largestValue > 0) || !std::isfinite(largestValue)) return {};
    const double slack = largestValue * 1e-9;  // rounding errors, as of 0.1 x 3, must not add a tick
    double tick = tickSteps.front();
    for (const double step : tickSteps) {
        tick = step;
        if ((largestValue - slack) / step <= mostTicks) break;
    }
    while ((largestValue - slack) / tick > mostTicks) tick *= 2;
    return {std::ceil((largestValue - slack) / tick) * tick, tick};
}

}  // namespace noonmark
