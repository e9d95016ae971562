#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>
#include <algorithm>

#include "app/gui/tools/editing/tree_editing.h"
#include "render/scene/crown_bodies.h"
#include "scenarios/edits/tree_edits.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::smallProject;
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
        EXPECT_TRUE(field<QPushButton>("plantTree").isChecked()) << "pressed again, the tool goes on";
        Q_EMIT window->panel().keyPressed(Qt::Key_Escape);
        EXPECT_FALSE(field<QPushButton>("plantTree").isChecked());
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

// What is no day of the year stays to be mended, and no tree is planted without it.
TEST_F(TreeWindow, ALeafDayThatIsNoneIsRefusedAndStays) {
    auto& day = field<QLineEdit>("leafOn");
    QTest::keyClicks(&day, QStringLiteral("5-10"));
    Q_EMIT day.editingFinished();
    field<QPushButton>("plantTree").click();
    click({-40, -40});
    EXPECT_EQ(day.text(), QStringLiteral("5-10"));
    EXPECT_TRUE(window->panel().messages().text().contains(QStringLiteral("day of the year")))
        << window->panel().messages().text().toStdString();
    EXPECT_TRUE(trees().empty());
    day.setText(QStringLiteral("05-10"));
    click({-40, -40});
    ASSERT_TRUE(waitFor([&] { return trees().size() == 1; }));
    EXPECT_EQ(trees()[0].leafOnDay, parseDayOfYear("05-10").value());
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

/// A study of the city with a tree, and a place.
struct LiveTreeWindow : TreeWindow {
    void SetUp() override {
        TreeWindow::SetUp();
        Project next = session().project();
        next.places.push_back({"Lawn", PlaceKind::park, {test::square({-60, 10}, 40)}, "drawn"});
        ASSERT_TRUE(session().change(std::move(next), QStringLiteral("places")));
        StudySettings question = workbench().document().settings();
        question.receivers.cellM = 4;
        question.period.stepMinutes = 10;
        question.region = session().project().regions[0];
        workbench().document().change(question, QStringLiteral("test"));
    }
    void measure() {
        workbench().run();
        ASSERT_TRUE(waitFor([this] { return workbench().study() != nullptr; }));
        QCoreApplication::processEvents();
    }
    QTableWidget& figures() { return field<QTableWidget>("treeFigures"); }
    QString text(int row, int column) { return figures().item(row, column)->text(); }
    void send(QEvent::Type type, glm::dvec2 ground, double z, Qt::MouseButtons buttons) {
        CityView& view = window->panel().view();
        const auto pixel = pixelOf(view.pose(), view.lens(), {ground, z});
        const QPointF at(pixel->x, pixel->y);
        QMouseEvent event(type, at, at, Qt::LeftButton, buttons, Qt::NoModifier);
        QCoreApplication::sendEvent(&view, &event);
    }
};

TEST_F(LiveTreeWindow, FiguresFollowADraggedTree) {
    plant({{-40, -40}});
    measure();
    EXPECT_TRUE(figures().isHidden());
    click({-40, -40}, 5);
    send(QEvent::MouseButtonPress, {-40, -40}, 0, Qt::LeftButton);
    send(QEvent::MouseMove, {-40, 0}, 0, Qt::LeftButton);
    send(QEvent::MouseMove, {-40, 25}, 0, Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return !figures().isHidden() && figures().rowCount() == 2; }));
    EXPECT_EQ(text(1, 0), QStringLiteral("Lawn"));
    EXPECT_TRUE(text(1, 2).startsWith(u'+')) << text(1, 2).toStdString();
    send(QEvent::MouseButtonRelease, {-40, 25}, 0, Qt::NoButton);
    EXPECT_TRUE(figures().isHidden()) << "the study is no longer that of the city";
    ASSERT_TRUE(waitFor([&] { return trees()[0].place.y > 20; }));
}

TEST_F(LiveTreeWindow, FiguresFollowATreeThatIsToBePlanted) {
    measure();
    field<QPushButton>("plantTree").click();
    const auto hover = [&](glm::dvec2 ground) {
        const CityView& view = window->panel().view();
        const auto pixel = pixelOf(view.pose(), view.lens(), {ground, 0});
        window->tools().trees().hover({pixel->x, pixel->y});
    };
    hover({-40, 25});
    ASSERT_TRUE(waitFor([&] { return figures().rowCount() == 2 && text(1, 2).startsWith(u'+'); }));
    hover({60, -60});
    ASSERT_TRUE(waitFor([&] { return figures().rowCount() == 1; })) << "the lawn keeps its sun";
    Q_EMIT window->panel().keyPressed(Qt::Key_Escape);
    EXPECT_TRUE(figures().isHidden());
    EXPECT_TRUE(trees().empty());
}

/// The small project and files of trees in its city.
struct TreeFiles : TreeWindow {
    QString write(const char* name, const QByteArray& text) {
        const QString path = folder.filePath(QString::fromLatin1(name));
        QFile written(path);
        EXPECT_TRUE(written.open(QIODevice::WriteOnly));
        written.write(text);
        return path;
    }
    QString inventory() {
        QByteArray rows = "species,Hoehe,tree_dbh,latitude,longitude\n";
        for (int i = 0; i < 5; ++i) rows += "Tilia cordata,40,10,40.76" + QByteArray::number(i) + ",-73.98\n";
        return write("trees.csv", rows);
    }
    TreeImportDialog* dialog() { return window->findChild<TreeImportDialog*>(); }
    QString outcome() { return dialog()->findChild<QLabel*>(QStringLiteral("treeOutcome"))->text(); }
    bool isRead() {
        return dialog() != nullptr &&
               dialog()->findChild<QPushButton*>(QStringLiteral("addTrees"))->isEnabled();
    }
    void choose(const char* list, const QString& text) {
        auto& box = *dialog()->findChild<QComboBox*>(QString::fromLatin1(list));
        box.setCurrentIndex(box.findText(text, Qt::MatchStartsWith));
    }
    void accept() {
        dialog()->findChild<QPushButton*>(QStringLiteral("addTrees"))->click();
        ASSERT_TRUE(waitFor([&] { return !trees().empty(); })) << message().toStdString();
    }
};

TEST_F(TreeFiles, AnInventoryIsAddedWithItsFieldsAndUndone) {
    window->places().addFiles({inventory()});
    ASSERT_TRUE(waitFor([&] { return isRead(); })) << message().toStdString();
    EXPECT_TRUE(outcome().contains(QStringLiteral("40"))) << outcome().toStdString();
    EXPECT_TRUE(outcome().contains(QStringLiteral("5 measured"))) << outcome().toStdString();
    accept();
    ASSERT_EQ(trees().size(), 5U);
    EXPECT_EQ(trees()[0].heightM, 40);
    EXPECT_NEAR(trees()[0].crownDiameterM, 10 * 0.0254 * 25.5, 1e-4);
    EXPECT_EQ(session().scenario(), existingCity) << "they are there already";
    EXPECT_EQ(session().project().inputs.size(), smallProject().inputs.size() + 1);
    workbench().document().undoStack().undo();
    ASSERT_TRUE(waitFor([&] { return trees().empty(); }));
    workbench().document().undoStack().redo();
    ASSERT_TRUE(waitFor([&] { return trees().size() == 5; }));
    save();
    makeWindow();
    open(file);
    EXPECT_EQ(trees().size(), 5U) << "saved with the project";
    EXPECT_EQ(trees()[0].heightM, 40);
}

TEST_F(TreeFiles, FieldsAndUnitsCanBeChosen) {
    window->places().takeDropped({inventory()});
    ASSERT_TRUE(waitFor([&] { return isRead(); })) << message().toStdString();
    const auto says = [&](const char* text) {
        return isRead() && outcome().contains(QString::fromLatin1(text));
    };
    choose("treeUnit-height", QStringLiteral("ft"));
    ASSERT_TRUE(waitFor([&] { return says("12.2"); })) << outcome().toStdString();
    choose("treeField-stem", QStringLiteral("None"));
    ASSERT_TRUE(waitFor([&] { return says("8.7"); })) << outcome().toStdString();
    EXPECT_EQ(dialog()->reading().fields.size(), 2U);
    accept();
    EXPECT_NEAR(trees()[0].heightM, 40 * 0.3048, 1e-4);
    EXPECT_NEAR(trees()[0].crownDiameterM, 40 * 0.3048 / 1.4, 1e-4) << "of the height";
}

TEST_F(TreeFiles, FilesWithoutTreesAreRefused) {
    window->trees().ask(write("table.csv", "a,b\n1,2\n"));
    ASSERT_TRUE(waitFor([&] { return dialog() != nullptr || !message().isEmpty(); }));
    if (dialog() != nullptr) {
        ASSERT_TRUE(waitFor([&] { return outcome().contains(QStringLiteral("no trees")); }))
            << outcome().toStdString();
    }
    EXPECT_FALSE(isRead());
}

}  // namespace
}  // namespace noonmark
