#include "app/gui/tools/editing/edit_tools.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QPushButton>
#include <QTemporaryDir>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/tools/massing/massing_panel.h"
#include "scenarios/edits/placed_building.h"
#include "tests/gui/edit_tools_fixture.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;

TEST_F(EditToolsTest, DemolishTakesTheSelectedBuildingAway) {
    tools.building().select(0);
    tools.building().demolish();
    ASSERT_EQ(made.size(), 1U);
    EXPECT_EQ(lastEdit<Demolish>().building, "South House");
    EXPECT_EQ(city->city().buildings.size(), 2U);
    EXPECT_FALSE(tools.building().selected()) << "it has been removed";
    tools.building().demolish();
    EXPECT_EQ(made.size(), 1U) << "nothing is selected";
}

TEST_F(EditToolsTest, AClickSelectsAndEscDeselects) {
    const auto pixel = pixelOf(view.view().pose(), view.view().lens(), {0, -40, 60});
    Q_EMIT view.navigator().clicked({pixel->x, pixel->y});
    EXPECT_EQ(tools.building().id(), "South House");
    Q_EMIT view.navigator().keyPressed(Qt::Key_Escape);
    EXPECT_FALSE(tools.building().selected());
}

TEST_F(EditToolsTest, HeightIsPreviewedAndThenOneEdit) {
    tools.building().select(2);
    number("buildingHeight").setValue(120);
    EXPECT_TRUE(made.empty()) << "still being typed";
    ASSERT_EQ(tools.context().preview.changes().added.size(), 1U);
    EXPECT_FLOAT_EQ(topM(*tools.context().preview.changes().added.front()), 120);
    enter(number("buildingHeight"));
    ASSERT_EQ(made.size(), 1U);
    EXPECT_EQ(lastEdit<ChangeHeight>(), (ChangeHeight{"Tower", 120}));
    EXPECT_EQ(tools.building().id(), "Tower") << "still selected";
    EXPECT_FALSE(tools.context().preview.shown());
    enter(number("buildingHeight"));
    EXPECT_EQ(made.size(), 1U) << "nothing new";
}

TEST_F(EditToolsTest, MoveAndTurnAreEdits) {
    tools.building().select(1);
    number("moveEast").setValue(12.5);
    enter(number("moveEast"));
    EXPECT_EQ(lastEdit<Move>(), (Move{"Low House", {12.5, 0}}));
    number("buildingTurn").setValue(30);
    enter(number("buildingTurn"));
    EXPECT_EQ(lastEdit<Rotate>(), (Rotate{"Low House", 30}));
    EXPECT_EQ(made.size(), 2U);
}

TEST_F(EditToolsTest, ADragOnAHouseMovesIt) {
    view.navigator().show({{-200, -200}, {200, 200}});
    tools.building().select(1);
    tools.building().setMoving(true);
    MoveTool& move = tools.building().moveTool();
    EXPECT_FALSE(move.grab(pixelAt({0, -40, 60}))) << "another building";
    ASSERT_TRUE(move.grab(pixelAt({75, 35, 25})));
    move.dragTo(pixelAt({95, 25, 25}));
    move.drop();
    ASSERT_EQ(made.size(), 1U);
    EXPECT_NEAR(lastEdit<Move>().byM.x, 20, 0.2);
    EXPECT_NEAR(lastEdit<Move>().byM.y, -10, 0.2);
}

TEST_F(EditToolsTest, EscLetsGoOfWhatIsDragged) {
    dragTheLowHouse();
    Q_EMIT view.navigator().keyPressed(Qt::Key_Escape);
    EXPECT_FALSE(tools.context().preview.shown()) << "it has not moved";
    EXPECT_EQ(tools.building().id(), "Low House") << "still selected";
    EXPECT_EQ(number("moveEast").value(), 0);
    tools.building().moveTool().drop();
    EXPECT_TRUE(made.empty());
}

TEST_F(EditToolsTest, ADragEndsWhereAnotherCityArrives) {
    dragTheLowHouse();
    show(city->city());
    tools.building().moveTool().drop();
    EXPECT_TRUE(made.empty());
}

TEST_F(EditToolsTest, EnterTakesANumberOnceAndLeavingTheFieldDoesNot) {
    cityComesBack = false;
    tools.building().select(1);
    const std::vector<std::pair<const char*, double>> typed{
        {"moveEast", 10}, {"moveNorth", -5}, {"buildingTurn", 30}, {"buildingHeight", 44}};
    for (const auto& [name, value] : typed) {
        made.clear();
        number(name).setValue(value);
        leave(number(name));
        EXPECT_TRUE(made.empty()) << name << ": Enter was not pressed";
        enter(number(name));
        EXPECT_EQ(made.size(), 1U) << name;
        leave(number(name));
        enter(number(name));
        EXPECT_EQ(made.size(), 1U) << name << ": taken before";
    }
}

TEST_F(EditToolsTest, HeightsAreShownAndTakenAboveTheDatum) {
    City raised = city->city();
    raised.frame = Frame(raised.frame.origin(), 12.5);
    show(raised);
    tools.building().select(0);
    auto& height = static_cast<LengthField&>(number("buildingHeight"));
    EXPECT_EQ(height.text(), QStringLiteral("60.0 m"));
    applyHeightReference(HeightReference::datum);
    tools.heightReferenceChanged();
    EXPECT_EQ(height.text(), QStringLiteral("72.5 m"));
    EXPECT_EQ(height.value(), 60) << "edits stay above the ground";
    EXPECT_EQ(height.valueFromText(QStringLiteral("80")), 67.5);
    EXPECT_TRUE(made.empty());
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});
    EXPECT_EQ(number(tools.massingDock(), "totalHeight").text(), QStringLiteral("47.5 m"));
    for (const int key : {Qt::Key_1, Qt::Key_0, Qt::Key_0, Qt::Key_Return})
        Q_EMIT view.navigator().keyPressed(key);
    tools.tower().build();
    EXPECT_FLOAT_EQ(topM(*city->city().buildings.back()), 87.5F);
    applyHeightReference(HeightReference::ground);
}

TEST_F(EditToolsTest, AMeshAndATowerAreNotAtWorkTogether) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("hut.obj"));
    std::ofstream(file.toStdString()) << "v 0 0 0\nv 10 0 0\nv 0 0 10\nv 0 10 0\n"
                                         "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n";
    drawLot({{-25, -65}, {25, -65}, {25, -15}, {-25, -15}});
    ASSERT_TRUE(tools.tower().active());
    tools.mesh().begin(file);
    ASSERT_TRUE(waitFor([this] { return tools.mesh().active(); }, 10000));
    EXPECT_FALSE(tools.tower().active());
    EXPECT_FALSE(tools.context().preview.shown());
    tools.tower().begin(lots.front(), {});
    EXPECT_TRUE(tools.tower().active());
    EXPECT_FALSE(tools.mesh().active());
}

class MeshToolTest : public EditToolsTest {
protected:
    void pick(const char* name, int item) {
        QComboBox& combo = field<QComboBox>(tools.dock(), name);
        combo.setCurrentIndex(item);
        Q_EMIT combo.activated(item);
    }
    double shownHeight() {
        const auto& built = tools.context().preview.changes().added;
        return built.empty() ? 0 : double(topM(*built.back()));
    }
};

TEST_F(MeshToolTest, AMeshStandsUprightWithTheStatedAxisAndUnit) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("spire.obj"));
    std::ofstream(file.toStdString()) << "v 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 100\n"
                                         "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    tools.mesh().begin(file);
    ASSERT_TRUE(waitFor([this] { return tools.mesh().active(); }, 10000));
    tools.mesh().placeAt({0, 200});
    EXPECT_NEAR(shownHeight(), 100, 1e-3) << "ten times as high as wide: Z is up";
    pick("up", 1);
    ASSERT_TRUE(waitFor([&] { return std::abs(shownHeight() - 10) < 1e-3; }, 10000)) << "Y is up";
    pick("up", 2);
    ASSERT_TRUE(waitFor([&] { return std::abs(shownHeight() - 100) < 1e-3; }, 10000));
    pick("meshUnit", 1);
    ASSERT_TRUE(waitFor([&] { return std::abs(shownHeight() - 30.48) < 1e-3; }, 10000));
    tools.mesh().build();
    EXPECT_NEAR(double(topM(*lastEdit<ImportMesh>().shape)), 30.48, 1e-3);
}

void writeBox(const QString& file, double sideM, double heightM) {
    std::ofstream box(file.toStdString());
    for (const double z : {0.0, heightM})
        for (const auto& [x, y] : {std::pair(0.0, 0.0), std::pair(sideM, 0.0), std::pair(sideM, sideM / 4),
                                   std::pair(0.0, sideM / 4)})
            box << "v " << x << ' ' << y << ' ' << z << '\n';
    box << "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
}

// The corner at the model's zero stays where it was, whatever the middle of the new edition is.
TEST_F(MeshToolTest, AnotherEditionStandsWhereTheEarlierOneStood) {
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("proposal.obj"));
    writeBox(file, 20, 60);
    tools.mesh().begin(file);
    ASSERT_TRUE(waitFor([this] { return tools.mesh().active(); }, 10000));
    number("meshTurn").setValue(30);
    number("meshLongitude").setValue(city->city().frame.lonLatFromLocal({0, 200}).lonDeg);
    number("meshLatitude").setValue(city->city().frame.lonLatFromLocal({0, 200}).latDeg);
    pick("meshUnit", 1);  // feet
    ASSERT_TRUE(waitFor([this] { return std::abs(shownHeight() - 60 * 0.3048) < 1e-3; }, 10000));
    tools.mesh().build();
    const ImportMesh first = lastEdit<ImportMesh>();
    EXPECT_NEAR(findMiddle(*city->city().buildings.back()).y, 200, 0.05) << "typed";
    tools.setProposals({first});
    pick("meshUnit", 0);  // as another file needs it
    std::optional<ImportMesh> edition;
    QObject::connect(&tools, &EditTools::editionRead, [&](const ImportMesh& read) { edition = read; });
    writeBox(file, 40, 90);
    tools.mesh().begin(file);
    ASSERT_TRUE(waitFor([this] { return tools.mesh().active() && tools.context().preview.shown(); }, 10000));
    EXPECT_EQ(number("meshTurn").value(), 30);
    EXPECT_EQ(field<QComboBox>(tools.dock(), "meshUnit").currentIndex(), 1) << "remembered";
    EXPECT_FALSE(field<QPushButton>(tools.dock(), "reloadMesh").isHidden());
    tools.mesh().reload();
    ASSERT_TRUE(edition);
    EXPECT_EQ(edition->shape->sourceId, first.shape->sourceId);
    EXPECT_NEAR(double(topM(*edition->shape)), 90 * 0.3048, 1e-3);
    const auto cornerOf = [](const ImportMesh& mesh) {
        const Building placed = placeBuilding(*mesh.shape, mesh.placement);
        glm::dvec2 west(1e9, 0);
        for (const glm::vec2 point : placed.parts.front().footprint.outer)
            if (double(point.x) < west.x) west = point;
        for (const glm::vec3& vertex :
             placed.parts.front().mesh ? placed.parts.front().mesh->vertices : std::vector<glm::vec3>{})
            if (double(vertex.x) < west.x) west = glm::vec2(vertex);
        return west;
    };
    EXPECT_NEAR(glm::distance(cornerOf(*edition), cornerOf(first)), 0, 0.02);
    EXPECT_FALSE(tools.mesh().active());
}

TEST_F(EditToolsTest, AnIfcIsTurnedByItsTrueNorth) {
    const std::filesystem::path house = "../shared/data/world/FZK.ifc";
    if (!std::filesystem::exists(house)) GTEST_SKIP() << "shared data is missing";
    tools.mesh().begin(QString::fromStdString(house.string()));
    ASSERT_TRUE(waitFor([this] { return tools.mesh().active(); }, 20000));
    EXPECT_NEAR(number("meshTurn").value(), -50, 0.1) << "true north is 50 degrees clockwise of its y";
    EXPECT_FALSE(tools.context().preview.shown()) << "it states a place in Karlsruhe";
}

}  // namespace
}  // namespace noonmark
