#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QTest>
#include <algorithm>

#include "app/gui/tools/editing/tree_editing.h"
#include "render/scene/crown_bodies.h"
#include "scenarios/edits/tree_edits.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::waitFor;

Tree treeAt(double x, double y, CrownShape shape = CrownShape::ellipsoid) {
    Tree tree;
    tree.sourceId = "tree " + std::to_string(int(x));
    tree.place = {x, y};
    tree.heightM = 12;
    tree.crownBaseM = 2;
    tree.crownDiameterM = 8;
    tree.shape = shape;
    return tree;
}

// Crowns are 8 m wide and between 2 and 12 m high: from the west the first one begins 4 m before its axis.
TEST(PickTree, TheNearestCrownThatARayMeets) {
    const std::vector<Tree> trees{treeAt(30, 0), treeAt(10, 0), treeAt(10, 40)};
    const auto first = pickTree(trees, {{-20, 0, 7}, {1, 0, 0}});
    ASSERT_TRUE(first);
    EXPECT_EQ(first->tree, 1U);
    EXPECT_NEAR(first->distanceM, 26, 1e-9);
    EXPECT_FALSE(pickTree(trees, {{-20, 0, 7}, {-1, 0, 0}})) << "behind the eye";
    EXPECT_FALSE(pickTree(trees, {{-20, 0, 12.5}, {1, 0, 0}})) << "above them";
    const auto above = pickTree(trees, {{30, 0, 112}, {0, 0, -1}});
    ASSERT_TRUE(above);
    EXPECT_EQ(above->tree, 0U);
    EXPECT_NEAR(above->distanceM, 100, 1e-9);
}

/// The small project, seen from above.
struct TreeWindow : test::ProjectWindow {
    const std::vector<Tree>& trees() {
        static const std::vector<Tree> none;
        const auto& all = workbench().city()->city().trees;
        return all ? all->trees : none;
    }
    template <class Field>
    Field& field(const char* name) {
        return *window->findChild<Field*>(QString::fromLatin1(name));
    }
    QString chosen() { return field<QLabel>("chosenTrees").text(); }
    void click(glm::dvec2 ground, double z = 0) {
        const CityView& view = window->panel().view();
        const auto pixel = pixelOf(view.pose(), view.lens(), {ground, z});
        ASSERT_TRUE(pixel);
        Q_EMIT window->panel().navigator().clicked({pixel->x, pixel->y});
    }
    void plant(const std::vector<glm::dvec2>& places) {
        const std::size_t before = trees().size();
        field<QPushButton>("plantTree").click();
        for (const glm::dvec2 place : places) {
            const std::size_t count = trees().size();
            click(place);
            ASSERT_TRUE(waitFor([&] { return trees().size() == count + 1; }));
        }
        field<QPushButton>("plantTree").click();
        ASSERT_EQ(trees().size(), before + places.size());
    }
    void SetUp() override {
        ProjectWindow::SetUp();
        window->resize(1200, 800);
        window->panel().navigator().show({{-60, -60}, {60, 60}});
        QCoreApplication::processEvents();
    }
};

TEST_F(TreeWindow, AClickPlantsATreeWithTheMeasuresOfThePanel) {
    field<QLineEdit>("species").setText(QStringLiteral("Platanus"));
    plant({{-40, -40}});
    EXPECT_NE(session().scenario(), existingCity) << "the first change begins a scenario";
    ASSERT_EQ(trees().size(), 1U);
    EXPECT_NEAR(trees()[0].place.x, -40, 0.5);
    EXPECT_NEAR(trees()[0].place.y, -40, 0.5);
    EXPECT_EQ(trees()[0].species, "Platanus");
    EXPECT_EQ(trees()[0].leafOnTransmissivity, completeTree({.species = "Platanus"}).leafOnTransmissivity);
    workbench().document().undoStack().undo();
    ASSERT_TRUE(waitFor([&] { return trees().empty(); }));
}

TEST_F(TreeWindow, ARowStandsAlongALine) {
    field<QPushButton>("plantRow").click();
    field<QDoubleSpinBox>("treeSpacing").setValue(10);
    click({-50, -50});
    click({-10, -50});
    Q_EMIT window->panel().navigator().doubleClicked({0, 0});
    ASSERT_TRUE(waitFor([&] { return trees().size() == 5; })) << trees().size();
    EXPECT_NEAR(trees()[1].place.x - trees()[0].place.x, 10, 0.01);
}

TEST_F(TreeWindow, ChosenTreesAreFelledReplacedAndGrow) {
    plant({{-40, -40}, {-40, 40}});
    const Tree before = trees()[0];
    click({-40, -40}, double(before.heightM) / 2);
    EXPECT_TRUE(chosen().contains(QStringLiteral("high"))) << chosen().toStdString();
    field<QDoubleSpinBox>("treeYears").setValue(5);
    field<QPushButton>("growTrees").click();
    ASSERT_TRUE(waitFor([&] { return trees()[0].heightM > before.heightM; }));
    EXPECT_EQ(trees()[1].heightM, before.heightM) << "only the chosen one grows";
    field<QLineEdit>("species").setText(QStringLiteral("Picea"));
    field<QPushButton>("replaceTrees").click();
    ASSERT_TRUE(waitFor([&] { return trees()[0].evergreen; }));
    field<QPushButton>("fellTrees").click();
    ASSERT_TRUE(waitFor([&] { return trees().size() == 1; }));
    EXPECT_NEAR(trees()[0].place.y, 40, 0.5);
    EXPECT_FALSE(field<QPushButton>("fellTrees").isEnabled()) << "none is chosen any more";
}

TEST_F(TreeWindow, ADragMovesTheChosenTree) {
    plant({{-40, -40}});
    click({-40, -40}, 5);
    CityView& view = window->panel().view();
    const auto send = [&](QEvent::Type type, glm::dvec2 ground, Qt::MouseButtons buttons) {
        const auto pixel = pixelOf(view.pose(), view.lens(), {ground, 0});
        const QPointF at(pixel->x, pixel->y);
        QMouseEvent event(type, at, at, Qt::LeftButton, buttons, Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &event);
    };
    const glm::dvec2 from = trees()[0].place;
    send(QEvent::MouseButtonPress, {-40, -40}, Qt::LeftButton);
    send(QEvent::MouseMove, {-35, -38}, Qt::LeftButton);
    send(QEvent::MouseMove, {-30, -35}, Qt::LeftButton);
    EXPECT_EQ(trees()[0].place, from) << "it moves when it is dropped";
    send(QEvent::MouseButtonRelease, {-30, -35}, Qt::NoButton);
    ASSERT_TRUE(waitFor([&] { return trees()[0].place != from; }));
    EXPECT_NEAR(trees()[0].place.x - from.x, 10, 0.5);
    EXPECT_NEAR(trees()[0].place.y - from.y, 5, 0.5);
}

}  // namespace
}  // namespace noonmark
