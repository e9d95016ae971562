#include <gtest/gtest.h>

#include <QPushButton>
#include <QSpinBox>
#include <cmath>

#include "app/gui/docks/project/project_model.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/questions/saved_question.h"
#include "scenarios/project/results/save_result.h"
#include "tests/gui/answers_window.h"

namespace noonmark {
namespace {

using test::AnswersWindow;
using test::waitFor;

TEST_F(AnswersWindow, AKeptStudyIsShownAgainWithFiguresAndLegend) {
    study();
    const auto before = window->panel().legend().legend();
    keep("June");
    const QString area = figures()[figures().indexOf(QStringLiteral("Shadow area")) + 1];
    window->mode().setMode(ViewMode::exploration);
    showSaved("June");
    EXPECT_EQ(window->mode().mode(), ViewMode::analysis);
    ASSERT_TRUE(window->panel().legend().legend());
    EXPECT_EQ(window->panel().legend().legend()->scale.top, before->scale.top);
    EXPECT_TRUE(window->panel().legend().note().startsWith(QStringLiteral("Saved 2")))
        << window->panel().legend().note().toStdString();
    EXPECT_TRUE(figures().contains(area));
    EXPECT_TRUE(figures().join(QLatin1Char('\n')).contains(QStringLiteral("Square\ncells of 4 m")));
    EXPECT_TRUE(note().contains(QStringLiteral("Its inputs have not changed"))) << note().toStdString();
    EXPECT_EQ(session().project().results.size(), 1U);
    window->findChild<QPushButton*>(QStringLiteral("wayBack"))->click();
    EXPECT_EQ(workbench().answerAs<SavedContent>(), nullptr);
    EXPECT_TRUE(window->panel().legend().note().contains(QStringLiteral("Measured error")));
}

TEST_F(AnswersWindow, AKeptResultGoesToItsScenarioAndSaysWhatHasChanged) {
    session().goTo("Tower");
    session().compareWith(existingCity);
    window->mode().setMode(ViewMode::analysis);
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ImpactAnswer>() != nullptr; }));
    keep("Impact");
    session().compareWith({});
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 20}}, QStringLiteral("lower")));
    session().goTo(existingCity);
    showSaved("Impact");
    EXPECT_EQ(session().scenario(), "Tower");
    EXPECT_TRUE(window->panel().legend().legend()->change);
    EXPECT_TRUE(note().contains(QStringLiteral("'Tower' has changed since"))) << note().toStdString();
    EXPECT_TRUE(window->panel().legend().note().endsWith(QStringLiteral("Outdated")));
    workbench().document().undoStack().undo();
    EXPECT_EQ(workbench().answerAs<SavedContent>(), nullptr) << "it was shown with other buildings";
    showSaved("Impact");
    EXPECT_TRUE(note().contains(QStringLiteral("Its inputs have not changed"))) << note().toStdString();
}

TEST_F(AnswersWindow, ADamagedKeptResultIsReportedAndWhatWasShownStays) {
    study();
    keep("June");
    Project next = session().project();
    auto broken = std::make_shared<SavedResult>(*next.results[0]);
    broken->settings = "{}";
    next.results[0] = broken;
    ASSERT_TRUE(session().change(next, QStringLiteral("break")));
    enter(ProjectPart::result, "June");
    EXPECT_TRUE(waitFor(
        [this] { return window->panel().messages().text().contains(QStringLiteral("cannot be shown")); }));
    EXPECT_EQ(workbench().answerAs<SavedContent>(), nullptr);
    EXPECT_NE(workbench().study(), nullptr);
}

TEST_F(AnswersWindow, AScoreIsShownByMonthsKeptAndFoundOutdated) {
    workbench().runScore("default");
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ScoreAnswer>() != nullptr; }));
    const Score& score = workbench().answerAs<ScoreAnswer>()->score;
    EXPECT_GE(score.months.size(), 2U);
    NoProgress progress;
    const Score again =
        runScore(*session().city(), workbench().document().settings(), makeMonthlyWeights(), progress, {})
            .value();
    EXPECT_EQ(score.scoreM2, again.scoreM2) << "as the command line has it";
    EXPECT_TRUE(window->panel().legend().legend()->colours->isWanted());
    EXPECT_TRUE(figures().contains(QStringLiteral("Shadow score")));
    EXPECT_EQ(note(), QString());
    keep("Score");
    EXPECT_EQ(session().project().results.at(0)->kind, "score");
    Project next = session().project();
    next.weights[0].intervals[0].weight = 0.5;
    ASSERT_TRUE(session().change(next, QStringLiteral("weights")));
    EXPECT_TRUE(note().contains(QStringLiteral("weight table has changed"))) << note().toStdString();
    showSaved("Score");
    EXPECT_TRUE(window->panel().legend().legend()->colours->isWanted());
    EXPECT_TRUE(figures().contains(QStringLiteral("Shadow score")));
    const auto legendNote = [this] { return window->panel().legend().note(); };
    EXPECT_TRUE(note().contains(QStringLiteral("'default' has changed since"))) << note().toStdString();
    EXPECT_TRUE(legendNote().endsWith(QStringLiteral("Outdated"))) << legendNote().toStdString();
    workbench().document().undoStack().undo();
    EXPECT_TRUE(note().contains(QStringLiteral("Its inputs have not changed"))) << note().toStdString();
    EXPECT_FALSE(legendNote().endsWith(QStringLiteral("Outdated"))) << legendNote().toStdString();
    study();
    EXPECT_EQ(workbench().answerAs<SavedContent>(), nullptr) << "another result replaces it";
    EXPECT_FALSE(figures().contains(QStringLiteral("Shadow score")));
}

TEST_F(AnswersWindow, TheScaleOfDifferencesIsLockedChangedAndFoundAgain) {
    session().goTo("Tower");
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ImpactAnswer>() != nullptr; }));
    LegendStrip& legend = window->panel().legend();
    auto* field = window->findChild<QSpinBox*>(QStringLiteral("changeScale"));
    EXPECT_TRUE(field->isVisible());
    EXPECT_EQ(legend.legend()->scale.top, 60);
    EXPECT_TRUE(describeUnit(*legend.legend()).contains(QStringLiteral("scale locked: ±60 min")))
        << describeUnit(*legend.legend()).toStdString();
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 8}}, QStringLiteral("low")));
    const auto before = workbench().answerAs<ImpactAnswer>();
    ASSERT_TRUE(waitFor([&] {
        return workbench().answerAs<ImpactAnswer>() && workbench().answerAs<ImpactAnswer>() != before;
    }));
    EXPECT_EQ(legend.legend()->scale.top, 60) << "another proposal, the same scale";
    field->setValue(25);
    EXPECT_EQ(legend.legend()->scale.top, 25);
    EXPECT_EQ(legend.changeScale(), ChangeScale{25});
    window->saving().save();
    ASSERT_TRUE(waitFor([this] { return !window->saving().writing().busy(); }));
    EXPECT_EQ(changeScaleIn(ProjectFile::open(session().file()->path()).value().project().view),
              ChangeScale{25});
    field->setValue(0);
    EXPECT_TRUE(describeUnit(*legend.legend()).contains(QStringLiteral("fitted")))
        << describeUnit(*legend.legend()).toStdString();
    const auto open = workbench().city();
    window->open({QString::fromStdString(session().file()->path().string())});
    ASSERT_TRUE(waitFor([&] { return workbench().city() != open; }));
    EXPECT_EQ(legend.changeScale(), ChangeScale{25}) << "as it was saved";
    session().compareWith({});
    EXPECT_FALSE(field->isVisible());
}

}  // namespace
}  // namespace noonmark
