#include "core/engines/horizon/overhangs/overhang_layers.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace noonmark {
namespace {

std::vector<glm::dvec2> starAround(glm::dvec2 middle, int corners, double minimum, double maximum,
                                   std::mt19937& random) {
    std::uniform_real_distribution<double> reach(minimum, maximum);
    std::vector<glm::dvec2> ring;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        ring.push_back(middle + reach(random) * glm::dvec2(std::cos(angle), std::sin(angle)));
    }
    return ring;
}

double computeArea(const std::vector<glm::dvec2>& ring) {
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const glm::dvec2 a = ring[i], b = ring[(i + 1) % ring.size()];
        twice += a.x * b.y - a.y * b.x;
    }
    return std::abs(twice) / 2;
}

// Areas in `along` and q equal areas in cells.
double computeArea(const OverhangLayers& layers) {
    double area = 0;
    for (const OverhangLayer& layer : layers.all())
        for (const OverhangStrip& strip : layers.of(layer)) {
            const double width = strip.highQ - strip.lowQ;
            const double first = strip.near.along - strip.far.along,
                         last = first + (strip.near.slope - strip.far.slope) * width;
            EXPECT_GT(width, 0);
            EXPECT_GE(std::min(first, last), -1e-9) << "the near side is the near one";
            area += width * (first + last) / 2;
        }
    return area;
}

void expectDisjoint(const OverhangLayers& layers) {
    for (const OverhangLayer& layer : layers.all())
        for (std::size_t i = 1; i < layers.of(layer).size(); ++i)
            EXPECT_GE(layers.of(layer)[i].lowQ, layers.of(layer)[i - 1].highQ);
}

ShadowAxes axesAt(double deg) {
    const double angle = deg * std::numbers::pi / 180;
    return ShadowAxes({std::sin(angle), std::cos(angle)});
}

TEST(OverhangLayers, StripsCoverAnOutlineWithAHoleOnceWhateverTheAzimuth) {
    std::mt19937 random(7);
    OverhangLayers layers;
    for (int turn = 0; turn < 200; ++turn) {
        OverhangShapes shapes;
        const glm::dvec2 middle(40.25, -17.5);
        const auto outer = starAround(middle, 17, 6, 20, random), hole = starAround(middle, 5, 1, 5, random);
        shapes.prisms.push_back({{outer, hole}, 5, 9});
        const OverhangShapes* const list[]{&shapes};
        layers.set(list, axesAt(turn * 360.0 / 200), 1);
        EXPECT_NEAR(computeArea(layers), computeArea(outer) - computeArea(hole), 1e-9);
        expectDisjoint(layers);
    }
}

TEST(OverhangLayers, ATriangleIsOneLayerOfTwoStripsThatRiseAlike) {
    OverhangShapes shapes;
    shapes.triangles.push_back({glm::dvec3{0, 0, 4}, glm::dvec3{10, 2, 8}, glm::dvec3{4, 9, 6}});
    const OverhangShapes* const list[]{&shapes};
    OverhangLayers layers;
    layers.set(list, axesAt(0), 1);
    ASSERT_EQ(layers.all().size(), 1U);
    EXPECT_FALSE(layers.all()[0].solid);
    EXPECT_EQ(layers.all()[0].highestRise, 8);
    const auto strips = layers.of(layers.all()[0]);
    ASSERT_EQ(strips.size(), 2U);
    EXPECT_NEAR(computeArea(layers), 41, 1e-12);
    // At the middle corner both strips have the same values for the side that passes it.
    const double width = strips[0].highQ - strips[0].lowQ;
    EXPECT_NEAR(strips[0].far.rise + strips[0].far.riseSlope * width, strips[1].far.rise, 1e-12);
    EXPECT_NEAR(strips[1].near.rise, 6, 1e-12);
}

TEST(OverhangLayers, WhatEndsBelowTheDatumHidesNothing) {
    OverhangShapes shapes;
    shapes.prisms.push_back({{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}, -5, -1});
    const OverhangShapes* const list[]{&shapes};
    OverhangLayers layers;
    layers.set(list, axesAt(30), 1);
    EXPECT_TRUE(layers.all().empty());
}

}  // namespace
}  // namespace noonmark
