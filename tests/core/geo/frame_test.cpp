#include "core/geo/frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace noonmark {
namespace {

constexpr double degreeOfLatitudeM = 111132;  // near 45 deg; accurate to 1 %

double metresBetween(LonLat a, LonLat b) {
    const double east =
        (a.lonDeg - b.lonDeg) * degreeOfLatitudeM * std::cos(Degrees{a.latDeg}.radians().value);
    return std::hypot(east, (a.latDeg - b.latDeg) * degreeOfLatitudeM);
}

TEST(Frame, OriginIsZero) {
    const Frame frame({-73.98, 40.75});
    EXPECT_LT(glm::length(frame.localFromLonLat({-73.98, 40.75})), 1e-9);
}

TEST(Frame, NorthIsPositiveYAndEastPositiveX) {
    const Frame frame({15.6, 78.2});
    EXPECT_NEAR(frame.localFromLonLat({15.6, 78.21}).y, 1116.5, 0.5);  // meridian arc at 78.2 N
    EXPECT_GT(frame.localFromLonLat({15.7, 78.2}).x, 2000);
}

TEST(Frame, RoundTripUnderOneMillimetreWithin50Km) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> offset(-50000, 50000);
    for (const LonLat origin : {LonLat{-73.98, 40.75}, LonLat{179.99, -16.8}, LonLat{15.6, 78.2},
                                LonLat{0, 0}, LonLat{30, -77.8}}) {
        const Frame frame(origin);
        for (int i = 0; i < 500; ++i) {
            const glm::dvec2 local{offset(random), offset(random)};
            const LonLat place = frame.lonLatFromLocal(local);
            EXPECT_LT(glm::length(frame.localFromLonLat(place) - local), 1e-3);
            EXPECT_LT(metresBetween(frame.lonLatFromLocal(frame.localFromLonLat(place)), place), 1e-3);
        }
    }
}

}  // namespace
}  // namespace noonmark
