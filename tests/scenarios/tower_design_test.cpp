#include "scenarios/massing/tower_design.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scenarios/edits/apply_edits.h"
#include "scenarios/massing/floor_plate.h"
#include "scenarios/project/edit_json.h"
#include "tests/scenarios/small_town.h"

namespace noonmark::tests {
namespace {

using testing::HasSubstr;

TowerDesign everything() {
    TowerDesign design{"Lot 7", box(0, 0, 60, 40), {.storeyHeightM = 3.25, .storeys = 30}};
    design.lot.holes.push_back({{20, 10}, {20, 20}, {30, 20}, {30, 10}});
    design.settings.plate.areaM2 = 600;
    design.settings.podium = Podium{4, {.shareOfLot = 0.8}, {.taper = 0.05}};
    design.settings.setbacks = {{60, 2.5, {.taper = 0.1, .twistDeg = -15}}, {80, 1, {}}};
    design.settings.clockwiseDeg = 12;
    design.settings.walls = {.taper = 0.125, .twistDeg = 40};
    design.settings.uses = {{"retail", 2}, {"offices", 10}, {"homes", 0}};
    design.settings.further = {{12, {.areaM2 = 300}}, {8, {}}};
    design.settings.gapM = 9;
    return design;
}

DesignOfShape readBack(const TowerDesign& design) {
    const Edit edit =
        AddBuilding{shared(house("t", box(0, 0, 10, 10), 30)), std::make_shared<const TowerDesign>(design)};
    return std::get<AddBuilding>(parseEdit("add", toJson(edit)).value()).design;
}

TEST(TowerDesign, IsSavedWithItsEdit) {
    EXPECT_EQ(*readBack(everything()), everything());
    TowerDesign plain{"", box(0, 0, 9, 9), {.heightM = 41.5}};
    EXPECT_EQ(*readBack(plain), plain);
}

TEST(TowerDesign, AnEditOfAnOlderFileHasNone) {
    const Edit edit = Replace{"a", shared(house("t", box(0, 0, 10, 10), 30))};
    const std::string text = toJson(edit);
    EXPECT_EQ(text.find("design"), text.npos);
    EXPECT_FALSE(std::get<Replace>(parseEdit("replace", text).value()).design);
}

TEST(TowerDesign, HostileDesignsAreRefused) {
    const Edit edit = AddBuilding{shared(house("t", box(0, 0, 10, 10), 30)),
                                  std::make_shared<const TowerDesign>(everything())};
    const std::string text = toJson(edit);
    for (const auto& [old, with] : {std::pair("\"storeys\":30", "\"storeys\":1e9"),
                                    {"\"storeys\":30", "\"storeys\":-1"},
                                    {"\"storey_height_m\":3.25", "\"storey_height_m\":0"},
                                    {"\"taper\":0.125", "\"taper\":7"},
                                    {"\"twist_clockwise_deg\":40", "\"twist_clockwise_deg\":\"far\""},
                                    {"\"area_m2\":600", "\"area_m2\":-600"},
                                    {"\"use\":\"retail\"", "\"use\":3"}}) {
        std::string hostile = text;
        const auto at = hostile.find(old);
        ASSERT_NE(at, hostile.npos) << old;
        hostile.replace(at, std::string(old).size(), with);
        EXPECT_FALSE(parseEdit("add", hostile)) << with;
    }
}

TEST(ProposedTowers, AreFoundThroughTheEdits) {
    const auto design = std::make_shared<const TowerDesign>(everything());
    const auto shape = [](const char* id) { return shared(house(id, box(0, 0, 10, 10), 30)); };
    ImportMesh mesh{shape("mesh"), {}, "mesh.obj", 3.0};
    const std::vector<Edit> edits{AddBuilding{shape("a"), design},
                                  AddBuilding{shape("b"), design},
                                  AddBuilding{shape("c"), design},
                                  AddBuilding{shape("plain")},
                                  Replace{"old", shape("d"), design},
                                  mesh,
                                  Move{"b", {3, 0}},
                                  Demolish{"c"},
                                  Move{"plain", {1, 1}}};
    const auto towers = findProposedTowers(edits);
    ASSERT_EQ(towers.size(), 5U);
    EXPECT_FALSE(towers.at("plain").design);
    EXPECT_EQ(towers.at("plain").storeyHeightM, 0);
    EXPECT_EQ(towers.at("a").design, design);
    EXPECT_FALSE(towers.at("a").changed);
    EXPECT_TRUE(towers.at("b").changed);
    EXPECT_EQ(towers.at("d").storeyHeightM, 3.25);
    EXPECT_FALSE(towers.at("mesh").design);
    EXPECT_EQ(towers.at("mesh").storeyHeightM, 3.0);
    const std::vector<Edit> replaced{AddBuilding{shape("a"), design}, Replace{"a", shape("a")}};
    EXPECT_FALSE(findProposedTowers(replaced).at("a").design);
}

TEST(ScenarioUses, AreSummedOverTheTowersThatAreKnown) {
    const auto make = [](int storeys, std::vector<FloorUse> uses) {
        return std::make_shared<const TowerDesign>(
            TowerDesign{"", box(0, 0, 20, 10), {.storeys = storeys, .uses = std::move(uses)}});
    };
    const auto shape = [](const char* id) { return shared(house(id, box(0, 0, 20, 10), 30)); };
    const std::vector<Edit> edits{AddBuilding{shape("a"), make(6, {{"retail", 2}, {"homes", 0}})},
                                  AddBuilding{shape("b"), make(5, {{"homes", 5}})},
                                  AddBuilding{shape("c"), make(3, {})},
                                  AddBuilding{shape("d"), make(9, {{"homes", 0}})},
                                  Move{"b", {50, 0}},
                                  ChangeHeight{"d", 12},
                                  ImportMesh{shape("m"), {}, "m.obj"}};
    const ScenarioUses uses = sumUses(edits);
    ASSERT_EQ(uses.areas.size(), 3U);
    EXPECT_EQ(uses.areas[0], (UseArea{"homes", 12, 2400}));  // 4 of a, 5 of b, 3 of d
    EXPECT_EQ(uses.areas[1], (UseArea{"retail", 2, 400}));
    EXPECT_EQ(uses.areas[2], (UseArea{"", 3, 600}));
    EXPECT_EQ(uses.towersNotCounted, 1) << "a mesh";
    EXPECT_EQ(sumFloorAreaM2(uses), 2400 + 400 + 600);
    EXPECT_EQ(sumFloorAreaM2({}), std::nullopt);
}

TEST(TowerFigures, FollowAChangeOfHeightAsFarAsTheDesignTellsTheFloors) {
    const auto made = [](MassingSettings settings) {
        return std::make_shared<const TowerDesign>(TowerDesign{"", box(0, 0, 20, 10), std::move(settings)});
    };
    ProposedTower tower{.design = made({.storeyHeightM = 4, .storeys = 10, .setbacks = {{20, 1}}})};
    EXPECT_EQ(figuresOf(tower)->storeys, 10);
    tower.heightM = 30;  // five storeys of 200 m2, and floors at 20 and 24 m of 18 x 8 m
    EXPECT_EQ(figuresOf(tower)->storeys, 7);
    EXPECT_NEAR(figuresOf(tower)->grossFloorM2, 5 * 200 + 2 * 144, 0.1);
    tower.heightM = 15;
    EXPECT_FALSE(figuresOf(tower)) << "the setback is cut off";
    tower.design = made({.storeys = 10, .walls = {.taper = 0.2}});
    EXPECT_FALSE(figuresOf(tower)) << "its walls were stretched";
    EXPECT_FALSE(figuresOf({})) << "a mesh";
}

TEST(ProposedHeight, IsThatOfTheHighestAddedBuildingAboveItsGround) {
    City city;
    city.buildings = {shared(house("old", box(0, 0, 10, 10), 90))};
    const auto heightAfter = [&](const std::vector<Edit>& edits) {
        return findProposedHeightM(applyEdits(city, edits).value().city, edits);
    };
    Building onHill = house("hill", box(40, 0, 50, 10), 65);
    onHill.parts[0].bottomM = 15;
    const std::vector<Edit> two{AddBuilding{shared(house("low", box(20, 0, 30, 10), 40))},
                                AddBuilding{shared(onHill)}};
    EXPECT_EQ(heightAfter({}), std::nullopt);
    EXPECT_EQ(heightAfter({ChangeHeight{"old", 120}}), std::nullopt) << "it was there before";
    EXPECT_EQ(heightAfter({two[0]}), 40);
    EXPECT_EQ(heightAfter(two), 50) << "65 m on ground of 15 m";
    EXPECT_EQ(heightAfter({two[0], two[1], ChangeHeight{"low", 55}}), 55);
    EXPECT_EQ(heightAfter({two[0], Demolish{"low"}}), std::nullopt);
}

TEST(FloorUses, StoreysAreGivenFromTheGroundUp) {
    MassingSettings settings{.storeyHeightM = 4, .storeys = 20, .plate = {.areaM2 = 500}};
    settings.podium = Podium{.storeys = 2, .plate = {.areaM2 = 1000}};
    settings.uses = {{"retail", 2}, {"offices", 10}, {"homes", 0}};
    const Massing massing = makeMassing(box(0, 0, 60, 40), settings).value();
    ASSERT_EQ(massing.figures.uses.size(), 3U);
    const auto is = [&](std::size_t i, const char* use, int storeys, double areaM2) {
        EXPECT_EQ(massing.figures.uses[i].use, use);
        EXPECT_EQ(massing.figures.uses[i].storeys, storeys);
        EXPECT_NEAR(massing.figures.uses[i].grossFloorM2, areaM2, 2);
    };
    is(0, "retail", 2, 2000);
    is(1, "offices", 10, 5000);
    is(2, "homes", 8, 4000);
}

TEST(FloorUses, WhatIsLeftOverAndWhatDoesNotFitAreStated) {
    const std::vector<double> storeys(5, 100.0);
    EXPECT_EQ(sumByUse({{"retail", 2}}, storeys), (std::vector<UseArea>{{"retail", 2, 200}, {"", 3, 300}}));
    EXPECT_EQ(sumByUse({{"retail", 4}, {"offices", 9}, {"homes", 0}}, storeys),
              (std::vector<UseArea>{{"retail", 4, 400}, {"offices", 1, 100}, {"homes", 0, 0}}));
    EXPECT_TRUE(sumByUse({}, storeys).empty());
    EXPECT_THAT(checkUses({{"", 2}}).error().text(), HasSubstr("no name"));
    EXPECT_THAT(checkUses({{"homes", 0}, {"roof", 1}}).error().text(), HasSubstr("other uses follow"));
    EXPECT_THAT(checkUses({{"homes", 501}}).error().text(), HasSubstr("0 to 500"));
}

}  // namespace
}  // namespace noonmark::tests
