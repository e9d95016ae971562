#include "core/measures/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

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

// From bright to dark. Viridis, Cividis and Magma: samples of matplotlib's colour maps (CC0), which are safe
// for colour-blind readers and even in grey print; the last is ColorBrewer's RdYlGn, which is neither.
constexpr std::array viridisStops{Rgb{0xfd, 0xe7, 0x25}, Rgb{0xad, 0xdc, 0x30}, Rgb{0x5e, 0xc9, 0x62},
                                  Rgb{0x28, 0xae, 0x80}, Rgb{0x21, 0x91, 0x8c}, Rgb{0x2c, 0x72, 0x8e},
                                  Rgb{0x3b, 0x52, 0x8b}, Rgb{0x47, 0x2d, 0x7b}, Rgb{0x44, 0x01, 0x54}};
constexpr std::array cividisStops{Rgb{0xff, 0xea, 0x46}, Rgb{0xbc, 0xaf, 0x6f}, Rgb{0x7c, 0x7b, 0x78},
                                  Rgb{0x41, 0x4d, 0x6b}, Rgb{0x00, 0x20, 0x4d}};
constexpr std::array magmaStops{Rgb{0xfc, 0xfd, 0xbf}, Rgb{0xfb, 0x88, 0x61}, Rgb{0xb6, 0x36, 0x79},
                                Rgb{0x51, 0x12, 0x7c}, Rgb{0x00, 0x00, 0x04}};
constexpr std::array greyStops{Rgb{0xf7, 0xf7, 0xf7}, Rgb{0x1f, 0x1f, 0x1f}};
constexpr std::array trafficStops{Rgb{0x1a, 0x98, 0x50}, Rgb{0x91, 0xcf, 0x60}, Rgb{0xff, 0xff, 0xbf},
                                  Rgb{0xfc, 0x8d, 0x59}, Rgb{0xd7, 0x30, 0x27}};

// The more sun, the lighter, also in grey print. Violet and orange differ for all kinds of colour blindness.
constexpr std::array violetOrangeStops{Rgb{0xfe, 0xec, 0xb5}, Rgb{0xfc, 0xc8, 0x6a}, Rgb{0xf1, 0xa3, 0x40},
                                       Rgb{0x99, 0x8e, 0xc3}, Rgb{0x5b, 0x3a, 0x9b}, Rgb{0x2d, 0x10, 0x60}};
// ColorBrewer's PuOr, RdBu and RdYlGn; the last is not safe for colour-blind readers.
constexpr std::array orangePurpleStops{Rgb{0xb3, 0x58, 0x06}, Rgb{0xf1, 0xa3, 0x40}, Rgb{0xf7, 0xf7, 0xf7},
                                       Rgb{0x99, 0x8e, 0xc3}, Rgb{0x54, 0x27, 0x88}};
constexpr std::array blueRedStops{Rgb{0x21, 0x66, 0xac}, Rgb{0x67, 0xa9, 0xcf}, Rgb{0xf7, 0xf7, 0xf7},
                                  Rgb{0xef, 0x8a, 0x62}, Rgb{0xb2, 0x18, 0x2b}};
constexpr std::array greenRedStops{Rgb{0x1a, 0x98, 0x50}, Rgb{0x91, 0xcf, 0x60}, Rgb{0xff, 0xff, 0xbf},
                                   Rgb{0xfc, 0x8d, 0x59}, Rgb{0xd7, 0x30, 0x27}};

std::span<const Rgb> stopsOf(Ramp ramp) {
    switch (ramp) {
        case Ramp::viridis:
            return viridisStops;
        case Ramp::cividis:
            return cividisStops;
        case Ramp::magma:
            return magmaStops;
        case Ramp::trafficLight:
            return trafficStops;
        case Ramp::violetOrange:
            return violetOrangeStops;
        case Ramp::orangePurple:
            return orangePurpleStops;
        case Ramp::blueRed:
            return blueRedStops;
        case Ramp::greenRed:
            return greenRedStops;
        default:
            return greyStops;
    }
}

Rgb mixStops(std::span<const Rgb> stops, double share) {
    const double along = share * double(stops.size() - 1);
    const auto from = std::min<std::size_t>(std::size_t(along), stops.size() - 2);
    const Rgb &a = stops[from], &b = stops[from + 1];
    const auto mix = [t = along - double(from)](std::uint8_t low, std::uint8_t high) {
        return std::uint8_t(std::lround(std::lerp(double(low), double(high), t)));
    };
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

// Smaller or larger steps are not needed: a day has 1,440 minutes.
constexpr std::array tickSteps{0.01, 0.02, 0.05, 0.1,  0.2,  0.5,   1.0,  2.0,
                               5.0,  10.0, 15.0, 30.0, 60.0, 120.0, 240.0};
constexpr double maxTicks = 8;

}  // namespace

Rgb shadowRgb(double share) {
    static const Table table = shadowTable();
    const double clamped = share > 0 ? std::min(share, 1.0) : 0.0;  // NaN is not above 0
    return table[std::size_t(std::lround(clamped * (tableSize - 1)))];
}

Rgb rampRgb(Ramp ramp, double share) {
    const double clamped = share > 0 ? std::min(share, 1.0) : 0.0;  // NaN is not above 0
    if (ramp == Ramp::noonmark) return shadowRgb(clamped);
    if (ramp == Ramp::greenBrown) return impactRgb(2 * clamped - 1);
    return mixStops(stopsOf(ramp), clamped);
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
        if ((largestValue - slack) / step <= maxTicks) break;
    }
    while ((largestValue - slack) / tick > maxTicks) tick *= 2;
    return {std::ceil((largestValue - slack) / tick) * tick, tick};
}

}  // namespace noonmark
