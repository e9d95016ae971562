#include "core/samples/central_park_towers.h"

#include <algorithm>

#include "core/samples/central_park_streets.h"

namespace noonmark {

namespace {

constexpr const char* built = "built";
constexpr const char* toBeBuilt = "to be built";

/// Size across and along the avenues, metres.
struct Floor {
    double width, depth;
};

// As near to `middle` as the block allows.
StreetBox floorOn(const StreetBox& block, glm::dvec2 middle, Floor floor) {
    const double x = std::clamp(middle.x, block.west + floor.width / 2, block.east - floor.width / 2);
    const double y = std::clamp(middle.y, block.south + floor.depth / 2, block.north - floor.depth / 2);
    return {x - floor.width / 2, y - floor.depth / 2, x + floor.width / 2, y + floor.depth / 2};
}

NamedTower tower(const char* name, const char* status, LonLat place, double heightM, Floor floor,
                 const StreetBox& block) {
    const glm::dvec2 middle = StreetAxes{}.streetFromLocal(centralParkFrame().localFromLonLat(place));
    return {name, status, place, heightM, floorOn(block, middle, floor)};
}

}  // namespace

std::vector<NamedTower> caseStudyTowers() {
    return {
        tower("One57", built, {-73.9791, 40.7655}, 306.1, {24, 42}, blockAt(Avenue::seventh, 57)),
        tower("432 Park Avenue", built, {-73.9719, 40.7616}, 425.7, {28.5, 28.5},
              blockAt(Avenue::madison, 56)),
        tower("111 West 57th Street", toBeBuilt, {-73.9776, 40.7648}, 435.3, {18, 24},
              blockAt(Avenue::seventh, 57)),
        tower("Central Park Tower", toBeBuilt, {-73.9810, 40.7663}, 472.4, {30, 32},
              blockAt(Avenue::eighth, 57)),
        tower("220 Central Park South", toBeBuilt, {-73.9803, 40.7672}, 289.6, {26, 28},
              blockAt(Avenue::eighth, 58)),
        tower("53 West 53rd Street", toBeBuilt, {-73.9785, 40.7616}, 320.1, {26, 36},
              blockAt(Avenue::sixth, 53)),
        tower("520 Park Avenue", toBeBuilt, {-73.9705, 40.7646}, 237.7, {22, 20},
              blockAt(Avenue::madison, 60)),
    };
}

StreetBox timeWarnerPodium() { return {-1010, -88, -915, 47}; }

std::vector<NamedTower> timeWarnerTowers() {
    constexpr double heightM = 228.6;
    const LonLat place{-73.9830, 40.7685};
    return {
        {"South tower", built, place, heightM, {-975, -80, -945, -33}},
        {"North tower", built, place, heightM, {-975, -8, -945, 39}},
    };
}

}  // namespace noonmark
