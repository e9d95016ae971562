#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/review/glazing/glazing_panel.h"
#include "tests/gui/glazing_review_window.h"

namespace noonmark {
namespace {

using test::GlazingReviewWindow;
using test::waitFor;

TEST_F(GlazingReviewWindow, ARuleAboutWindowsAsksForWindowsInsteadOfPlaces) {
    EXPECT_TRUE(windows().applies());
    EXPECT_TRUE(form().isVisible());
    EXPECT_TRUE(state().contains(QStringLiteral("Design a tower"))) << state().toStdString();
    build();
    EXPECT_TRUE(state().contains(QStringLiteral("on the windows"))) << state().toStdString();
    choose("four-days");
    EXPECT_FALSE(form().isVisible());
}

TEST_F(GlazingReviewWindow, TheTableHasTheVerdictsOfTheReview) {
    build();
    run();
    const auto answer = windows().answer();
    ASSERT_TRUE(answer) << message().toStdString();
    const auto question = windows().question();
    ASSERT_TRUE(question);
    NoProgress progress;
    const auto expected = runGlazingReview(question->rule, *session().cityOf(existingCity).value(),
                                           *session().city(), question->settings, progress, {});
    ASSERT_TRUE(expected);
    ASSERT_GT(expected->windows.size(), 20U);
    GlazingTable& table = dock().glazingTable();
    ASSERT_EQ(std::size_t(table.topLevelItemCount()), expected->windows.size());
    const auto worst = sortWorstFirst(expected->windows);
    for (int row : {0, table.topLevelItemCount() - 1}) {
        const GlazingReview& review = *worst[std::size_t(row)];
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

TEST_F(GlazingReviewWindow, TakesTheBuildingThatIsSelectedInTheView) {
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

TEST_F(GlazingReviewWindow, SortsNumbersAsNumbers) {
    build();
    run();
    GlazingTable& table = dock().glazingTable();
    table.sortByColumn(3, Qt::DescendingOrder);
    int last = table.topLevelItem(0)->text(3).toInt();
    EXPECT_GE(last, 10) << "the new tower has more than nine floors";
    for (int row = 1; row < table.topLevelItemCount(); ++row) {
        const int floor = table.topLevelItem(row)->text(3).toInt();
        EXPECT_LE(floor, last);
        last = floor;
    }
}

TEST_F(GlazingReviewWindow, WritesTheFilesOfTheCommandLine) {
    build();
    run();
    save();
    const auto answer = windows().finished();
    ASSERT_TRUE(answer);
    const auto review = makeAnswer(std::make_shared<const GlazingAnswer>(**answer),
                                   std::make_shared<const ReviewSource>(window->review().source()));
    const auto written = review->write({}, folder.filePath(QStringLiteral("out")).toStdString(), {});
    ASSERT_TRUE(written) << written.error().text();
    EXPECT_EQ(written->size(), 4U);
    const QByteArray json = test::bytesOf(folder.filePath(QStringLiteral("out/review.json")));
    EXPECT_TRUE(json.contains("--facades-of all")) << json.left(600).toStdString();
    const QByteArray csv = test::bytesOf(folder.filePath(QStringLiteral("out/windows.csv")));
    EXPECT_EQ(csv.count('\n'), 1 + qsizetype(windows().answer()->study.windows.size()));
}

TEST_F(GlazingReviewWindow, StatesTheNumberOfWindowsAndTheTimeBeforehand) {
    build();
    auto* estimate = question().findChild<QLabel*>(QStringLiteral("reviewEstimate"));
    ASSERT_TRUE(waitFor([&] { return !estimate->text().isEmpty(); }));
    const QString words = estimate->text();
    EXPECT_TRUE(words.contains(QStringLiteral("about"))) << words.toStdString();
    run();
    EXPECT_TRUE(words.contains(formatCount(windows().answer()->study.panes.size()) + u' '))
        << words.toStdString();
}

TEST_F(GlazingReviewWindow, AFileThatIsMissingIsNamed) {
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

TEST(GlazingReviewChoice, ComesBackFromItsText) {
    ReviewChoice choice;
    choice.windows.places = ElementPlaces::windows;
    choice.windows.windows = "windows.gpkg";
    choice.windows.glazingFile.aboveGround = true;
    choice.windows.buildings = {"A", "B"};
    choice.windows.facades.storeyM = 3.2;
    EXPECT_EQ(parseReviewChoice(formatText(choice)), choice);
    choice.windows.facades.bayM = 1e9;
    EXPECT_EQ(parseReviewChoice(formatText(choice)).windows, ElementSettings{});
}

}  // namespace
}  // namespace noonmark
