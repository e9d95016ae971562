#include <gmock/gmock.h>

#include <QComboBox>
#include <QMenu>

#include "app/gui/docks/results/result_display.h"
#include "app/gui/session/answers/answer_viewer.h"
#include "app/gui/session/workbench.h"
#include "app/report/files/read_report.h"
#include "tests/gui/answers_window.h"
#include "tests/shared/toy_question.h"

// A question that nobody has written a line for outside its file is listed in the menu, asked, shown,
// exported, saved, marked as outdated, listed, shown again and printed by the window; by the command line,
// see tests/cli/question_commands_test.cpp.
namespace noonmark::test {
namespace {

using ::testing::HasSubstr;

struct ToyQuestion : AnswersWindow {
    void SetUp() override {
        AnswersWindow::SetUp();
        static const std::array questions{&toyQuestion()};
        workbench().setQuestions(questions);
        workbench().ask(toyQuestion());
        ASSERT_TRUE(waitFor([this] { return workbench().answerAs<Toy>() != nullptr; }));
    }
};

TEST_F(ToyQuestion, IsAskedFromTheMenu) {
    workbench().showStudyAgain();
    auto* menu = window->findChild<QMenu*>(QStringLiteral("questions"));
    ASSERT_NE(menu, nullptr);
    EXPECT_FALSE(menu->menuAction()->isVisible()) << "all shipped questions have a place of their own";
    Q_EMIT qobject_cast<QMenu*>(menu->parent())->aboutToShow();
    EXPECT_TRUE(menu->menuAction()->isVisible());
    ASSERT_EQ(menu->actions().size(), 1);
    EXPECT_EQ(menu->actions()[0]->text(), QStringLiteral("Toy"));
    menu->actions()[0]->trigger();
    EXPECT_TRUE(waitFor([this] { return workbench().answerAs<Toy>() != nullptr; }));
}

TEST_F(ToyQuestion, IsShownWithItsFigures) {
    const auto& rows = window->findChild<ResultsDock*>()->rows();
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows[0].name, QStringLiteral("Trees felled"));
    EXPECT_EQ(rows[0].meaning, QStringLiteral("By a toy"));
    EXPECT_EQ(rows[0].value.toInt(), int(session().city()->buildings.size()));
    const auto answer = workbench().answer();
    EXPECT_EQ(titleOf(*answer), QStringLiteral("Toy of Existing"));
}

TEST_F(ToyQuestion, IsExported) {
    EXPECT_EQ(workbench().filesOf({}), QStringList{QStringLiteral("toy.json")});
    const QString out = folder.filePath(QStringLiteral("out"));
    workbench().exportShown(out.toStdString(), {});
    ASSERT_TRUE(waitFor([this] { return !workbench().writing().busy(); }));
    QFile file(out + QStringLiteral("/toy.json"));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_THAT(file.readAll().toStdString(), HasSubstr("trees_felled"));
}

TEST_F(ToyQuestion, IsSaved) {
    keep("Felled");
    ASSERT_EQ(session().project().results.size(), 1U);
    EXPECT_EQ(session().project().results[0]->kind, "toy");
    EXPECT_THAT(session().project().results[0]->settings, HasSubstr("trees_felled"));
}

TEST_F(ToyQuestion, IsListedAndShownAgainWithItsFigures) {
    keep("Felled");
    auto* dock = window->findChild<ProjectDock*>();
    EXPECT_TRUE(dock->model().indexOf(ProjectPart::result, "Felled").isValid());
    showSaved("Felled");
    const auto lines = workbench().answer()->figures();
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_EQ(lines[0].value, double(session().city()->buildings.size()));
    const auto& rows = window->findChild<ResultsDock*>()->rows();
    EXPECT_EQ(rows[0].value, QStringLiteral("Felled"));
    EXPECT_EQ(rows.back().name, QStringLiteral("Trees felled"));
    const auto* list = window->findChild<QComboBox*>(QStringLiteral("answers"));
    ASSERT_NE(list, nullptr);
    EXPECT_TRUE(list->currentText().startsWith(QStringLiteral("Saved: Felled")))
        << "it states no hash of its buildings: " << list->currentText().toStdString();
}

TEST_F(ToyQuestion, IsExportedAndPrintedAfterItWasSaved) {
    keep("Felled");
    showSaved("Felled");
    const QString out = folder.filePath(QStringLiteral("out"));
    workbench().exportShown(out.toStdString(), {});
    ASSERT_TRUE(waitFor([this] { return !workbench().writing().busy(); }));
    QFile table(out + QStringLiteral("/figures.csv"));
    ASSERT_TRUE(table.open(QIODevice::ReadOnly));
    EXPECT_THAT(table.readAll().toStdString(), HasSubstr("trees_felled"));
    const auto words = readPrintedWords((out + QStringLiteral("/result.pdf")).toStdString());
    ASSERT_TRUE(words) << words.error().text();
    EXPECT_THAT(*words, HasSubstr("Trees felled"));
}

TEST_F(ToyQuestion, OfWhichTheListKnowsNothingCannotBeShownAgain) {
    keep("Felled");
    EXPECT_THAT(readSaved(session().project().results[0], session().project()).error().what,
                HasSubstr("results of the kind 'toy'"));
}

TEST_F(ToyQuestion, BecomesOutdatedWithSettingsAndBuildings) {
    StudySettings other = workbench().document().settings();
    other.receivers.cellM = 5;
    workbench().document().change(other, QStringLiteral("test"));
    EXPECT_THAT(note().toStdString(), HasSubstr("settings have changed"));
    enter(ProjectPart::scenario, "Tower");
    ASSERT_TRUE(waitFor([this] { return !workbench().following().busy(); }));
    EXPECT_EQ(workbench().answer(), nullptr);
    EXPECT_EQ(contentOf<Toy>(workbench().past())->scenario, existingCity);
    EXPECT_THAT(note().toStdString(), HasSubstr("buildings have changed"));
}

}  // namespace
}  // namespace noonmark::test
