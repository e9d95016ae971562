#include "app/report/maps/style.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace noonmark {
namespace {

using LinearRgb = std::array<double, 3>;  // linear light

double decoded(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

LinearRgb linearOf(const QColor& colour) {
    return {decoded(colour.red() / 255.0), decoded(colour.green() / 255.0), decoded(colour.blue() / 255.0)};
}

double labCurve(double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; }

std::array<double, 3> labOf(const LinearRgb& rgb) {
    const double x = (0.4124564 * rgb[0] + 0.3575761 * rgb[1] + 0.1804375 * rgb[2]) / 0.95047;
    const double y = 0.2126729 * rgb[0] + 0.7151522 * rgb[1] + 0.0721750 * rgb[2];
    const double z = (0.0193339 * rgb[0] + 0.1191920 * rgb[1] + 0.9503041 * rgb[2]) / 1.08883;
    return {116 * labCurve(y) - 16, 500 * (labCurve(x) - labCurve(y)), 200 * (labCurve(y) - labCurve(z))};
}

/// Complete deuteranopia: Machado, Oliveira and Fernandes (2009), severity 1, on linear light.
LinearRgb deuteranope(const LinearRgb& c) {
    return {0.367322 * c[0] + 0.860646 * c[1] - 0.227968 * c[2],
            0.280085 * c[0] + 0.672501 * c[1] + 0.047413 * c[2],
            -0.011820 * c[0] + 0.042940 * c[1] + 0.968881 * c[2]};
}

/// Complete protanopia, the same source.
LinearRgb protanope(const LinearRgb& c) {
    return {0.152286 * c[0] + 1.052583 * c[1] - 0.204868 * c[2],
            0.114503 * c[0] + 0.786281 * c[1] + 0.099216 * c[2],
            -0.003882 * c[0] - 0.048116 * c[1] + 1.051998 * c[2]};
}

double difference(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

TEST(ShadowPalette, LightnessFallsEvenly) {
    constexpr int steps = 60;
    for (int i = 0; i <= steps; ++i) {
        const double share = double(i) / steps;
        EXPECT_NEAR(labOf(linearOf(shadowColour(share)))[0], 95 - 80 * share, 0.7) << share;
    }
}

TEST(ShadowPalette, NeighbouringTicksStayApartForTheColourBlind) {
    for (int i = 0; i < 8; ++i) {
        const LinearRgb here = linearOf(shadowColour(i / 8.0));
        const LinearRgb next = linearOf(shadowColour((i + 1) / 8.0));
        EXPECT_GT(difference(labOf(deuteranope(here)), labOf(deuteranope(next))), 7) << i;
        EXPECT_GT(difference(labOf(protanope(here)), labOf(protanope(next))), 7) << i;
    }
}

TEST(ShadowPalette, SunIsWarmAndLightShadowIsBlueAndDark) {
    const QColor sun = shadowColour(0);
    const QColor shadow = shadowColour(1);
    EXPECT_GT(sun.red(), sun.blue());
    EXPECT_GT(shadow.blue(), shadow.red());
    EXPECT_GT(sun.lightness(), 200);
    EXPECT_LT(shadow.lightness(), 60);
}

TEST(ShadowPalette, SharesOutsideAreClamped) {
    EXPECT_EQ(shadowColour(-3), shadowColour(0));
    EXPECT_EQ(shadowColour(7), shadowColour(1));
    EXPECT_EQ(shadowColour(std::numeric_limits<double>::quiet_NaN()), shadowColour(0));
}

TEST(ImpactPalette, BothSidesAreEquallyDarkAndApart) {
    for (const double share : {0.25, 0.5, 1.0}) {
        const LinearRgb less = linearOf(impactColour(-share));
        const LinearRgb more = linearOf(impactColour(share));
        EXPECT_NEAR(labOf(less)[0], labOf(more)[0], 1.5) << share;
        EXPECT_GT(difference(labOf(deuteranope(less)), labOf(deuteranope(more))), 12) << share;
    }
    EXPECT_EQ(impactColour(-9), impactColour(-1));
    EXPECT_GT(impactColour(0).lightness(), 235);
    EXPECT_EQ(impactColour(std::numeric_limits<double>::quiet_NaN()), impactColour(0));
}

struct ScaleCase {
    double largest, top, tick;
};

TEST(LegendScale, TopIsRoundAndTicksAreFew) {
    for (const ScaleCase& c : {ScaleCase{360, 360, 60},
                               {47, 50, 10},
                               {331.5, 360, 60},
                               {480, 480, 60},
                               {481, 600, 120},
                               {1440, 1440, 240},
                               {60, 60, 10},
                               {90, 90, 15},
                               {30, 30, 5},
                               {8, 8, 1},
                               {1, 1, 0.2},
                               {0.3, 0.3, 0.05},
                               {5000, 5280, 960}}) {
        const LegendScale scale = legendScale(c.largest);
        EXPECT_DOUBLE_EQ(scale.tick, c.tick) << c.largest;
        EXPECT_DOUBLE_EQ(scale.top, std::ceil(c.largest / c.tick - 1e-6) * c.tick) << c.largest;
    }
}

TEST(LegendScale, HoldsForAnyValue) {
    for (double value = 0.013; value < 1e7; value *= 1.07) {
        const LegendScale scale = legendScale(value);
        EXPECT_GE(scale.top, value * (1 - 1e-8));
        EXPECT_LT(scale.top - scale.tick, value);
        EXPECT_LE(scale.top / scale.tick, 8 + 1e-6) << value;
    }
}

TEST(LegendScale, NothingGivesOneToOne) {
    for (const double value :
         {0.0, -5.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        EXPECT_EQ(legendScale(value).top, 1);
        EXPECT_EQ(legendScale(value).tick, 1);
    }
}

}  // namespace
}  // namespace noonmark
