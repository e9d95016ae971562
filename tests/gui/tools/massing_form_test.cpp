#include <gtest/gtest.h>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>

#include "app/gui/tools/editing/selection_panel.h"
#include "app/gui/tools/massing/massing_form.h"
#include "scenarios/edits/apply_edits.h"
#include "scenarios/massing/lot_edits.h"
#include "tests/gui/small_city.h"

namespace noonmark {

namespace {

// 152.5 m are 43 storeys of 3.5 m and 2 m more, which the last storey takes.
TEST(MassingForm, ATypedHeightIsKeptWhenNoNumberOfStoreysFitsIt) {
    MassingForm form;
    form.show({.storeyHeightM = 3.5, .storeys = 10});
    form.findChild<QDoubleSpinBox*>(QStringLiteral("totalHeight"))->setValue(152.5);
    EXPECT_EQ(form.settings().heightM, 152.5);
    EXPECT_EQ(form.settings().storeys, 0);
    EXPECT_EQ(form.findChild<QSpinBox*>(QStringLiteral("storeys"))->value(), 43);
    EXPECT_EQ(form.findChild<QDoubleSpinBox*>(QStringLiteral("totalHeight"))->value(), 152.5);
    form.findChild<QSpinBox*>(QStringLiteral("storeys"))->setValue(44);
    EXPECT_EQ(form.settings().storeys, 44);
    EXPECT_EQ(form.settings().heightM, 0);
}

TEST(MassingForm, TakesFurtherTowers) {
    MassingForm form;
    form.show({.storeyHeightM = 3.5, .storeys = 12});
    EXPECT_FALSE(form.findChild<QWidget*>(QStringLiteral("towerGap"))->isEnabled());
    form.findChild<QPushButton*>(QStringLiteral("addTower"))->click();
    ASSERT_EQ(form.settings().further.size(), 1U);
    EXPECT_EQ(form.settings().further[0].storeys, 12) << "as the first";
    auto* table = form.findChild<QTableWidget*>(QStringLiteral("furtherTowers"));
    static_cast<QSpinBox*>(table->cellWidget(0, 0))->setValue(7);
    EXPECT_EQ(form.settings().further[0].storeys, 7);
    auto* gap = form.findChild<QDoubleSpinBox*>(QStringLiteral("towerGap"));
    EXPECT_TRUE(gap->isEnabled());
    gap->setValue(20);
    EXPECT_EQ(form.settings().gapM, 20);
    form.findChild<QPushButton*>(QStringLiteral("removeTower"))->click();
    EXPECT_TRUE(form.settings().further.empty());
}

// Around "South House": 50 x 50 m.
NamedLot southLot() { return {"Lot 1", test::square({-25, -65}, 50)}; }

TowerDraft draftOf(int storeys) {
    return {.lot = southLot(), .settings = {.storeyHeightM = 4, .storeys = storeys}, .tower = "Tower 1"};
}

TEST(TowerDraft, DemolishesWhatStandsOnTheLotAndAddsTheTower) {
    const auto tower = draftTower(test::smallCity(), draftOf(10)).value();
    ASSERT_EQ(tower.edits.size(), 2U);
    EXPECT_EQ(std::get<Demolish>(tower.edits[0]).building, "South House");
    EXPECT_EQ(std::get<AddBuilding>(tower.edits[1]).building->sourceId, "Tower 1");
    EXPECT_NEAR(tower.massing.figures.grossFloorM2, 25000, 1e-3);
    EXPECT_NEAR(tower.massing.figures.floorAreaRatio, 10, 1e-6);
    const auto edited = applyEdits(test::smallCity(), tower.edits).value();
    EXPECT_EQ(edited.city.buildings.size(), 3U);
    EXPECT_FLOAT_EQ(topM(*edited.city.buildings.back()), 40);
}

TEST(TowerDraft, TheReplacedBuildingIsNotDemolishedToo) {
    TowerDraft draft = draftOf(10);
    draft.replaces = "South House";
    const auto tower = draftTower(test::smallCity(), draft).value();
    ASSERT_EQ(tower.edits.size(), 1U);
    EXPECT_EQ(std::get<Replace>(tower.edits[0]).building, "South House");
    EXPECT_TRUE(applyEdits(test::smallCity(), tower.edits));
}

TEST(TowerDraft, WhatCannotBeSaysItsLimit) {
    TowerDraft draft = draftOf(10);
    draft.settings.plate.areaM2 = 5000;
    EXPECT_NE(draftTower(test::smallCity(), draft).error().advice.find("2500 m2"), std::string::npos);
    draft = draftOf(10);
    draft.settings.setbacks = {{.aboveM = 20, .insetM = 30}};
    EXPECT_NE(draftTower(test::smallCity(), draft).error().advice.find("25.0 m"), std::string::npos);
    draft = draftOf(10);
    draft.settings.podium = Podium{.storeys = 10};
    EXPECT_FALSE(draftTower(test::smallCity(), draft));
}

TEST(TowerDraft, AHeightIsStatedInStoreysWhereItIsWhole) {
    MassingSettings settings{.storeyHeightM = 4, .storeys = 10};
    settings = withHeight(settings, 48);
    EXPECT_EQ(settings.storeys, 12);
    EXPECT_EQ(settings.heightM, 0);
    settings = withHeight(settings, 49.5);
    EXPECT_EQ(settings.storeys, 0);
    EXPECT_DOUBLE_EQ(heightOf(settings), 49.5);
    EXPECT_TRUE(makeMassing(southLot().outline, settings));
}

TEST(TowerDraft, NamesAreFree) {
    City city = test::smallCity();
    EXPECT_EQ(freeTowerName(city), "Tower 1");
    city = applyEdits(city, draftTower(city, draftOf(3)).value().edits).value().city;
    EXPECT_EQ(freeTowerName(city), "Tower 2");
    EXPECT_EQ(freeLotName({southLot()}), "Lot 2");
}

TEST(BuildingFacts, OfABox) {
    const City city = test::smallCity();
    const BuildingFacts facts = collectFacts(*city.buildings[0], city);
    EXPECT_EQ(facts.title, QStringLiteral("South House"));
    EXPECT_NEAR(facts.heightM, 60, 1e-4);
    EXPECT_EQ(facts.heightSource, QStringLiteral("measured"));
    EXPECT_EQ(facts.storeys, 17);
    EXPECT_NEAR(facts.planM2, 1600, 0.1);
    EXPECT_NEAR(facts.grossFloorM2.value_or(0), 17 * 1600, 1);
    EXPECT_NEAR(area(lotUnder(*city.buildings[0], city).value()), 1600, 0.1);
    const std::vector<Edit> higher{ChangeHeight{"South House", 297.5}};
    const City changed = applyEdits(city, higher).value().city;
    EXPECT_EQ(collectFacts(*changed.buildings[0], changed).heightSource, QStringLiteral("designed"));
}

// A setback's upper volume stands on the lower one: both together are as high as the building.
TEST(BuildingFacts, TheUpperVolumeOfATowerIsAsHighAsTheTower) {
    City city = test::smallCity();
    Building tower = *city.buildings[0];
    Part upper = tower.parts.front();
    upper.bottomM = upper.topM;
    upper.topM += 30;
    tower.parts.push_back(upper);
    city.buildings[0] = std::make_shared<const Building>(std::move(tower));
    const BuildingFacts facts = collectFacts(*city.buildings[0], city);
    EXPECT_NEAR(facts.heightM, 90, 1e-4);
    EXPECT_NEAR(facts.highestPartM, 90, 1e-4);
}

// 60 m that were 20 storeys of 3 m are 20 storeys, not 17 of 3.5 m.
TEST(BuildingFacts, StoreysOfTheDataAreKept) {
    City city = test::smallCity();
    Building counted = *city.buildings[0];
    for (Part& part : counted.parts) part.heightSource = HeightSource::levels;
    city.buildings[0] = std::make_shared<const Building>(std::move(counted));
    const BuildingFacts facts = collectFacts(*city.buildings[0], city, nullptr, 3);
    EXPECT_EQ(facts.storeys, 20);
    EXPECT_TRUE(facts.storeysAreStated);
    EXPECT_NEAR(facts.grossFloorM2.value_or(0), 20 * 1600, 1);
}

// Its plan is that of all its parts, and it has no floor area: not 0 m2.
TEST(BuildingFacts, OfARoofOnPosts) {
    City city = test::smallCity();
    Building raised = *city.buildings[0];
    for (Part& part : raised.parts) part.bottomM = part.topM - 1;
    city.buildings[0] = std::make_shared<const Building>(std::move(raised));
    const BuildingFacts facts = collectFacts(*city.buildings[0], city);
    EXPECT_NEAR(facts.planM2, 1600, 0.1);
    EXPECT_FALSE(facts.grossFloorM2);
}

}  // namespace

}  // namespace noonmark
