#include <gtest/gtest.h>

#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QTableWidget>
#include <QTemporaryDir>

#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/point/point_dock.h"
#include "app/gui/docks/point/point_inspector.h"
#include "app/gui/tools/editing/edit_tools.h"
#include "app/gui/view/time/time_strip.h"
#include "core/city/trees/tree_facts.h"
#include "scenarios/edits/tree_edits.h"
#include "tests/gui/project_window.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::ProjectWindow;
using test::waitFor;

TEST(PickedPoint, AWallIsLookedAtFromOutside) {
    Pick pick{{10, 0, 8}, 0U, {1, 0, 0}};
    const PointQuestion wall = questionAt(City{}, pick);
    ASSERT_TRUE(wall.facingDeg);
    EXPECT_NEAR(*wall.facingDeg, 90, 1e-3);
    EXPECT_NEAR(wall.heightM.value_or(0), 8, 1e-6);
    EXPECT_NEAR(City{}.frame.localFromLonLat(wall.at).x, 10.02, 1e-4);
    pick.normal = {0, 0, 1};
    EXPECT_FALSE(questionAt(City{}, pick).facingDeg);
    pick.building.reset();
    EXPECT_FALSE(questionAt(City{}, pick).heightM);
}

TEST_F(ProjectWindow, APointShowsItsSunAndFollowsTheDay) {
    PointInspector& points = window->points();
    // The south-western corner of the city, in front of everything.
    const Box2 box = bounds(workbench().city()->city());
    points.inspect({{box.low.x - 5, box.low.y - 5, 0}, {}, {0, 0, 1}});
    ASSERT_TRUE(waitFor([&] { return points.answer() != nullptr; }, 20'000));
    const auto first = points.answer();
    EXPECT_FALSE(first->sentence.isEmpty());
    EXPECT_GT(first->study.possibleMin, 200'000);  // half of a year's minutes
    ShownTime look = window->panel().time().look();
    look.date = look.date.year() / std::chrono::December / 21;
    window->panel().time().setLook(look);
    Q_EMIT window->panel().time().lookChanged(look);
    ASSERT_TRUE(waitFor([&] { return points.answer() && points.answer() != first; }, 20'000));
    EXPECT_EQ(points.answer()->study.question.day, look.date);
}

TEST_F(ProjectWindow, APinMarksThePointWhileItsAnswerIsVisible) {
    PointInspector& points = window->points();
    OverlayBodies& overlay = window->panel().view().overlay();
    EXPECT_FALSE(overlay.pin());
    points.setVisible(true);
    points.inspect({{3, 4, 0}, {}, {0, 0, 1}});
    ASSERT_TRUE(overlay.pin());
    EXPECT_EQ(*overlay.pin(), glm::dvec3(3, 4, 0));
    points.setVisible(false);
    EXPECT_FALSE(overlay.pin());
    points.setVisible(true);
    EXPECT_TRUE(overlay.pin());
    points.forget();
    EXPECT_FALSE(overlay.pin());
}

TEST_F(ProjectWindow, APointIsComparedInAnyTwoScenarios) {
    build();
    PointInspector& points = window->points();
    const Box2 box = bounds(workbench().city()->city());
    points.inspect({{box.low.x - 5, box.high.y + 5, 0}, {}, {0, 0, 1}});
    ASSERT_TRUE(waitFor([&] { return points.answer() != nullptr; }, 20'000));
    EXPECT_EQ(points.answer()->from, existingCity);
    ASSERT_EQ(points.answer()->cases.size(), 2U);
    EXPECT_GE(points.answer()->cases[0].yearMin, points.answer()->cases[1].yearMin);
    auto* table = window->findChild<QTableWidget*>(QStringLiteral("pointScenarios"));
    ASSERT_EQ(table->rowCount(), 2);
    EXPECT_EQ(table->item(0, 0)->text(), QString::fromLatin1(existingCity));
    // The other way round.
    const auto before = points.answer();
    auto& from = *window->findChild<QComboBox*>(QStringLiteral("pointFrom"));
    auto& to = *window->findChild<QComboBox*>(QStringLiteral("pointTo"));
    ASSERT_EQ(from.count(), 3);
    from.setCurrentIndex(2);
    to.setCurrentIndex(1);
    Q_EMIT to.activated(1);
    window->findChild<PointDock*>()->window()->show();
    points.setVisible(true);
    ASSERT_TRUE(waitFor([&] { return points.answer() && points.answer() != before; }, 20'000));
    EXPECT_EQ(points.answer()->to, existingCity);
    EXPECT_EQ(points.answer()->from, workbench().session().project().scenarios[0].name);
    ASSERT_TRUE(points.answer()->study.scenario);
    EXPECT_LE(points.answer()->study.scenario->year.grossMin, points.answer()->study.baseline.year.grossMin);
}

// A scenario plants an evergreen beside the point; without it the lines with trees are those without.
TEST_F(ProjectWindow, ScenariosOfAPointHaveLinesWithTrees) {
    const Box2 box = bounds(workbench().city()->city());
    const glm::dvec2 at(box.low.x - 5, box.low.y - 30);
    const auto tree = designTree({.species = "Pinus", .heightM = 14, .crownDiameterM = 10});
    ASSERT_TRUE(tree);
    ASSERT_TRUE(session().addEdits(makePlantings(workbench().city()->city(), *tree, {at + glm::dvec2(0, -8)}),
                                   QStringLiteral("plant")));
    ASSERT_TRUE(waitFor([&] { return workbench().city()->city().trees != nullptr; }));
    PointInspector& points = window->points();
    points.inspect({{at.x, at.y, 0}, {}, {0, 0, 1}});
    ASSERT_TRUE(waitFor([&] { return points.answer() != nullptr; }, 20'000));
    auto* table = window->findChild<QTableWidget*>(QStringLiteral("pointScenarios"));
    ASSERT_EQ(table->rowCount(), 4) << "the existing city has no tree";
    const auto text = [&](int row, int column) { return table->item(row, column)->text(); };
    EXPECT_EQ(text(2, 0).trimmed(), QStringLiteral("trees as evergreens"));
    EXPECT_EQ(text(3, 0).trimmed(), QStringLiteral("trees with their seasons"));
    EXPECT_EQ(text(1, 2), text(0, 2)) << "nor has the scenario a new building";
    const double without = points.answer()->cases[1].yearMin;
    const double with = points.answer()->cases[1].withTrees.at(0).yearMin;
    EXPECT_LT(with, without - 60);
    EXPECT_EQ(text(2, 3), withPlus((with - without) / 60, groupDigits((with - without) / 60, 1)));
    EXPECT_TRUE(points.answer()->drawing.contains("(trees with their seasons)")) << "a carpet of its own";

    const QString figures = window->findChild<QLabel*>(QStringLiteral("pointFigures"))->text();
    EXPECT_EQ(figures.count(QStringLiteral("trees as evergreens:")), 1) << figures.toStdString();
    EXPECT_EQ(figures.count(QStringLiteral("trees with their seasons:")), 1);

    auto* taken = window->findChild<QLabel*>(QStringLiteral("takenByTrees"));
    EXPECT_TRUE(taken->text().contains(QStringLiteral("Pinus"))) << taken->text().toStdString();
    Q_EMIT taken->linkActivated(QStringLiteral("planted 1"));
    EXPECT_TRUE(window->tools().trees().chosenIds().contains("planted 1"));
}

TEST_F(ProjectWindow, APointIsSavedAsDrawingPictureAndTable) {
    const Box2 box = bounds(workbench().city()->city());
    window->points().inspect({{box.low.x - 5, box.low.y - 5, 0}, {}, {0, 0, 1}});
    ASSERT_TRUE(waitFor([&] { return window->points().answer() != nullptr; }, 20'000));
    auto* dock = window->findChild<PointDock*>();
    ASSERT_NE(dock, nullptr);
    const QTemporaryDir folder;
    const QByteArrayList beginnings{"<svg", "\x89PNG", "month,hour"};
    const QStringList names{QStringLiteral("a.svg"), QStringLiteral("a.png"), QStringLiteral("a.csv")};
    for (int i = 0; i < names.size(); ++i) {
        const QString file = folder.filePath(names[i]);
        ASSERT_TRUE(dock->save(file, workbench().exportRules()));
        QFile written(file);
        ASSERT_TRUE(written.open(QIODevice::ReadOnly));
        EXPECT_TRUE(written.readAll().startsWith(beginnings[i])) << names[i].toStdString();
    }
}

}  // namespace
}  // namespace noonmark
