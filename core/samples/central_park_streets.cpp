#include "core/samples/central_park_streets.h"

#include <array>

namespace noonmark {

namespace {

struct Sides {
    double west, east;
};
// In the order of the enumeration. Blocks are 800 or 920 feet long, Madison and Lexington Avenues lie
// between; the park's corner is 14 m into Fifth Avenue.
constexpr std::array<Sides, 10> avenues{{
    {-1422.5, -1392},
    {-1148, -1117.5},
    {-873.5, -843},
    {-599, -568.5},
    {-324.5, -294},
    {-14, 16.5},
    {144.5, 168.5},
    {296, 339},
    {464, 487},
    {615, 645.5},
}};

constexpr double streetDistanceM = 80.47;  // twenty blocks to the mile
constexpr double middleOf59th = -17;

const Sides& sidesOf(Avenue avenue) { return avenues[std::size_t(avenue)]; }
double findMiddle(int street) { return middleOf59th + (street - 59) * streetDistanceM; }
double halfWidthOf(int street) { return street == 57 || street == 59 || street == 72 ? 15.2 : 9.1; }

const glm::dvec2 circleMiddle{-858, middleOf59th};

}  // namespace

Frame centralParkFrame() { return Frame({-73.97300, 40.76432}); }

double westSideOf(Avenue avenue) { return sidesOf(avenue).west; }
double eastSideOf(Avenue avenue) { return sidesOf(avenue).east; }
double southSideOf(int street) { return findMiddle(street) - halfWidthOf(street); }
double northSideOf(int street) { return findMiddle(street) + halfWidthOf(street); }

StreetBox blockAt(Avenue avenue, int street) {
    const Avenue next = Avenue(int(avenue) + 1);
    return {eastSideOf(avenue), northSideOf(street), westSideOf(next), southSideOf(street + 1)};
}

StreetBox parkBox() {
    return {eastSideOf(Avenue::eighth), northSideOf(59), westSideOf(Avenue::fifth), southSideOf(72)};
}

SkewedAvenue broadwaySouth() { return {.through = circleMiddle, .eastPerNorth = -0.243, .widthM = 28}; }
SkewedAvenue broadwayNorth() { return {.through = circleMiddle, .eastPerNorth = -0.525, .widthM = 36}; }

StreetBox columbusCircle() {
    constexpr double radiusM = 45;
    return {circleMiddle.x - radiusM, circleMiddle.y - radiusM, circleMiddle.x + radiusM,
            circleMiddle.y + radiusM};
}

}  // namespace noonmark
