#include "scenarios/project/rule_parcels.h"

#include <gmock/gmock.h>

#include "core/review/rule_library.h"
#include "tests/scenarios/small_town.h"

namespace noonmark::tests {
namespace {

using testing::HasSubstr;

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

TEST(RuleParcels, TheirLineMovesOutAlongTheirRoads) {
    const Project project = twoLots();
    const auto parcels = findPlacesUnder(ruleNamed("japan"), project, {"A", "B", "Park"});
    ASSERT_TRUE(parcels);
    EXPECT_NEAR(area((*parcels)[0].polygons.front()), 20 * 34, 1e-3);
    EXPECT_THAT((*parcels)[0].source, HasSubstr("south=8"));
    EXPECT_EQ((*parcels)[1].polygons.front(), project.lots[1].outline);
    EXPECT_EQ((*parcels)[2], project.places[0]) << "places may be parcels, too";
    EXPECT_FALSE(findPlacesUnder(ruleNamed("japan"), project, {"C"}));
    EXPECT_FALSE(findPlacesUnder(ruleNamed("ceqr"), project, {"A"})) << "a lot is no place";
}

}  // namespace
}  // namespace noonmark::tests
