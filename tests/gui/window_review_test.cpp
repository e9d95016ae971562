#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "app/gui/base/widgets/number_words.h"
#include "app/gui/docks/review/glazing/window_table.h"
#include "tests/gui/window_review_window.h"

namespace noonmark {
namespace {

using test::WindowReviewWindow;

TEST_F(WindowReviewWindow, ARuleAboutWindowsAsksForWindowsInsteadOfPlaces) {
    EXPECT_TRUE(windows().applies());
    EXPECT_TRUE(form().isVisible());
    EXPECT_TRUE(state().contains(QStringLiteral("Design a tower"))) << state().toStdString();
    build();
    EXPECT_TRUE(state().contains(QStringLiteral("on the windows"))) << state().toStdString();
    choose("four-days");
    EXPECT_FALSE(form().isVisible());
}

TEST_F(WindowReviewWindow, TheTableHasTheVerdictsOfTheReview) {
    build();
    run();
    const auto answer = windows().answer();
    ASSERT_TRUE(answer) << message().toStdString();
    const auto question = windows().question();
    ASSERT_TRUE(question);
    NoProgress progress;
    const auto expected = runWindowReview(question->rule, *session().cityOf(existingCity).value(),
                                          *session().city(), question->settings, progress, {});
    ASSERT_TRUE(expected);
    ASSERT_GT(expected->windows.size(), 20U);
    WindowTable& table = dock().windowTable();
    ASSERT_EQ(std::size_t(table.topLevelItemCount()), expected->windows.size());
    const auto worst = sortWorstFirst(expected->windows);
    for (int row : {0, table.topLevelItemCount() - 1}) {
        const WindowReview& review = *worst[std::size_t(row)];
        EXPECT_EQ(table.topLevelItem(row)->text(0).toStdString(), review.window.id);
        EXPECT_TRUE(
            table.topLevelItem(row)->text(2).endsWith(QString::fromUtf8(nameOf(review.verdict).data())));
    }
    EXPECT_EQ(table.text().count(u'\n'), table.topLevelItemCount());
    EXPECT_TRUE(windows().whyOutdated().isEmpty());
    form().findChild<QLineEdit*>(QStringLiteral("facadesOf"))->setText(QStringLiteral("New"));
    Q_EMIT form().findChild<QLineEdit*>(QStringLiteral("facadesOf"))->editingFinished();
    EXPECT_FALSE(windows().whyOutdated().isEmpty());
    run();
    EXPECT_LT(windows().answer()->study.windows.size(), expected->windows.size());
}

TEST_F(WindowReviewWindow, TakesTheBuildingThatIsSelectedInTheView) {
    auto* add = form().findChild<QPushButton*>(QStringLiteral("facadesOfSelected"));
    EXPECT_FALSE(add->isEnabled());
    window->tools().building().select(0U);
    ASSERT_TRUE(add->isEnabled());
    add->click();
    const std::string id = window->tools().building().id();
    EXPECT_EQ(window->review().choice().windows.buildings, std::vector<std::string>{id});
    add->click();
    EXPECT_TRUE(window->review().choice().windows.buildings.empty()) << "a second click takes it out";
}

TEST_F(WindowReviewWindow, SortsNumbersAsNumbers) {
    build();
    run();
    WindowTable& table = dock().windowTable();
    table.sortByColumn(3, Qt::DescendingOrder);
    int last = table.topLevelItem(0)->text(3).toInt();
    EXPECT_GE(last, 10) << "the new tower has more than nine floors";
    for (int row = 1; row < table.topLevelItemCount(); ++row) {
        const int floor = table.topLevelItem(row)->text(3).toInt();
        EXPECT_LE(floor, last);
        last = floor;
    }
}

TEST_F(WindowReviewWindow, WritesTheFilesOfTheCommandLine) {
    build();
    run();
    save();
    const auto answer = windows().finished();
    ASSERT_TRUE(answer);
    NoProgress progress;
    const auto written =
        writeWindowReview(**answer, window->review().source(), {},
                          folder.filePath(QStringLiteral("out")).toStdString(), false, progress, {});
    ASSERT_TRUE(written) << written.error().text();
    EXPECT_EQ(written->files.size(), 4U);
    const QByteArray json = test::bytesOf(folder.filePath(QStringLiteral("out/review.json")));
    EXPECT_TRUE(json.contains("--facades-of all")) << json.left(600).toStdString();
    const QByteArray csv = test::bytesOf(folder.filePath(QStringLiteral("out/windows.csv")));
    EXPECT_EQ(csv.count('\n'), 1 + qsizetype(windows().answer()->study.windows.size()));
}

TEST_F(WindowReviewWindow, StatesTheNumberOfWindowsAndTheTimeBeforehand) {
    build();
    auto* estimate = dock().findChild<QLabel*>(QStringLiteral("reviewEstimate"));
    ASSERT_TRUE(waitFor([&] { return !estimate->text().isEmpty(); }));
    const QString words = estimate->text();
    EXPECT_TRUE(words.contains(QStringLiteral("about"))) << words.toStdString();
    run();
    EXPECT_TRUE(words.startsWith(formatCount(windows().answer()->study.panes.size()))) << words.toStdString();
}

TEST_F(WindowReviewWindow, AFileThatIsMissingIsNamed) {
    build();
    auto* source = form().findChild<QComboBox*>(QStringLiteral("windowSource"));
    source->setCurrentIndex(1);
    Q_EMIT source->activated(1);
    EXPECT_TRUE(state().contains(QStringLiteral("No file of windows"))) << state().toStdString();
    auto* file = form().findChild<QLineEdit*>(QStringLiteral("windowsFile"));
    file->setText(QStringLiteral("no such file.gpkg"));
    Q_EMIT file->editingFinished();
    run();
    EXPECT_TRUE(message().contains(QStringLiteral("no such file.gpkg"))) << message().toStdString();
}

TEST(WindowReviewChoice, ComesBackFromItsText) {
    ReviewChoice choice;
    choice.windows.places = ElementPlaces::windows;
    choice.windows.windows = "windows.gpkg";
    choice.windows.windowFile.aboveGround = true;
    choice.windows.buildings = {"A", "B"};
    choice.windows.facades.storeyM = 3.2;
    EXPECT_EQ(parseReviewChoice(formatText(choice)), choice);
    choice.windows.facades.bayM = 1e9;
    EXPECT_EQ(parseReviewChoice(formatText(choice)).windows, ElementSettings{});
}

}  // namespace
}  // namespace noonmark
