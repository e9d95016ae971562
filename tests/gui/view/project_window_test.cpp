#include <gtest/gtest.h>

#include <QFile>
#include <QSignalSpy>

#include "app/gui/view/panel/view_panel.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::bytesOf;
using test::ProjectWindow;
using test::waitFor;

TEST_F(ProjectWindow, EditsAreShownSavedAndFoundAgain) {
    const CameraPose pose{{3, 4, 0}, 321, 40, 50};
    window->panel().view().setPose(pose);
    build();
    EXPECT_EQ(window->panel().view().pose(), pose) << "the camera stays";
    EXPECT_TRUE(window->isWindowModified());
    save();
    EXPECT_FALSE(window->isWindowModified());
    EXPECT_TRUE(window->windowTitle().startsWith(QStringLiteral("small[*]")));
    makeWindow();
    open(file);
    EXPECT_EQ(session().scenario(), "Proposal A");
    EXPECT_EQ(workbench().city()->city().buildings.size(), 4U);
    EXPECT_EQ(window->panel().view().pose(), pose);
    EXPECT_FALSE(session().hasUnsavedWork());
}

TEST_F(ProjectWindow, TheQuestionIsFoundAgain) {
    StudySettings question = workbench().document().settings();
    question.receivers.cellM = 5;
    question.region = session().project().regions[0];
    question.period.window =
        SolarHours{std::chrono::minutes(90), std::chrono::minutes(30), SunriseRule::centre};
    question.period.zone = "America/New_York";
    workbench().document().change(question, QStringLiteral("test"));
    EXPECT_TRUE(session().hasUnsavedWork()) << "the project has a file, which stores the settings";
    save();
    makeWindow();
    open(file);
    EXPECT_EQ(workbench().document().settings(), question);
}

TEST_F(ProjectWindow, SavedStateIsReachedByUndo) {
    build();
    save();
    workbench().document().undoStack().undo();
    EXPECT_TRUE(session().hasUnsavedWork());
    workbench().document().undoStack().redo();
    EXPECT_FALSE(session().hasUnsavedWork());
    save();
    EXPECT_EQ(ProjectFile::open(file.toStdString()).value().saves(), 3);
}

TEST_F(ProjectWindow, ADamagedFileIsReportedAndLeftAsItIs) {
    const QString damaged = folder.filePath(QStringLiteral("damaged.noonmark.gpkg"));
    const QByteArray half = bytesOf(file).left(5000);
    QFile out(damaged);
    ASSERT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(half);
    out.close();
    const auto city = workbench().city();
    window->open({damaged});
    ASSERT_TRUE(waitFor([this] { return !message().isEmpty(); }));
    EXPECT_TRUE(message().contains(QStringLiteral("damaged.noonmark.gpkg"))) << message().toStdString();
    EXPECT_EQ(workbench().city(), city);
    EXPECT_EQ(bytesOf(damaged), half);
}

TEST_F(ProjectWindow, ASaveOverSomeoneElsesIsRefusedAndOffersAnotherName) {
    build();
    auto other = ProjectFile::open(file.toStdString()).value();
    Project theirs = other.project();
    theirs.lots.clear();
    ASSERT_TRUE(other.save(theirs));
    save();
    EXPECT_TRUE(message().contains(QStringLiteral("someone else"))) << message().toStdString();
    EXPECT_TRUE(session().hasUnsavedWork());
    EXPECT_TRUE(ProjectFile::open(file.toStdString()).value().project().lots.empty());
}

TEST_F(ProjectWindow, ACityBecomesAProjectOfItsOwn) {
    open(QStringLiteral("sample:central-park-south"));
    EXPECT_FALSE(session().file());
    EXPECT_FALSE(session().hasUnsavedWork());
    EXPECT_GE(session().project().lots.size(), 7U);
    EXPECT_EQ(session().project().regions.size(), 1U);
    const QString name = folder.filePath(QStringLiteral("park.noonmark.gpkg"));
    window->saving().saveTo(name.toStdString());
    ASSERT_TRUE(waitFor([this] { return session().file().has_value(); }));
    EXPECT_EQ(ProjectFile::open(name.toStdString()).value().project().city->buildings.size(),
              session().project().city->buildings.size());
}

TEST_F(ProjectWindow, ASaveThatEndsAfterAnotherWasOpenedIsNotTakenForThatOnes) {
    const QString other = folder.filePath(QStringLiteral("other.noonmark.gpkg"));
    ASSERT_TRUE(ProjectFile::create(other.toStdString(), test::smallProject()));
    build();
    const QSignalSpy saved(&window->saving(), &SavingActions::saved);
    // The save starts just before the other project is taken and ends after it.
    QObject::connect(&workbench().opening(), &JobSlot::ended, window.get(),
                     [this] { window->saving().save(); });
    workbench().open({other});
    ASSERT_TRUE(waitFor([&] { return session().file()->path() == other.toStdString(); }));
    ASSERT_TRUE(waitFor([this] {
        const auto written = ProjectFile::open(file.toStdString());
        return written && written->saves() == 2;
    })) << "the save is still written";
    save();
    EXPECT_EQ(session().file()->path(), other.toStdString());
    EXPECT_EQ(saved.count(), 1) << "of the other";
    EXPECT_FALSE(session().hasUnsavedWork());
}

TEST_F(ProjectWindow, ADrawnRegionGoesIntoTheProjectInOneStepOfUndo) {
    const StudySettings before = workbench().document().settings();
    PolygonTool& tool = window->panel().regionTool();
    tool.begin();
    for (const glm::dvec3 corner : {glm::dvec3{0, 0, 0}, {100, 0, 0}, {100, 80, 0}}) tool.addPoint(corner);
    tool.finish();
    ASSERT_EQ(session().project().regions.size(), 2U);
    const Region drawn = session().project().regions[1];
    EXPECT_EQ(drawn.name, "Region");
    EXPECT_EQ(bounds(drawn), (Box2{{0, 0}, {100, 80}}));
    EXPECT_EQ(workbench().document().settings().region, drawn);
    EXPECT_TRUE(session().hasUnsavedWork());
    workbench().document().undoStack().undo();
    EXPECT_EQ(session().project().regions.size(), 1U);
    EXPECT_EQ(workbench().document().settings(), before);
    EXPECT_FALSE(session().hasUnsavedWork());
}

TEST_F(ProjectWindow, AnOpenedScenarioKnowsWhatItDemolishesAtOnce) {
    Project project = test::smallProject();
    project.scenarios.push_back({.name = "Without", .base = {}, .edits = {Demolish{test::idOf(project, 2)}}});
    project.view["scenario"] = "Without";
    const QString other = folder.filePath(QStringLiteral("without.noonmark.gpkg"));
    ASSERT_TRUE(ProjectFile::create(other.toStdString(), project));
    open(other);
    const OpenCity& shown = *workbench().city();
    ASSERT_EQ(shown.city().buildings.size(), 2U);
    const ArrayDifference changes = computeDifference(*shown.arrays, shown.city());
    ASSERT_EQ(changes.removed.size(), 1U) << "its outline is drawn";
    EXPECT_EQ(shown.arrays->buildings[changes.removed[0]]->sourceId, test::idOf(project, 2));
}

}  // namespace
}  // namespace noonmark
