#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QTest>

#include "app/gui/tools/editing/selection_panel.h"
#include "app/gui/tools/massing/massing_panel.h"
#include "scenarios/project/edit_json.h"
#include "tests/gui/edit_tools_fixture.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;

TEST_F(EditToolsTest, ALotIsDrawnAndATowerBuiltOnIt) {
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});
    ASSERT_EQ(lots.size(), 1U);
    EXPECT_EQ(lots.front().name, "Lot 1");
    ASSERT_TRUE(tools.tower().active());
    tools.tower().setHeight(70);
    EXPECT_EQ(field<QSpinBox>(tools.massingDock(), "storeys").value(), 20);
    tools.tower().build();
    ASSERT_EQ(made.size(), 1U) << "one undo step";
    EXPECT_EQ(made.front().size(), 2U);
    EXPECT_EQ(lastEdit<AddBuilding>().building->sourceId, "Tower 1");
    EXPECT_FLOAT_EQ(topM(*city->city().buildings.back()), 70);
    EXPECT_EQ(tools.building().id(), "Tower 1") << "the new building is selected";
}

TEST_F(EditToolsTest, OnALowScreenTheFieldsOfATowerComeIntoSight) {
    QWidget* panel = tools.massingDock();
    panel->setAttribute(Qt::WA_DontShowOnScreen);
    panel->resize(330, 520);
    panel->show();
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});
    const auto isInSight = [&](const char* name) {
        QWidget& one = field<QWidget>(panel, name);
        return one.visibleRegion().boundingRect().height() == one.height();
    };
    EXPECT_TRUE(waitFor([&] { return isInSight("storeys"); }));
    EXPECT_TRUE(isInSight("applyMassing"));
    EXPECT_TRUE(isInSight("figures"));
}

TEST_F(EditToolsTest, ATowerOutsideTheRegionSaysSoAndMovesItThere) {
    LiveQuestion question;
    question.region = makeRegionFromLocalBox({{300, 300}, {400, 400}});
    tools.setQuestion(question);
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});
    QWidget* panel = tools.massingDock();
    auto& words = field<QLabel>(panel, "towerBeyond");
    EXPECT_FALSE(words.isHidden());
    EXPECT_THAT(words.text().toStdString(), testing::HasSubstr("outside the study's region"));
    std::optional<Region> asked;
    QObject::connect(&tools, &EditTools::regionRequested, [&](const Region& region) { asked = region; });
    field<QPushButton>(panel, "moveRegion").click();
    ASSERT_TRUE(asked);
    EXPECT_EQ((bounds(*asked).low + bounds(*asked).high) / 2.0F, glm::vec2(0, -40));
    question.region = *asked;
    tools.setQuestion(question);
    EXPECT_TRUE(words.isHidden());
}

TEST_F(EditToolsTest, ATowerIsCopiedToAnotherLotWithItsParameters) {
    lots = {{"South", test::square({-25, -65}, 40)}, {"East", test::square({120, -65}, 25)}};
    tools.setLots(lots);
    tools.tower().begin(lots[0], {}, {.storeys = 20});
    tools.tower().build();
    ASSERT_EQ(tools.building().id(), "Tower 1");
    field<QComboBox>(tools.massingDock(), "lot").setCurrentIndex(1);
    field<QPushButton>(tools.massingDock(), "copyTower").click();
    ASSERT_TRUE(tools.tower().active()) << "to be looked at, and changed, before it is built";
    EXPECT_EQ(tools.tower().draft()->settings.storeys, 20);
    tools.tower().build();
    ASSERT_EQ(made.size(), 2U) << "one undo step each";
    const Building& copy = *lastEdit<AddBuilding>().building;
    EXPECT_EQ(copy.sourceId, "Tower 2");
    EXPECT_FLOAT_EQ(topM(copy), 70);
    EXPECT_NEAR(area(copy.parts.front().footprint), 25 * 25, 0.1) << "a whole lot stays a whole lot";
    tools.building().select(0);
    std::string refused;
    QObject::connect(&tools, &EditTools::failed, [&refused](const Error& error) { refused = error.what; });
    tools.copyTower(lots[0]);
    EXPECT_THAT(refused, testing::HasSubstr("No tower is selected"));
}

TEST_F(EditToolsTest, AFurtherTowerBeginsAsTheOneBeforeIt) {
    drawLot({{-40, -65}, {40, -65}, {40, -15}, {-40, -15}});
    auto& panel = *static_cast<MassingPanel*>(tools.massingDock());
    TowerDraft draft = panel.draft();
    draft.settings.storeys = 12;
    draft.settings.plate = {.areaM2 = 500};
    panel.showDraft(draft);
    Q_EMIT panel.edited();
    field<QPushButton>(&panel, "addTower").click();
    ASSERT_EQ(tools.tower().draft()->settings.further.size(), 1U);
    EXPECT_EQ(tools.tower().draft()->settings.further.front().storeys, 12);
    EXPECT_EQ(tools.tower().draft()->settings.further.front().plate, (PlateSize{.areaM2 = 500}));
    EXPECT_EQ(panel.message().toStdString(), "");
}

TEST_F(EditToolsTest, ATowerTapersAndItsDesignIsSavedWithTheEdit) {
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});
    auto* walls = tools.massingDock()->findChild<QWidget*>(QStringLiteral("towerWalls"));
    ASSERT_NE(walls, nullptr);
    field<QDoubleSpinBox>(walls, "taper").setValue(50);
    ASSERT_FALSE(tools.context().preview.changes().added.empty());
    EXPECT_TRUE(tools.context().preview.changes().added.back()->parts[0].mesh) << "leaning walls";
    tools.tower().build();
    ASSERT_TRUE(lastEdit<AddBuilding>().design);
    EXPECT_EQ(lastEdit<AddBuilding>().design->settings.walls, (WallShape{.taper = 0.5}));
    EXPECT_EQ(lastEdit<AddBuilding>().design->lotName, "Lot 1");
}

TEST_F(EditToolsTest, UsesAreListedWithTheirAreas) {
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});
    for (int i = 0; i < 2; ++i) field<QPushButton>(tools.massingDock(), "addUse").click();
    const QString figures = field<QLabel>(tools.massingDock(), "figures").text();
    EXPECT_TRUE(figures.contains(QStringLiteral("Retail, 1 storey"))) << figures.toStdString();
    EXPECT_TRUE(figures.contains(QStringLiteral("Offices, 9 storeys"))) << figures.toStdString();
    EXPECT_TRUE(figures.contains(QStringLiteral("22,500"))) << figures.toStdString();
    field<QPushButton>(tools.massingDock(), "removeUse").click();
    tools.tower().build();
    EXPECT_EQ(lastEdit<AddBuilding>().design->settings.uses, (std::vector<FloorUse>{{"Retail", 1}}));
}

TEST_F(EditToolsTest, ATowerOfAnEarlierSessionIsDesignedFurtherAndCopied) {
    lots = {{"South", test::square({-25, -65}, 40)}, {"East", test::square({120, -65}, 25)}};
    tools.setLots(lots);
    tools.tower().begin(lots[0], {}, {.storeys = 20});
    tools.tower().build();
    std::vector<Edit> reopened;
    for (const Edit& edit : all)
        reopened.push_back(parseEdit(std::string(getKind(edit)), toJson(edit)).value());
    tools.setTowers(findProposedTowers(reopened));
    tools.replace();
    ASSERT_TRUE(tools.tower().draft());
    EXPECT_EQ(tools.tower().draft()->lot.name, "South");
    EXPECT_EQ(tools.tower().draft()->settings.storeys, 20);
    tools.cancel();
    reopened.emplace_back(Move{"Tower 1", {1, 0}});
    tools.setTowers(findProposedTowers(reopened));
    EXPECT_FALSE(tools.tower().designOf(*city->city().buildings.back())) << "it was moved";
    tools.copyTower(lots[1]);
    ASSERT_TRUE(tools.tower().draft());
    EXPECT_EQ(tools.tower().draft()->lot.name, "East");
    EXPECT_EQ(tools.tower().draft()->settings.storeys, 20);
}

TEST_F(EditToolsTest, ATowerShowsTheSunlightOfItsFacadesUntilItIsSwitchedOff) {
    lots = {{"South", test::square({-25, -65}, 40)}};
    tools.setLots(lots);
    ElementTiles& tiles = view.view().tiles();
    tools.tower().begin(lots[0], {}, {.storeys = 20});
    ASSERT_TRUE(test::waitFor([&] { return !tiles.tiles().empty(); }));
    const EditPreview& preview = tools.context().preview;
    ASSERT_TRUE(
        test::waitFor([&] { return preview.facades().answer() && !preview.facades().answer()->coarse; }));
    EXPECT_EQ(tiles.tiles().size(), preview.facades().answer()->map.elements.size());
    EXPECT_TRUE(field<QCheckBox>(tools.massingDock(), "liveFacades").isChecked());
    field<QCheckBox>(tools.massingDock(), "liveFacades").click();
    EXPECT_FALSE(tools.facadesAction().isChecked());
    EXPECT_TRUE(tiles.tiles().empty());
    tools.facadesAction().trigger();
    ASSERT_TRUE(test::waitFor([&] { return !tiles.tiles().empty(); }));
    tools.tower().cancel();
    EXPECT_TRUE(tiles.tiles().empty());
}

TEST_F(EditToolsTest, TheEnterThatFinishesTheLotDoesNotBuildYet) {
    tools.drawLot();
    for (const glm::dvec2 corner : {glm::dvec2{-25, -65}, {25, -65}, {25, -15}})
        view.lotTool().addPoint({corner, 0});
    Q_EMIT view.navigator().keyPressed(Qt::Key_Return);
    EXPECT_TRUE(tools.tower().active());
    EXPECT_TRUE(made.empty());
    tools.drawLot();
    Q_EMIT view.navigator().keyPressed(Qt::Key_Escape);
    EXPECT_FALSE(view.drawing());
}

TEST_F(EditToolsTest, ATowerInABuildingsPlaceBeginsAsHighAsThatIs) {
    tools.building().select(0);
    tools.replace();
    EXPECT_EQ(field<QSpinBox>(tools.massingDock(), "storeys").value(), 17) << "60 m";
    tools.tower().build();
    ASSERT_EQ(made.size(), 1U);
    EXPECT_EQ(lastEdit<Replace>().building, "South House");
    EXPECT_NEAR(massOf(0), 17 * 1600, 1);
}

TEST_F(EditToolsTest, WhatWasBuiltIsDesignedFurther) {
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});
    tools.tower().build();
    tools.replace();
    ASSERT_TRUE(tools.tower().active());
    tools.tower().setHeight(105);
    tools.tower().build();
    ASSERT_EQ(made.size(), 2U);
    EXPECT_EQ(made.back().size(), 1U);
    EXPECT_EQ(lastEdit<Replace>().building, "Tower 1");
    EXPECT_FLOAT_EQ(topM(*city->city().buildings.back()), 105);
}

TEST_F(EditToolsTest, ADesignIsNotThatOfAnotherTowerOfThisName) {
    const City without = city->city();
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});
    tools.tower().build();
    City other = without;  // another scenario, with its own tower elsewhere
    Building tower = *without.buildings[1];
    tower.sourceId = "Tower 1";
    other.buildings[1] = std::make_shared<const Building>(tower);
    tools.setTowers({});
    show(other);
    tools.building().select(1);
    tools.replace();
    const TowerDraft draft = static_cast<MassingPanel*>(tools.massingDock())->draft();
    EXPECT_EQ(draft.replaces, "Tower 1");
    EXPECT_NE(draft.lot.name, "Lot 1") << "it is not in this city";
}

TEST_F(EditToolsTest, AMassingThatCannotBeSaysItsLimitAndIsNotBuilt) {
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});
    auto& panel = *static_cast<MassingPanel*>(tools.massingDock());
    TowerDraft draft = panel.draft();
    draft.settings.plate.areaM2 = 4000;
    tools.tower().resume(draft);
    EXPECT_TRUE(panel.message().contains(QStringLiteral("2500 m2"))) << panel.message().toStdString();
    EXPECT_FALSE(field<QPushButton>(tools.massingDock(), "applyMassing").isEnabled());
    tools.tower().build();
    EXPECT_TRUE(made.empty());
    draft.settings.plate.areaM2 = 400;
    tools.tower().resume(draft);
    EXPECT_TRUE(panel.message().isEmpty());
    tools.cancel();
    EXPECT_FALSE(tools.context().preview.shown());
    EXPECT_TRUE(made.empty());
}

// Three quarters of a square of 50 m, turned by 45 degrees: 61 m across, of which 25 degrees are too many.
TEST_F(EditToolsTest, TheWrongFieldIsMarkedAndTheNearestValueIsOffered) {
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});
    auto& panel = *static_cast<MassingPanel*>(tools.massingDock());
    TowerDraft draft = panel.draft();
    draft.settings.plate.shareOfLot = 0.75;
    tools.tower().resume(draft);
    auto& turn = field<QDoubleSpinBox>(&panel, "towerTurn");
    const QColor standard = turn.palette().color(QPalette::Base);
    turn.setValue(45);
    EXPECT_NE(turn.palette().color(QPalette::Base), standard);
    EXPECT_FALSE(field<QPushButton>(&panel, "applyMassing").isEnabled());
    field<QPushButton>(&panel, "takeNearest").click();
    EXPECT_EQ(turn.palette().color(QPalette::Base), standard);
    // 43.3 m (cos a + sin a) <= 50 m up to 10 degrees.
    EXPECT_NEAR(turn.value(), 10, 1);
    EXPECT_TRUE(panel.message().isEmpty());
    EXPECT_TRUE(field<QPushButton>(&panel, "applyMassing").isEnabled());
}

TEST_F(EditToolsTest, AFloorAreaIsReachedByStoreysOrByThePlate) {
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});  // 2500 m2
    QWidget* panel = tools.massingDock();
    field<QDoubleSpinBox>(panel, "targetNumber").setValue(31000);
    field<QPushButton>(panel, "fitStoreys").click();
    EXPECT_EQ(tools.tower().draft()->settings.storeys, 12);
    field<QDoubleSpinBox>(panel, "targetNumber").setValue(15000);
    field<QPushButton>(panel, "fitPlate").click();
    EXPECT_NEAR(*tools.tower().draft()->settings.plate.areaM2, 1250, 1.5);
    field<QDoubleSpinBox>(panel, "targetNumber").setValue(90000);
    field<QPushButton>(panel, "fitPlate").click();
    EXPECT_TRUE(static_cast<MassingPanel*>(panel)->message().contains(QStringLiteral("more storeys")));
    EXPECT_TRUE(field<QPushButton>(panel, "applyMassing").isEnabled()) << "the tower stays as it is";
}

// The target states what the tower has until another is typed, and the tower takes that at once.
TEST_F(EditToolsTest, AFloorAreaThatIsTypedIsHeeded) {
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});  // 2500 m2
    QWidget* panel = tools.massingDock();
    auto& number = field<QDoubleSpinBox>(panel, "targetNumber");
    EXPECT_EQ(number.value(), 25000) << "ten storeys";
    field<QSpinBox>(panel, "storeys").setValue(4);
    EXPECT_EQ(number.value(), 10000);
    number.setValue(20400);
    EXPECT_EQ(tools.tower().draft()->settings.storeys, 8);
    EXPECT_EQ(number.value(), 20400) << "as it was typed";
    auto& kind = field<QComboBox>(panel, "targetKind");
    kind.setCurrentIndex(1);
    Q_EMIT kind.activated(1);
    EXPECT_EQ(number.value(), 8) << "the ratio of the tower as it is";
    number.setValue(3);
    EXPECT_EQ(tools.tower().draft()->settings.storeys, 3);
    field<QPushButton>(panel, "fitPlate").click();
    EXPECT_EQ(tools.tower().draft()->settings.storeys, 8) << "as before the other button";
    EXPECT_NEAR(*tools.tower().draft()->settings.plate.areaM2, 7500.0 / 8, 1.5);
}

// At 1366 x 768 the panel has some 545 pixels, of which figures and buttons take 180.
TEST_F(EditToolsTest, SetbacksAreInSightOnALowScreen) {
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});
    QWidget* panel = tools.massingDock();
    panel->setAttribute(Qt::WA_DontShowOnScreen);
    panel->resize(340, 545);
    panel->show();
    QTest::qWait(50);
    auto* scroll = panel->findChild<QScrollArea*>();
    const auto& add = field<QPushButton>(panel, "addSetback");
    const int bottom = add.mapTo(scroll->viewport(), QPoint(0, add.height())).y();
    EXPECT_LE(bottom, scroll->viewport()->height());
    EXPECT_GT(bottom, 0);
}

TEST_F(EditToolsTest, FieldsOfATowerStayWithinTheirPanelWhateverItsPlateIs) {
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});
    QWidget* panel = tools.massingDock();
    panel->setAttribute(Qt::WA_DontShowOnScreen);
    panel->resize(350, 700);
    panel->show();
    field<QPushButton>(panel, "fitPlate").click();  // a plate by its area has the widest number
    QCoreApplication::processEvents();
    const auto* scroll = panel->findChild<QScrollArea*>();
    EXPECT_LE(scroll->widget()->width(), scroll->viewport()->width());
}

TEST_F(EditToolsTest, WithoutALotThePanelSaysHowToBegin) {
    QWidget* panel = tools.massingDock();
    tools.setLots({});
    EXPECT_FALSE(field<QLabel>(panel, "towerHint").isHidden());
    tools.setLots({{"South", test::square({-25, -65}, 40)}});
    EXPECT_TRUE(field<QLabel>(panel, "towerHint").isHidden());
}

TEST_F(EditToolsTest, ATowerThatReplacedABuildingIsOfferedForEditing) {
    tools.setLots({});
    tools.building().select(0);
    tools.replace();
    tools.tower().build();
    QWidget* panel = tools.massingDock();
    EXPECT_TRUE(field<QLabel>(panel, "towerHint").isHidden());
    EXPECT_FALSE(field<QPushButton>(panel, "editLot").isEnabled()) << "not drawn: a footprint";
    field<QPushButton>(panel, "editTower").click();
    ASSERT_TRUE(tools.tower().active());
    EXPECT_EQ(tools.tower().draft()->replaces, "Tower 1");
}

TEST_F(EditToolsTest, TheNextTowerBeginsWithTheValuesOfTheLastOne) {
    lots = {{"South", test::square({-25, -65}, 40)}, {"East", test::square({120, -65}, 25)}};
    tools.setLots(lots);
    tools.tower().begin(lots[0], {}, {.storeys = 20, .plate = {.areaM2 = 900}});
    tools.tower().build();
    field<QComboBox>(tools.massingDock(), "lot").setCurrentIndex(1);
    QString hint;
    QObject::connect(&tools, &EditTools::hinted, [&hint](const QString& text) { hint = text; });
    field<QPushButton>(tools.massingDock(), "designTower").click();
    EXPECT_EQ(tools.tower().draft()->settings.storeys, 20);
    EXPECT_TRUE(hint.contains(QStringLiteral("smaller"))) << hint.toStdString();  // 625 m2
    EXPECT_FALSE(field<QPushButton>(tools.massingDock(), "editTower").isEnabled());
    tools.cancel();
    field<QComboBox>(tools.massingDock(), "lot").setCurrentIndex(0);
    field<QPushButton>(tools.massingDock(), "editTower").click();
    ASSERT_TRUE(tools.tower().active());
    EXPECT_EQ(tools.tower().draft()->replaces, "Tower 1");
    EXPECT_EQ(tools.tower().draft()->settings.plate.areaM2, 900);
}

TEST_F(EditToolsTest, ADesignedTowerKeepsItsDesignAtAnotherHeight) {
    lots = {{"South", test::square({-25, -65}, 40)}};
    tools.setLots(lots);
    tools.tower().begin(lots[0], {}, {.storeys = 20, .plate = {.areaM2 = 900}});
    tools.tower().build();
    const std::size_t tower = city->city().buildings.size() - 1;
    ASSERT_EQ(city->city().buildings[tower]->sourceId, "Tower 1");
    tools.building().select(std::uint32_t(tower));
    tools.building().takeHeight(42);
    ASSERT_EQ(made.size(), 2U) << "one step of undo";
    const auto design = tools.tower().designOf(*city->city().buildings.back());
    ASSERT_TRUE(design);
    EXPECT_EQ(design->settings.storeys, 12);
    EXPECT_EQ(design->settings.plate.areaM2, 900);
    EXPECT_FLOAT_EQ(topM(*city->city().buildings.back()), 42);
}

TEST_F(EditToolsTest, TheArrowStatesTheHeight) {
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});
    ExtrudeHandle& handle = tools.context().handle;
    const ViewLens lens = view.view().lens();
    const auto grip = view.view().overlay().handlePixel(view.view().pose(), lens);
    ASSERT_TRUE(grip);
    EXPECT_FALSE(handle.grab({grip->x + 200, grip->y}));
    ASSERT_TRUE(handle.grab({grip->x, grip->y}));
    // The handle is dragged from 35 m to 84 m: 24 storeys.
    const auto low = pixelOf(view.view().pose(), lens, {0, -40, 35});
    const auto high = pixelOf(view.view().pose(), lens, {0, -40, 84.9});
    handle.dragTo({grip->x + high->x - low->x, grip->y + high->y - low->y});
    handle.drop();
    tools.tower().build();
    ASSERT_EQ(made.size(), 1U);
    EXPECT_NEAR(double(topM(*city->city().buildings.back())), 84, 4);
    EXPECT_NEAR(std::remainder(double(topM(*city->city().buildings.back())), 3.5), 0, 1e-4);
}

TEST_F(EditToolsTest, ANumberThatIsTypedIsTheHeight) {
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});
    for (const int key : {Qt::Key_9, Qt::Key_1, Qt::Key_Period, Qt::Key_5, Qt::Key_Return})
        Q_EMIT view.navigator().keyPressed(key);
    ASSERT_TRUE(tools.tower().active()) << "the first Enter ends the number";
    Q_EMIT view.navigator().keyPressed(Qt::Key_Return);
    ASSERT_EQ(made.size(), 1U);
    EXPECT_FLOAT_EQ(topM(*city->city().buildings.back()), 91.5F);
}

TEST_F(EditToolsTest, VariantsKeepTheFloorArea) {
    drawLot({{-40, -80}, {40, -80}, {40, 0}, {-40, 0}});
    tools.cancel();
    tools.building().select(0);
    const double before = massOf(0);
    Q_EMIT tools.dock()->findChild<SelectionPanel*>()->variantRequested(2);
    ASSERT_EQ(made.size(), 1U);
    EXPECT_EQ(lastEdit<Replace>().building, "South House");
    EXPECT_LT(topM(*city->city().buildings[0]), 35);
    EXPECT_NEAR(massOf(0), before, 0.002 * before);
}

TEST_F(EditToolsTest, TheLiveShadowShowsWhileATowerIsDesigned) {
    Period period;
    period.start = std::chrono::year(2026) / 4 / 20;
    period.from = std::chrono::hours(9);
    period.hours = 2;
    period.stepMinutes = 5;
    period.zone = "America/New_York";
    tools.setQuestion({{period, {{-73.98, 40.76}, 0}}, {}, {}});
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});
    EXPECT_TRUE(waitFor([this] { return view.legend().note().contains(QStringLiteral("proposal")); }));
    tools.cancel();
    EXPECT_FALSE(view.legend().note().contains(QStringLiteral("proposal")));
}

}  // namespace
}  // namespace noonmark
