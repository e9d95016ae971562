#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/receivers/place.h"
#include "core/receivers/place_names.h"

namespace noonmark {
namespace {

using std::chrono::day;
using testing::HasSubstr;

Place squarePlace(std::string name, float west, PlaceKind kind = PlaceKind::park) {
    return {std::move(name), kind, makeRegionFromLocalBox({{west, 0}, {west + 10, 10}}).polygons, "way 7"};
}

TEST(PlaceKinds, EveryKindHasANameThatLeadsBackToIt) {
    for (const PlaceKind kind : placeKinds) EXPECT_EQ(parsePlaceKind(nameOf(kind)), kind);
    EXPECT_FALSE(parsePlaceKind("lawn"));
}

TEST(PlaceKinds, TheGrowingSeasonTurnsRoundInTheSouthAndLastsAllYearInTheTropics) {
    const Season north = growingSeason(PlaceKind::park, 40.7), south = growingSeason(PlaceKind::park, -33.9),
                 tropics = growingSeason(PlaceKind::park, 1.3);
    EXPECT_TRUE(north.holds(std::chrono::April / day{1}));
    EXPECT_TRUE(north.holds(std::chrono::October / day{31}));
    EXPECT_FALSE(north.holds(std::chrono::November / day{1}));
    EXPECT_EQ(south.first, std::chrono::October / day{1});
    EXPECT_EQ(south.last, std::chrono::April / day{30});
    EXPECT_TRUE(south.holds(std::chrono::January / day{15}));
    EXPECT_FALSE(south.holds(std::chrono::May / day{1}));
    EXPECT_TRUE(tropics.holds(std::chrono::December / day{31}));
}

TEST(PlaceNames, AreCleanedOfControlCharactersAndBrokenBytes) {
    EXPECT_EQ(cleanName("  Bryant\tPark\n"), "Bryant Park");
    EXPECT_EQ(cleanName("Jardin Exotique \xC3\xA9"), "Jardin Exotique \xC3\xA9");
    EXPECT_EQ(cleanName("a\xFF"
                        "b\xC3"),
              "a?b?");
    EXPECT_EQ(cleanName("\xED\xA0\x80"), "???");  // half of a pair of UTF-16 is no character
    EXPECT_EQ(cleanName(std::string(500, 'x')).size(), 120U);
}

TEST(PlaceNames, BecomeUniqueAndTheUnnamedAreNamedByKindAndSource) {
    std::vector<Place> places{squarePlace("Garden", 0), squarePlace("Garden", 20),
                              squarePlace("Garden (2)", 40), squarePlace("", 60)};
    makeNamesUnique(places);
    EXPECT_EQ(places[0].name, "Garden");
    EXPECT_EQ(places[1].name, "Garden (3)");
    EXPECT_EQ(places[2].name, "Garden (2)");
    EXPECT_EQ(places[3].name, "park (way 7)");
}

TEST(PlaceNames, AreFoundInAnyCaseAndNearMissesAreSuggested) {
    const std::vector<Place> places{squarePlace("Bryant Park", 0), squarePlace("Madison Square Park", 20)};
    EXPECT_EQ(findPlace(places, "bryant park").value().name, "Bryant Park");
    EXPECT_THAT(findPlace(places, "Briant Park").error().text(), HasSubstr("Did you mean Bryant Park?"));
    EXPECT_THAT(findPlace(places, "madison").error().text(), HasSubstr("Madison Square Park"));
    EXPECT_THAT(findPlace(places, "Hyde").error().text(), HasSubstr("noonmark-cli places"));
}

TEST(PlaceNames, AreaAndBoundsAreThoseOfAllPolygons) {
    Place place = squarePlace("two", 0);
    place.polygons.push_back(squarePlace("", 30).polygons.front());
    EXPECT_DOUBLE_EQ(area(place), 200);
    EXPECT_EQ(bounds(place).high.x, 40);
}

}  // namespace
}  // namespace noonmark
