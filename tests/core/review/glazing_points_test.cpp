#include "core/review/glazing/glazing_review.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace noonmark {

namespace {

// A wall that faces south; `along` of its pane points to the east.
const SkyPoint middle{{10, 0, 5}, {0, -1, 0}};

RuleGlazing glazingAt(GlazingPoint point) {
    RuleGlazing rule;
    rule.point = point;  // opening: sill 0.9 m above the floor, 1.5 x 1.5 m, wall 0.3 m
    return rule;
}

// From a plan angle beside the pane's normal, to the east, and an altitude.
glm::dvec3 sunAt(double besideDeg, double altitudeDeg) {
    const double beside = besideDeg * std::numbers::pi / 180, up = altitudeDeg * std::numbers::pi / 180;
    return {std::cos(up) * std::sin(beside), -std::cos(up) * std::cos(beside), std::sin(up)};
}

bool admits(const RuleGlazing& rule, glm::dvec3 sun, std::size_t point = 0) {
    return PaneLimits(rule, placePanePoints(rule, middle, {})[point], {}).admits(sun);
}

TEST(PanePoints, LieWhereTheRuleSays) {
    const auto at = [](GlazingPoint point, PaneSize pane = {}) {
        std::vector<glm::vec3> places;
        for (const PanePoint& p : placePanePoints(glazingAt(point), middle, pane))
            places.push_back(p.point.position);
        return places;
    };
    using testing::ElementsAre;
    EXPECT_THAT(at({PanePlace::middle}), ElementsAre(glm::vec3(10, 0, 5)));
    EXPECT_THAT(at({PanePlace::sillMiddle}), ElementsAre(glm::vec3(10, 0, 4.25F)));
    EXPECT_THAT(at({PanePlace::sillEnds}),
                ElementsAre(glm::vec3(9.25F, 0, 4.25F), glm::vec3(10.75F, 0, 4.25F)));
    // 1.2 m above the floor are 0.3 m above the sill; 0.5 m above the sill are more.
    EXPECT_NEAR(at({PanePlace::sillMiddle, true, 0.3, 1.2})[0].z, 4.55, 1e-5);
    EXPECT_NEAR(at({PanePlace::sillMiddle, true, 0.5, 1.2})[0].z, 4.75, 1e-5);
    EXPECT_NEAR(at({PanePlace::sillMiddle, true, 9, 0})[0].z, 5.75, 1e-5) << "the top of the pane";
    // A pane of 4 x 1 m whose receiver is not in its middle.
    const PaneSize wide{{-1, -0.5}, {3, 0.5}};
    EXPECT_THAT(at({PanePlace::middle}, wide), ElementsAre(glm::vec3(11, 0, 5)));
    EXPECT_THAT(at({PanePlace::sillEnds}, wide), ElementsAre(glm::vec3(9, 0, 4.5F), glm::vec3(13, 0, 4.5F)));
}

TEST(PaneLimits, AnglesWithThePane) {
    RuleGlazing rule = glazingAt({});
    EXPECT_TRUE(admits(rule, sunAt(89.9, 5)));
    EXPECT_FALSE(admits(rule, sunAt(90.1, 5)));
    rule.minSweepDeg = 15;
    for (const double altitude : {1.0, 40.0, 80.0}) {
        EXPECT_TRUE(admits(rule, sunAt(74.9, altitude))) << altitude;
        EXPECT_TRUE(admits(rule, sunAt(-74.9, altitude))) << altitude;
        EXPECT_FALSE(admits(rule, sunAt(75.1, altitude))) << altitude;
    }
    rule.minSweepDeg = 0;
    rule.sweepOfOpening = true;  // arctan(0.3 / 1.5) = 11.31 degrees
    EXPECT_TRUE(admits(rule, sunAt(78.6, 30)));
    EXPECT_FALSE(admits(rule, sunAt(78.8, 30)));
}

TEST(PaneLimits, TheOpeningOfAThickWall) {
    // From the middle of the inside face, 0.3 m behind: 0.75 m to each edge, arctan(2.5) = 68.2 degrees.
    const RuleGlazing rule = glazingAt({PanePlace::middle, true});
    EXPECT_TRUE(admits(rule, sunAt(68, 0.1)));
    EXPECT_FALSE(admits(rule, sunAt(68.4, 0.1)));
    EXPECT_TRUE(admits(rule, sunAt(0, 68)));
    EXPECT_FALSE(admits(rule, sunAt(0, 68.4)));
    // At the western end of the sill the sun from the west is hidden; from the east 1.5 m are open: 78.7 deg.
    const RuleGlazing ends = glazingAt({PanePlace::sillEnds, true});
    EXPECT_FALSE(admits(ends, sunAt(-1, 10), 0));
    EXPECT_TRUE(admits(ends, sunAt(78, 0.1), 0));
    EXPECT_FALSE(admits(ends, sunAt(79, 0.1), 0));
    EXPECT_TRUE(admits(ends, sunAt(-78, 0.1), 1));
    EXPECT_FALSE(admits(ends, sunAt(1, 10), 1));
}

TEST(PaneLimits, ARoofLightHasNoSweep) {
    RuleGlazing rule = glazingAt({});
    rule.minSweepDeg = 15;
    const SkyPoint light{{0, 0, 9}, {0, 0, 1}};
    const PaneLimits limits(rule, placePanePoints(rule, light, {})[0], {});
    EXPECT_TRUE(limits.admits(sunAt(90, 5)));
    EXPECT_FALSE(limits.admits(sunAt(90, -5)));
}

}  // namespace

}  // namespace noonmark
