#include "core/io/footprints/build_footprints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace noonmark {
namespace {

using testing::ElementsAre;

Part part(float west, float width, float bottom, float top, std::string id = "") {
    return {.sourceId = std::move(id),
            .footprint = {{{west, 0}, {west + width, 0}, {west + width, 10}, {west, 10}}, {}},
            .bottomM = bottom,
            .topM = top};
}

class SettleParts : public testing::Test {
protected:
    std::vector<bool> overhanging(float groundM = 0) {
        settleParts(parts, {.groundM = groundM}, warnings);
        std::vector<bool> isOverhanging;
        for (const Part& one : parts) isOverhanging.push_back(one.isOverhanging);
        return isOverhanging;
    }
    std::vector<Part> parts;
    Warnings warnings;
};

TEST_F(SettleParts, WhatStandsOnTheGroundStands) {
    parts = {part(0, 10, 0, 20)};
    EXPECT_THAT(overhanging(), ElementsAre(false));
    EXPECT_TRUE(warnings.empty());
}

TEST_F(SettleParts, TwoPartsSideBySideCarryOne) {
    parts = {part(0, 20, 12, 30), part(0, 10, 0, 12), part(10, 10, 0, 15)};
    EXPECT_THAT(overhanging(), ElementsAre(false, false, false));
    EXPECT_FLOAT_EQ(parts[0].bottomM, 12);
}

TEST_F(SettleParts, HalfASupportIsNone) {
    parts = {part(0, 20, 12, 30), part(0, 10, 0, 12)};
    EXPECT_THAT(overhanging(), ElementsAre(true, false));
}

TEST_F(SettleParts, AStackStandsWhateverItsOrder) {
    parts = {part(2, 6, 40, 60), part(0, 10, 0, 20), part(1, 8, 20, 40)};
    EXPECT_THAT(overhanging(), ElementsAre(false, false, false));
}

TEST_F(SettleParts, ALowGapIsClosedAndReported) {
    parts = {part(0, 10, 0, 17), part(0, 10, 20, 40, "way 9")};
    EXPECT_THAT(overhanging(), ElementsAre(false, false));
    EXPECT_FLOAT_EQ(parts[1].bottomM, 17);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(warnings[0].where, "way 9");
    EXPECT_EQ(warnings[0].kind, WarningKind::repaired);
}

TEST_F(SettleParts, APassageStaysOpenAndAPlinthDoesNot) {
    parts = {part(0, 10, 3, 20), part(50, 10, 1, 20)};
    EXPECT_THAT(overhanging(), ElementsAre(true, false));
    EXPECT_FLOAT_EQ(parts[0].bottomM, 3);
    EXPECT_FLOAT_EQ(parts[1].bottomM, 0);
}

TEST_F(SettleParts, HeightsCountFromTheGround) {
    parts = {part(0, 10, 101.5F, 120), part(50, 10, 110, 120)};
    EXPECT_THAT(overhanging(100), ElementsAre(false, true));
    EXPECT_FLOAT_EQ(parts[0].bottomM, 100);
}

TEST_F(SettleParts, WhatHangsAlreadyStaysAndCarriesNothing) {
    parts = {part(0, 10, 1, 5), part(0, 10, 5, 20)};
    parts[0].isOverhanging = true;
    EXPECT_THAT(overhanging(), ElementsAre(true, true));
    EXPECT_FLOAT_EQ(parts[0].bottomM, 1);
}

}  // namespace
}  // namespace noonmark
