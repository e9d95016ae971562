#include "scenarios/project/rule_parcels.h"

#include <gtest/gtest.h>

#include "core/review/library/rule_library.h"
#include "tests/scenarios/small_town.h"

namespace noonmark::tests {
namespace {

Project twoLots() {
    Project project;
    project.lots = {{"A", box(0, 0, 20, 30), {{ParcelSide::south, 8}}}, {"B", box(50, 0, 70, 30)}};
    project.places = {{"Park", PlaceKind::park, {box(0, 50, 20, 60)}, "drawn"}};
    return project;
}

Rule ruleNamed(const std::string& key) { return RuleLibrary::load().value().find(key, {}).value(); }

TEST(RuleParcels, AreTheLotsOfARuleWithLinesOnly) {
    const Project project = twoLots();
    EXPECT_EQ(placesUnder(ruleNamed("ceqr"), project), project.places);
    const std::vector<Place> lots = placesUnder(ruleNamed("japan"), project);
    ASSERT_EQ(lots.size(), 2U);
    EXPECT_EQ(lots[0].name, "A");
    EXPECT_EQ(lots[0].polygons.front(), project.lots[0].outline) << "as drawn";
}

TEST(RuleParcels, AreFoundByName) {
    const Project project = twoLots();
    EXPECT_EQ(findPlacesUnder(ruleNamed("japan"), project, {"B"})->front().polygons.front(),
              project.lots[1].outline);
    EXPECT_EQ(findPlacesUnder(ruleNamed("japan"), project, {"Park"})->front(), project.places[0])
        << "places may be parcels, too";
    EXPECT_FALSE(findPlacesUnder(ruleNamed("japan"), project, {"C"}));
    EXPECT_FALSE(findPlacesUnder(ruleNamed("ceqr"), project, {"A"})) << "a lot is no place";
}

TEST(RuleParcels, TheirLineMovesOutAlongTheirRoads) {
    const Project project = twoLots();
    const Rule japan = ruleNamed("japan");
    const auto taken = moveLines(japan, project, placesUnder(japan, project)).value();
    EXPECT_NEAR(area(taken.places[0].polygons.front()), 20 * 34, 1e-3);
    EXPECT_EQ(taken.places[1].polygons.front(), project.lots[1].outline);
    ASSERT_EQ(taken.moved.size(), 1U);
    EXPECT_EQ(taken.moved[0].where, "A: south=8");
    const auto park = moveLines(ruleNamed("ceqr"), project, project.places).value();
    EXPECT_EQ(park.places, project.places);
    EXPECT_TRUE(park.moved.empty());
}

TEST(RuleParcels, ALineThatNoRoadMovesIsReportedToStay) {
    Project project = twoLots();
    // A triangle that points south: its edges face 117, 0 and 243 degrees.
    project.lots[0].outline.outer = {{0, 0}, {10, 20}, {-10, 20}};
    const Rule japan = ruleNamed("japan");
    const auto taken = moveLines(japan, project, placesUnder(japan, project)).value();
    EXPECT_EQ(taken.places[0].polygons.front(), project.lots[0].outline);
    ASSERT_EQ(taken.moved.size(), 1U);
    EXPECT_NE(taken.moved[0].what.find("is not moved"), std::string::npos);
}

}  // namespace
}  // namespace noonmark::tests
