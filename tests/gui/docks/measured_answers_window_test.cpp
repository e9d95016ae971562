#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDockWidget>
#include <QPushButton>

#include "app/gui/docks/results/results_dock.h"
#include "app/gui/docks/study_form/study_dock.h"
#include "app/gui/view/compare/compare_actions.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/gui/view/time/time_strip.h"
#include "tests/gui/answers_window.h"

namespace noonmark {
namespace {

using test::waitFor;

struct MeasuredAnswersWindow : test::AnswersWindow {};

// What was measured is there again after the project was saved and opened, without being saved by name.
TEST_F(MeasuredAnswersWindow, MeasuredAnswersAreThereAgainTomorrow) {
    study();
    EXPECT_TRUE(session().hasUnsavedWork());
    const QString area = figures()[figures().indexOf(QStringLiteral("Shadow area")) + 1];
    session().goTo("Tower");
    workbench().runScore("default");
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ScoreAnswer>() != nullptr; }));
    saveAndOpenAgain();
    EXPECT_TRUE(session().project().results.empty()) << "they are no results saved under a name";
    EXPECT_FALSE(session().hasUnsavedWork());
    ASSERT_GE(workbench().measured().size(), 2U);
    auto* list = window->findChild<QComboBox*>(QStringLiteral("answers"));
    const int at = list->findText(QStringLiteral("Study of %1").arg(QString::fromStdString(existingCity)),
                                  Qt::MatchStartsWith);
    ASSERT_GE(at, 0);
    Q_EMIT list->activated(at);
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<SavedContent>() != nullptr; }));
    EXPECT_TRUE(figures().contains(area));
    EXPECT_EQ(list->currentIndex(), at);
}

TEST_F(MeasuredAnswersWindow, MeasuredAnswersOfOtherBuildingsAreMarkedTomorrow) {
    session().goTo("Tower");
    study();
    window->mode().setMode(ViewMode::exploration);  // nothing is computed automatically
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 20}}, QStringLiteral("lower")));
    saveAndOpenAgain();
    auto* list = window->findChild<QComboBox*>(QStringLiteral("answers"));
    EXPECT_TRUE(waitFor([&] {
        return list->findText(QStringLiteral("Study of Tower"), Qt::MatchStartsWith) >= 0 &&
               list->itemText(list->findText(QStringLiteral("Study of Tower"), Qt::MatchStartsWith))
                   .contains(QStringLiteral("outdated"));
    }));
}

TEST_F(MeasuredAnswersWindow, TheQuestionAskedLastIsThereAgain) {
    auto& form = *window->findChild<StudyDock*>();
    form.choose(StudyKind::places);
    window->saving().save();
    ASSERT_TRUE(waitFor([this] { return !window->saving().writing().busy(); }));
    form.choose(StudyKind::shadow);
    const auto before = workbench().city();
    window->open({QString::fromStdString(session().file()->path().string())});
    ASSERT_TRUE(waitFor([&] { return !workbench().opening().busy() && workbench().city() != before; }));
    EXPECT_EQ(form.kind(), StudyKind::places);
    EXPECT_EQ(workbench().document().settings().period.days, 365) << "of the whole year, as it was asked";
}

// A panel that was closed opens for what the user asks, not for what is computed again by itself.
TEST_F(MeasuredAnswersWindow, ResultsOpenForEveryRunOfTheUser) {
    auto* results = window->findChild<QDockWidget*>(QStringLiteral("resultsDock"));
    study();
    EXPECT_FALSE(results->isHidden());
    results->hide();
    session().goTo("Tower");
    ASSERT_TRUE(waitFor([this] {
        return !workbench().following().busy() && !workbench().running().busy() && workbench().study();
    })) << "a quick study is repeated";
    EXPECT_TRUE(results->isHidden());
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return !workbench().running().busy(); }));
    EXPECT_FALSE(results->isHidden());
}

TEST_F(MeasuredAnswersWindow, TheSameQuestionIsListedOnce) {
    study();
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return !workbench().running().busy(); }));
    EXPECT_EQ(workbench().measured().size(), 1U);
    StudySettings other = workbench().document().settings();
    other.period.days = 10;
    workbench().document().change(other, QStringLiteral("days"));
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return !workbench().running().busy(); }));
    ASSERT_EQ(workbench().measured().size(), 2U);
    EXPECT_NE(workbench().measured()[0]->name(), workbench().measured()[1]->name());
}

TEST_F(MeasuredAnswersWindow, AScoreByAnotherWeightTableReplacesNone) {
    Project next = session().project();
    next.weights.push_back(makeMonthlyWeights());
    next.weights.back().name = "other";
    ASSERT_TRUE(session().change(std::move(next), QStringLiteral("weights")));
    const auto score = [this](const char* weights) {
        workbench().runScore(weights);
        ASSERT_TRUE(waitFor([&] {
            const auto answer = workbench().answerAs<ScoreAnswer>();
            return answer && answer->weights.name == weights;
        }));
    };
    score("default");
    saveAndOpenAgain();
    const std::size_t before = workbench().measured().size();
    score("other");
    EXPECT_EQ(workbench().measured().size(), before + 1);
    score("default");
    EXPECT_EQ(workbench().measured().size(), before + 1) << "the same question as in the file";
}

TEST_F(MeasuredAnswersWindow, TwoScenariosAndTheMomentOfTheClockAreThereAgain) {
    session().goTo("Tower");
    ASSERT_TRUE(waitFor([this] { return !workbench().following().busy(); }));
    CompareActions& comparing = window->comparing();
    comparing.findChild<QAction*>(QStringLiteral("compareBeside"))->trigger();
    const auto isBeside = [this] { return window->panel().view().sides().layout == SideLayout::beside; };
    ASSERT_TRUE(waitFor(isBeside));
    const int year = int(window->panel().time().look().date.year());
    const ShownTime noon{ShownSpan::moment,
                         {std::chrono::year(year), std::chrono::December, std::chrono::day(21)},
                         std::chrono::minutes(12 * 60 + 30)};
    window->panel().time().choose(noon);
    saveAndOpenAgain();
    EXPECT_TRUE(waitFor(isBeside));
    EXPECT_EQ(comparing.choice(), "compareBeside Existing");
    EXPECT_EQ(window->panel().time().look(), noon);
}

// While exploring no result is shown: what was measured is offered, so that it is not missed.
TEST_F(MeasuredAnswersWindow, WhatWasMeasuredIsOfferedWhereTheProjectOpensInNow) {
    study();
    window->mode().setMode(ViewMode::exploration);
    saveAndOpenAgain();
    EXPECT_FALSE(workbench().answer());
    MessageBar& bar = window->panel().messages();
    EXPECT_TRUE(bar.text().contains(QStringLiteral("Study of"))) << bar.text().toStdString();
    auto* show = bar.findChild<QPushButton*>(QStringLiteral("remedy"));
    ASSERT_TRUE(show && !show->isHidden());
    show->click();
    EXPECT_TRUE(waitFor([this] { return workbench().answerAs<SavedContent>() != nullptr; }));
}

// Chosen from the list, an answer is shown: nothing is computed, and what is being computed goes on.
TEST_F(MeasuredAnswersWindow, ShowingAComparisonFromTheListStartsNoRun) {
    session().goTo("Tower");
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ImpactAnswer>() != nullptr; }));
    const auto comparison = workbench().measured().back();
    session().compareWith({});
    int runs = 0;
    QObject::connect(&workbench().running(), &JobSlot::started, &workbench(), [&] { ++runs; });
    workbench().showMeasured(*comparison);
    EXPECT_EQ(session().baseline(), existingCity);
    ASSERT_TRUE(workbench().answerAs<ImpactAnswer>());
    EXPECT_EQ(runs, 0);
    EXPECT_FALSE(workbench().running().busy());
}

// A copy of the scenario is displayed when the answer arrives: the answer is about the one that was asked.
TEST_F(MeasuredAnswersWindow, AScenarioCopiedWhileItIsMeasuredLeavesTheAnswerItsName) {
    session().goTo("Tower");
    workbench().run();
    auto* tree = window->findChild<ProjectDock*>();
    tree->duplicate(tree->model().indexOf(ProjectPart::scenario, "Tower"));
    const std::string copy = session().scenario();
    ASSERT_NE(copy, "Tower");
    ASSERT_TRUE(waitFor([this] { return !workbench().running().busy() && !workbench().measured().empty(); }));
    EXPECT_EQ(workbench().measured().back()->known().answer->part().scenario, "Tower");
    EXPECT_THAT(workbench().measured().back()->name(), testing::HasSubstr("Tower,"));
    ASSERT_TRUE(workbench().study()) << "it is valid for the copy, too";
    EXPECT_EQ(workbench().answer()->part().scenario, copy);
    EXPECT_EQ(workbench().measuredShown(), workbench().measured().back()) << "the list marks it";
    session().goTo("Tower");
    EXPECT_EQ(workbench().answer()->part().scenario, "Tower");
    EXPECT_EQ(workbench().measured().size(), 1U);
}

// Its name is one of the file's own: what is saved under it replaces the answer kept without being asked.
TEST_F(MeasuredAnswersWindow, WhatIsSavedUnderANameIsInTheFileOnce) {
    study();
    keep("June");
    EXPECT_TRUE(workbench().measured().empty());
    workbench().document().undoStack().undo();
    EXPECT_EQ(workbench().measured().size(), 1U) << "saving it was undone";
    workbench().document().undoStack().redo();
    saveAndOpenAgain();
    const Project file = ProjectFile::open(session().file()->path()).value().project();
    EXPECT_EQ(
        std::ranges::count(file.results, std::string("June"), [](const auto& one) { return one->name; }), 1);
}

// What was shown is seen on after a change of the buildings, as of before it, and is valid again after undo.
TEST_F(MeasuredAnswersWindow, ASavedAnswerIsGreyAfterAnEditAndValidAgainAfterItsUndo) {
    session().goTo("Tower");
    study();
    keep("June");
    const QString area = figures()[figures().indexOf(QStringLiteral("Shadow area")) + 1];
    window->mode().setMode(ViewMode::exploration);  // nothing is computed automatically
    saveAndOpenAgain();
    showSaved("June");
    const auto& results = *window->findChild<ResultsDock*>();
    ASSERT_FALSE(results.faded());
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 20}}, QStringLiteral("lower")));
    ASSERT_TRUE(waitFor([this] { return !workbench().following().busy(); }));
    EXPECT_FALSE(workbench().answer());
    EXPECT_TRUE(figures().contains(area)) << figures().join(u'\n').toStdString();
    EXPECT_TRUE(results.faded());
    EXPECT_TRUE(note().contains(QStringLiteral("Outdated"))) << note().toStdString();
    workbench().document().undoStack().undo();
    ASSERT_TRUE(waitFor([this] { return !workbench().following().busy(); }));
    EXPECT_TRUE(workbench().answerAs<SavedContent>());
    EXPECT_TRUE(figures().contains(area));
    EXPECT_FALSE(results.faded()) << note().toStdString();
}

TEST_F(MeasuredAnswersWindow, AScoreIsThereAgainAfterTheUndoOfTwoEdits) {
    session().goTo("Tower");
    workbench().runScore("default");
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ScoreAnswer>() != nullptr; }));
    for (const double heightM : {20.0, 30.0}) {
        ASSERT_TRUE(session().addEdits({ChangeHeight{"New", heightM}}, QStringLiteral("lower")));
        ASSERT_TRUE(waitFor([this] { return !workbench().following().busy(); }));
        EXPECT_TRUE(contentOf<ScoreAnswer>(workbench().past()));
    }
    for (int step = 0; step < 2; ++step) {
        EXPECT_FALSE(workbench().answer());
        workbench().document().undoStack().undo();
        ASSERT_TRUE(waitFor([this] { return !workbench().following().busy(); }));
    }
    EXPECT_TRUE(workbench().answerAs<ScoreAnswer>());
    EXPECT_FALSE(workbench().past());
}

TEST(MeasuredAnswers, NamesThatTheUserHasTakenSinceAreNumberedAndAnyTextIsRead) {
    SavedResult result{.name = "Study", .kind = "study", .grid = {0, 0, 1, 1, 1}};
    const auto one = std::make_shared<const SavedResult>(result);
    Project project;
    project.results.push_back(one);
    Project saved = withMeasured(project, {std::make_shared<const MeasuredAnswer>(one)});
    ASSERT_EQ(saved.results.size(), 2U);
    EXPECT_NE(saved.results[1]->name, "Study");
    EXPECT_EQ(takeMeasured(saved).size(), 1U);
    EXPECT_EQ(saved.results.size(), 1U);
    for (const char* text : {"", "{", "[1,null,\"Study 9\"]", "{\"a\":1}"}) {
        saved.view["measured"] = text;
        EXPECT_TRUE(takeMeasured(saved).empty()) << text;
    }
}

TEST(MeasuredAnswers, TheOldestAreLeftOutWhereMapsAreTooLarge) {
    SavedResult result{.name = "Old", .kind = "study", .grid = {0, 0, 1, 5000, 5000}, .layers = {{}, {}}};
    MeasuredAnswers measured;
    for (const char* name : {"Old", "New"}) {
        result.name = name;
        result.layers.resize(std::string(name) == "Old" ? 2 : 1);
        measured.push_back(
            std::make_shared<const MeasuredAnswer>(std::make_shared<const SavedResult>(result)));
    }
    const Project saved = withMeasured({}, measured);
    ASSERT_EQ(saved.results.size(), 1U);
    EXPECT_EQ(saved.results[0]->name, "New");
}

}  // namespace
}  // namespace noonmark
