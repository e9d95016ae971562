#include "core/study/elements/face_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/study/elements/element_fields.h"
#include "core/study/elements/element_study.h"
#include "core/study/elements/element_tables.h"
#include "tests/core/engines/scenes.h"

namespace noonmark {
namespace {

using namespace tests;
using testing::HasSubstr;

// A box of 12 x 12 x 9 m: four walls of 4 bays and 3 storeys, 12 points each.
City oneBox() {
    City city = cityOf({{{0, 0, 0}, {12, 12, 9}}});
    city.frame = Frame({-73.98, 40.75});
    Building building = *city.buildings[0];
    building.sourceId = "way 7";
    city.buildings[0] = std::make_shared<const Building>(building);
    return city;
}

Result<PlacedElements> place(const City& city, const ElementSettings& elements) {
    StudySettings settings;
    settings.region = makeRegionFromLocalBox({{-50, -50}, {60, 60}});
    NoProgress quiet;
    return placeElements(city, settings, elements, quiet, {});
}

ElementSettings takenOf(const FaceChoice& faces) {
    ElementSettings elements;
    elements.faces = faces;
    return elements;
}

ElementSettings lookingAt(const Footprint& park, double withinM) {
    ElementSettings elements = takenOf({.place = "Park", .withinM = withinM});
    elements.parts.facedPlace = {park};
    return elements;
}

const Footprint parkInTheSouth{{{0, -60}, {6, -60}, {6, -30}, {0, -30}}, {}};

TEST(AzimuthRanges, GoClockwiseAndAcrossNorth) {
    const AzimuthRange south{135, 225}, north{315, 45};
    EXPECT_TRUE(south.holds(135));
    EXPECT_TRUE(south.holds(180));
    EXPECT_TRUE(south.holds(225));
    EXPECT_FALSE(south.holds(134.9));
    EXPECT_FALSE(south.holds(0));
    EXPECT_TRUE(north.holds(0));
    EXPECT_TRUE(north.holds(359.9));
    EXPECT_TRUE(north.holds(45));
    EXPECT_FALSE(north.holds(46));
    EXPECT_FALSE(north.holds(180));
    EXPECT_TRUE((AzimuthRange{0, 360}.holds(77)));
    EXPECT_FALSE(south.holds(std::nan(""))) << "a level surface faces nowhere";
}

TEST(AzimuthRanges, AreReadAsTheyAreWritten) {
    for (const AzimuthRange& range : {AzimuthRange{135, 225}, {315, 45}, {0.5, 12.25}})
        EXPECT_EQ(parseAzimuthRange(formatText(range)).value(), range);
    for (const char* text : {"", "135", "135-", "-135", "a-b", "135-400", "-5-10", "1-2-3", "nan-5"})
        EXPECT_FALSE(parseAzimuthRange(text)) << text;
}

TEST(FaceChoices, TakeTheWallsOfADirection) {
    EXPECT_EQ(place(oneBox(), {})->receivers.size(), 48U);
    const auto south = place(oneBox(), takenOf({.facing = AzimuthRange{135, 225}})).value();
    ASSERT_EQ(south.receivers.size(), 12U);
    for (const glm::vec3 normal : south.receivers.points.normals) EXPECT_NEAR(normal.y, -1, 1e-6);
    EXPECT_EQ(place(oneBox(), takenOf({.facing = AzimuthRange{45, 225}}))->receivers.size(), 24U);
    const auto none = place(oneBox(), takenOf({.facing = AzimuthRange{20, 40}}));
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().text(), HasSubstr("facing 20-40 deg"));
}

// The park is 6 m wide and 30 m south of the box: only the two western bays of the southern wall look at it.
TEST(FaceChoices, TakeThePointsThatLookAtAPlace) {
    const auto looking = place(oneBox(), lookingAt(parkInTheSouth, 35)).value();
    ASSERT_EQ(looking.receivers.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_NEAR(looking.receivers.points.normals[i].y, -1, 1e-6);
        EXPECT_LT(looking.receivers.points.positions[i].x, 6);
    }
    EXPECT_FALSE(place(oneBox(), lookingAt(parkInTheSouth, 29))) << "the park is farther away";
    EXPECT_FALSE(place(oneBox(), lookingAt(parkInTheSouth, 0.5)));
    const auto unknown = place(oneBox(), takenOf({.place = "Nowhere"}));
    ASSERT_FALSE(unknown);
    EXPECT_THAT(unknown.error().text(), HasSubstr("no place 'Nowhere'"));
}

TEST(FaceChoices, LevelSurfacesLookAtNoPlace) {
    EXPECT_FALSE(looksAt({parkInTheSouth}, 100, {3, 0}, {0, 0, 1}));
    EXPECT_TRUE(looksAt({parkInTheSouth}, 100, {3, 0}, {0, -1, 0}));
    EXPECT_FALSE(looksAt({parkInTheSouth}, 100, {3, 0}, {0, 1, 0}));
    EXPECT_TRUE(looksAt({parkInTheSouth}, 1, {3, -40}, {1, 0, 0})) << "in the park";
}

TEST(FaceChoices, APickedWallIsTheFaceOfItsPoints) {
    const City city = oneBox();
    std::set<std::string> ids;
    for (const auto& [at, normal] : {std::pair{glm::dvec3(6, 0, 4), glm::dvec3(0, -1, 0)},
                                     {{12, 6, 4}, {1, 0, 0}},
                                     {{6, 12, 4}, {0, 1, 0}},
                                     {{0, 6, 4}, {-1, 0, 0}}}) {
        const auto face = findFaceAt(*city.buildings[0], at, normal);
        ASSERT_TRUE(face);
        ids.insert(*face);
        const auto placed = place(city, takenOf({.faces = {*face}})).value();
        ASSERT_EQ(placed.receivers.size(), 12U) << *face;
        for (const glm::vec3 facing : placed.receivers.points.normals)
            EXPECT_NEAR(glm::dot(glm::dvec3(facing), normal), 1, 1e-6);
    }
    EXPECT_EQ(ids.size(), 4U);
    EXPECT_FALSE(findFaceAt(*city.buildings[0], {6, 6, 9}, {0, 0, 1})) << "the roof";
    EXPECT_FALSE(findFaceAt(*city.buildings[0], {6, -5, 4}, {0, -1, 0})) << "5 m in front of it";
    EXPECT_FALSE(place(city, takenOf({.faces = {"way 7 wall 9"}})));
    EXPECT_FALSE(place(city, takenOf({.faces = {"way 8 wall 0"}})));
}

TEST(FaceChoices, AreRepeatedByTheOptionsThatChoseThem) {
    const auto options =
        listOptions(faceFields().of(FaceChoice{{"way 7 wall 0"}, AzimuthRange{135, 225}, "Park", 80}));
    ASSERT_EQ(options.size(), 4U);
    EXPECT_EQ(options[0].name, "--face");
    EXPECT_EQ(options[1].values, std::vector<std::string>{"135-225"});
    EXPECT_EQ(options[3].values, std::vector<std::string>{"80"});
    EXPECT_TRUE(listOptions(faceFields().of(FaceChoice{})).empty());
}

TEST(ElementPoints, ListedPointsAreOnTheGroundTheRoofOrAWall) {
    const City city = oneBox();
    const auto at = [&](double x, double y) { return city.frame.lonLatFromLocal({x, y}); };
    ElementSettings elements{.places = ElementPlaces::points};
    elements.points = {{"ground", at(-5, 5), {}, {}},
                       {"roof", at(6, 6), {}, {}},
                       {"wall", at(6, -0.02), 4.0, 180.0},
                       {"inside", at(6, 6), 4.0, {}}};
    const PlacedElements placed = place(city, elements).value();
    ASSERT_EQ(placed.receivers.size(), 3U);
    EXPECT_NEAR(placed.receivers.points.positions[0].z, 0, 1e-4);
    EXPECT_NEAR(placed.receivers.points.positions[1].z, 9, 1e-4);
    EXPECT_NEAR(placed.receivers.points.positions[2].z, 4, 1e-4);
    EXPECT_NEAR(placed.receivers.points.normals[2].y, -1, 1e-4);
    EXPECT_EQ(placed.receivers.elements[2].id, "wall");
    ASSERT_EQ(placed.warnings.size(), 1U);
    EXPECT_EQ(placed.warnings[0].where, "inside");
}

TEST(ElementPoints, LinesNeedAParcel) {
    const auto missing = place(oneBox(), {.places = ElementPlaces::lines});
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().text(), HasSubstr("parcel is missing"));
    ElementSettings elements{.places = ElementPlaces::lines, .planeHeightM = 4};
    elements.parcel = "Lot";
    elements.parts.parcel = {Footprint{{{0, 0}, {12, 0}, {12, 12}, {0, 12}}, {}}};
    const PlacedElements placed = place(oneBox(), elements).value();
    EXPECT_NEAR(placed.planeM, 4, 1e-6);
    for (const glm::vec3 position : placed.receivers.points.positions) EXPECT_NEAR(position.z, 4, 1e-5);
}

}  // namespace
}  // namespace noonmark
