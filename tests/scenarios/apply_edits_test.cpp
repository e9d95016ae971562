#include "scenarios/edits/apply_edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/city/meshes/mesh_topology.h"
#include "core/city/trees/tree_facts.h"
#include "tests/scenarios/small_town.h"

namespace noonmark::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

EditedCity edited(const City& city, const std::vector<Edit>& edits) {
    return applyEdits(city, edits).value();
}

std::string errorOf(const City& city, const std::vector<Edit>& edits) {
    const auto made = applyEdits(city, edits);
    return made ? "" : made.error().text();
}

NewShape tower(const std::string& id, float topM = 50) {
    return shared(house(id, box(100, 0, 120, 20), topM));
}

TEST(ApplyEdits, NothingToDoSharesEverything) {
    const City city = threeHouses();
    const EditedCity same = edited(city, {});
    EXPECT_EQ(same.city.buildings, city.buildings);
    EXPECT_TRUE(same.changes.none());
    EXPECT_TRUE(computeVolume(same.changes).box.empty());
}

TEST(ApplyEdits, DemolitionTakesOneAndSharesTheOthers) {
    const City city = threeHouses();
    const EditedCity less = edited(city, {Demolish{"b"}});
    EXPECT_THAT(less.city.buildings, ElementsAre(city.buildings[0], city.buildings[2]));
    EXPECT_THAT(less.changes.removed, ElementsAre(city.buildings[1]));
    EXPECT_THAT(less.changes.added, IsEmpty());
    EXPECT_EQ(computeVolume(less.changes).box, bounds(*city.buildings[1]));
    EXPECT_EQ(computeVolume(less.changes).topM, 20);
}

TEST(ApplyEdits, ReplacementStandsInTheSamePlaceOfTheList) {
    const City city = threeHouses();
    const EditedCity changed = edited(city, {Replace{"b", tower("new")}});
    EXPECT_EQ(changed.city.buildings[1]->sourceId, "new");
    EXPECT_EQ(changed.city.buildings[2], city.buildings[2]);
    EXPECT_THAT(changed.changes.added, ElementsAre(changed.city.buildings[1]));
    EXPECT_EQ(computeVolume(changed.changes).topM, 50);
}

TEST(ApplyEdits, ReplacementMayKeepTheId) {
    EXPECT_EQ(edited(threeHouses(), {Replace{"b", tower("b", 77)}}).city.buildings[1]->parts[0].topM, 77);
}

TEST(ApplyEdits, WhatCameAndWentIsNoChange) {
    const City city = threeHouses();
    const EditedCity same =
        edited(city, {AddBuilding{tower("new")}, ChangeHeight{"new", 80}, Demolish{"new"}});
    EXPECT_EQ(same.city.buildings, city.buildings);
    EXPECT_TRUE(same.changes.none());
}

TEST(ApplyEdits, ABuildingChangedTwiceIsOneChange) {
    const City city = threeHouses();
    const EditedCity changed = edited(city, {ChangeHeight{"c", 40}, Move{"c", {5, 0}}});
    EXPECT_THAT(changed.changes.removed, ElementsAre(city.buildings[2]));
    ASSERT_EQ(changed.changes.added.size(), 1U);
    EXPECT_EQ(changed.changes.added[0]->parts[0].topM, 40);
    EXPECT_EQ(bounds(*changed.changes.added[0]).low.x, 65);
}

TEST(ApplyEdits, LoweringCutsAndRaisingLiftsTheTopOnly) {
    City city = threeHouses();
    Building tiers = house("tiers", box(0, 50, 20, 70), 10);
    tiers.parts.push_back(house("upper", box(5, 55, 15, 65), 40, 10).parts[0]);
    city.buildings.push_back(shared(tiers));
    const EditedCity higher = edited(city, {ChangeHeight{"tiers", 60}});
    EXPECT_EQ(higher.city.buildings[3]->parts[0].topM, 10);
    EXPECT_EQ(higher.city.buildings[3]->parts[1].topM, 60);
    EXPECT_EQ(higher.city.buildings[3]->parts[0].heightSource, HeightSource::assumed);
    EXPECT_EQ(higher.city.buildings[3]->parts[1].heightSource, HeightSource::designed);
    const EditedCity lower = edited(city, {ChangeHeight{"tiers", 8}});
    ASSERT_EQ(lower.city.buildings[3]->parts.size(), 1U);
    EXPECT_EQ(lower.city.buildings[3]->parts[0].topM, 8);
}

TEST(ApplyEdits, AMeshIsStretchedToItsHeight) {
    City city;
    Building solid = house("solid", box(0, 0, 10, 10), 10);
    solid.parts[0].mesh = std::make_shared<const TriangleMesh>(meshOf(solid.parts[0]));
    city.buildings = {shared(solid)};
    const auto tall = edited(city, {ChangeHeight{"solid", 25}}).city.buildings[0];
    EXPECT_EQ(computeBox(*tall->parts[0].mesh).high.z, 25);
    EXPECT_EQ(topM(*tall), 25);
    EXPECT_EQ(tall->parts[0].heightSource, HeightSource::designed);
}

TEST(ApplyEdits, RotationKeepsTheMiddleAndTheArea) {
    City city = threeHouses();
    city.buildings[0] = shared(house("a", box(0, 0, 30, 10), 10));
    const auto turned = edited(city, {Rotate{"a", 90}}).city.buildings[0];
    const Box2 box = bounds(*turned);
    EXPECT_NEAR(box.low.x, 10, 1e-4);
    EXPECT_NEAR(box.low.y, -10, 1e-4);
    EXPECT_NEAR(area(turned->parts[0].footprint), 300, 1e-3);
}

TEST(ApplyEdits, ClockwiseIsSeenFromAbove) {
    City city = threeHouses();
    Building corner = house("a", {{{0, 0}, {10, 0}, {0, 4}}, {}}, 10);
    const Building turned = placeBuilding(corner, {.clockwiseDeg = 90});
    // East becomes south.
    EXPECT_NEAR(bounds(turned).low.y, -10, 1e-4);
    EXPECT_NEAR(bounds(turned).high.x, 4, 1e-4);
}

TEST(ApplyEdits, ImportIsScaledTurnedAndMoved) {
    const Edit import = ImportMesh{shared(house("mesh", box(-1, -1, 1, 1), 3)),
                                   {.scale = 10, .clockwiseDeg = 45, .byM = {200, 100}},
                                   "mesh.obj"};
    const auto building = edited(threeHouses(), {import}).city.buildings[3];
    EXPECT_EQ(topM(*building), 30);
    EXPECT_NEAR(area(building->parts[0].footprint), 400, 1e-2);
    EXPECT_NEAR(findMiddle(*building).x, 200, 1e-3);
    EXPECT_NEAR(bounds(*building).high.y, 100 + 10 * std::sqrt(2.0), 1e-3);
}

TEST(ApplyEdits, NewAndMovedBuildingsStandOnTheTerrain) {
    City city = threeHouses();
    city.terrain = slope();
    const EditedCity changed = edited(city, {AddBuilding{tower("new")}, Move{"a", {50, 0}}});
    EXPECT_NEAR(changed.city.buildings[3]->parts[0].bottomM, 10, 0.01);  // x = 100: the ground is at 10 m
    EXPECT_NEAR(changed.city.buildings[3]->parts[0].topM, 60, 0.01);
    EXPECT_NEAR(changed.city.buildings[0]->parts[0].topM, 15, 0.01);  // raised by 5 m
}

TEST(ApplyEdits, ErrorsNameTheEditAndWhatIsWrong) {
    const City city = threeHouses();
    EXPECT_THAT(errorOf(city, {Demolish{"a"}, ChangeHeight{"a", 5}}),
                testing::AllOf(HasSubstr("edit 2"), HasSubstr("There is no such building"), HasSubstr("a")));
    EXPECT_THAT(errorOf(city, {AddBuilding{tower("a")}}), HasSubstr("Another building has this id"));
    EXPECT_THAT(errorOf(city, {Replace{"a", tower("b")}}), HasSubstr("Another building has this id"));
    EXPECT_THAT(errorOf(city, {ChangeHeight{"a", 0}}), HasSubstr("0.1 to 2000 m"));
    EXPECT_THAT(errorOf(city, {ChangeHeight{"a", std::nan("")}}), HasSubstr("0.1 to 2000 m"));
    EXPECT_THAT(errorOf(city, {Move{"a", {std::nan(""), 0}}}), HasSubstr("cannot be moved"));
    EXPECT_THAT(errorOf(city, {ImportMesh{tower("m"), {.scale = 0}, "m.obj"}}), HasSubstr("0.001 to 1000"));
    EXPECT_THAT(errorOf(city, {ImportMesh{tower("m"), {.scale = 900}, "m.obj"}}),
                HasSubstr("at most 2000 m"));
}

TEST(BuildingIds, EveryBuildingGetsItsOwn) {
    City city = threeHouses();
    city.buildings.push_back(shared(house("a", box(0, 50, 10, 60), 10)));
    city.buildings.push_back(shared(house("", box(20, 50, 30, 60), 10)));
    EXPECT_THAT(errorOf(city, {Demolish{"a"}}), HasSubstr("Two buildings have this id"));
    const City unique = makeIdsUnique(city);
    EXPECT_EQ(unique.buildings[0], city.buildings[0]);
    EXPECT_EQ(unique.buildings[3]->sourceId, "a (2)");
    EXPECT_EQ(unique.buildings[4]->sourceId, "building");
}

TEST(BuildingIds, AreFoundByNameToo) {
    City city = threeHouses();
    Building named = house("lot 7", box(0, 50, 10, 60), 10);
    named.name = "One57";
    city.buildings.push_back(shared(named));
    EXPECT_EQ(findBuilding(city, "One57").value(), 3U);
    EXPECT_EQ(findBuilding(city, "lot 7").value(), 3U);
    EXPECT_THAT(findBuilding(city, "One58").error().advice, HasSubstr("One57"));
}

// Warnings about several files name them so.
TEST(BuildingIds, AreFoundAfterTheirFile) {
    City city = threeHouses();
    EXPECT_EQ(findBuilding(city, "town.gpkg: a").value(), findBuilding(city, "a").value());
    city.buildings.push_back(shared(house("a", box(0, 50, 10, 60), 10)));
    EXPECT_THAT(findBuilding(makeIdsUnique(city), "town.gpkg: a").error().advice, HasSubstr("a, a (2)"));
}

// Two trees on the slope, whose ground rises by 1 m every 10 m to the east.
City withTwoTrees() {
    City city = threeHouses();
    city.terrain = slope();
    Trees trees{.trees = {completeTree({.sourceId = "lime", .species = "Tilia cordata", .heightM = 10.0}),
                          completeTree({.sourceId = "pine", .species = "Pinus nigra", .heightM = 12.0})},
                .leafDays = {100, 300}};
    trees.trees[0].place = {20, 20};
    trees.trees[1].place = {50, 20};
    city.trees = std::make_shared<const Trees>(std::move(trees));
    return city;
}

TEST(ApplyEdits, TreesArePlantedFelledMovedReplacedAndGrown) {
    const City before = withTwoTrees();
    Tree planted = completeTree({.sourceId = "new", .heightM = 6.0});
    planted.place = {100, 0};
    const std::vector<Edit> edits{
        PlantTree{planted}, FellTree{"lime"}, MoveTree{"pine", {30, 0}}, GrowTree{"pine", 10, 15, 3, 8},
        ReplaceTree{"new", completeTree({.sourceId = "other", .species = "Betula", .heightM = 8.0})}};
    const auto edited = applyEdits(before, edits);
    ASSERT_TRUE(edited) << edited.error().text();
    EXPECT_TRUE(edited->changes.none()) << "no building changed";
    const std::vector<Tree>& trees = edited->city.trees->trees;
    ASSERT_EQ(trees.size(), 2U);
    EXPECT_EQ(trees[0].sourceId, "pine");
    EXPECT_EQ(trees[0].place, glm::dvec2(80, 20));
    EXPECT_FLOAT_EQ(trees[0].groundM, groundAt(before, {80, 20}));
    EXPECT_FLOAT_EQ(trees[0].heightM, 15);
    EXPECT_FLOAT_EQ(trees[0].crownDiameterM, 8);
    EXPECT_EQ(trees[0].heightSource, TreeSource::estimated);
    EXPECT_EQ(trees[1].sourceId, "new");
    EXPECT_EQ(trees[1].species, "Betula");
    EXPECT_EQ(trees[1].place, glm::dvec2(100, 0));
    EXPECT_FLOAT_EQ(trees[1].groundM, groundAt(before, {100, 0}));
    EXPECT_EQ(edited->city.trees->leafDays, before.trees->leafDays);
    EXPECT_EQ(before.trees->trees.size(), 2U) << "the city before stays";
}

TEST(ApplyEdits, TheLastTreeFelledLeavesNone) {
    const auto bare = applyEdits(withTwoTrees(), std::vector<Edit>{FellTree{"lime"}, FellTree{"pine"}});
    ASSERT_TRUE(bare);
    EXPECT_FALSE(bare->city.trees);
}

TEST(ApplyEdits, EditsOfTreesThatCannotBeAreRefused) {
    const City city = withTwoTrees();
    const Tree good = completeTree({.sourceId = "lime", .heightM = 6.0});
    const auto error = [&](Edit edit) {
        const auto edited = applyEdits(city, std::vector<Edit>{std::move(edit)});
        return edited ? std::string() : edited.error().what;
    };
    EXPECT_THAT(error(PlantTree{good}), HasSubstr("has this id"));
    EXPECT_THAT(error(FellTree{"oak"}), HasSubstr("no such tree"));
    EXPECT_THAT(error(GrowTree{"lime", 300, 200, 3, 8}), HasSubstr("200 m high"));
    EXPECT_THAT(error(GrowTree{"lime", 3, 9, 9, 8}), HasSubstr("base"));
    EXPECT_THAT(error(MoveTree{"lime", {1e9, 0}}), HasSubstr("too far"));
}

TEST(ApplyEdits, TreesOfOneIdAreNumbered) {
    City city = withTwoTrees();
    Trees trees = *city.trees;
    for (Tree& tree : trees.trees) tree.sourceId = "canopy";
    trees.trees[0].place = {0.1, 0.2};
    city.trees = std::make_shared<const Trees>(std::move(trees));
    const City unique = makeIdsUnique(city);
    EXPECT_EQ(unique.trees->trees[0].sourceId, "canopy");
    EXPECT_EQ(unique.trees->trees[1].sourceId, "canopy (2)");
    EXPECT_EQ(unique.trees->trees[0].place, glm::dvec2(0.1F, 0.2F)) << "as a project file holds it";
    EXPECT_EQ(findTree(unique, "canopy (2)").value(), 1U);
    EXPECT_FALSE(findTree(threeHouses(), "canopy"));
}

}  // namespace
}  // namespace noonmark::tests
