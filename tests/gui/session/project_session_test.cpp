#include "app/gui/session/project/project_session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QUndoStack>

#include "app/gui/session/study/study_document.h"
#include "tests/gui/small_project.h"

namespace noonmark {
namespace {

using test::idOf;
using test::newTower;
using testing::HasSubstr;

struct Session : ::testing::Test {
    StudyDocument document;
    QUndoStack& undo = document.undoStack();
    ProjectSession session{undo};
    QSignalSpy cities{&session, &ProjectSession::cityChanged};

    void SetUp() override {
        session.open(test::smallProject(), {}, existingCity);
        cities.clear();
    }

    bool demolish(std::size_t building) {
        return session.addEdits({Demolish{idOf(session.project(), building)}}, QStringLiteral("demolish"));
    }
};

TEST_F(Session, EditsOfTheExistingCityBeginAProposal) {
    EXPECT_TRUE(demolish(0));
    EXPECT_EQ(session.scenario(), "Proposal A");
    EXPECT_EQ(session.city()->buildings.size(), 2U);
    EXPECT_EQ(session.project().city->buildings.size(), 3U);
    EXPECT_EQ(cities.count(), 1);
    EXPECT_TRUE(demolish(1));
    EXPECT_EQ(session.project().scenarios.size(), 1U);
    session.goTo(existingCity);
    EXPECT_TRUE(demolish(1));
    EXPECT_EQ(session.scenario(), "Proposal B");
}

TEST_F(Session, UndoGoesBackToWhereTheEditWasMadeAndRedoAgain) {
    demolish(0);
    demolish(1);
    session.goTo(existingCity);
    undo.undo();
    EXPECT_EQ(session.scenario(), "Proposal A");
    EXPECT_EQ(session.city()->buildings.size(), 2U);
    undo.undo();
    EXPECT_EQ(session.scenario(), existingCity);
    EXPECT_TRUE(session.project().scenarios.empty());
    EXPECT_EQ(session.city(), session.project().city);
    undo.redo();
    undo.redo();
    EXPECT_EQ(session.city()->buildings.size(), 1U);
}

TEST_F(Session, OneUndoForProjectAndQuestion) {
    demolish(0);
    StudySettings settings = document.settings();
    settings.receivers.cellM = 7;
    document.change(settings, QStringLiteral("cell size"));
    demolish(1);
    undo.undo();
    EXPECT_EQ(document.settings().receivers.cellM, 7);
    undo.undo();
    EXPECT_NE(document.settings().receivers.cellM, 7);
    EXPECT_EQ(session.city()->buildings.size(), 2U);
}

TEST_F(Session, WhatIsNotSoundIsRefusedAndNothingChanges) {
    QSignalSpy refused(&session, &ProjectSession::refused);
    EXPECT_FALSE(session.addEdits({Demolish{"nobody"}}, QStringLiteral("demolish")));
    EXPECT_EQ(refused.count(), 1);
    EXPECT_THAT(refused.front().front().value<Error>().text(), HasSubstr("nobody"));
    EXPECT_TRUE(session.project().scenarios.empty());
    EXPECT_FALSE(undo.canUndo());
    EXPECT_EQ(cities.count(), 0);
}

TEST_F(Session, AnEditThatALaterOneNeedsCannotGo) {
    session.addEdits({newTower("new", 50)}, QStringLiteral("tower"));
    session.addEdits({ChangeHeight{"new", 80}}, QStringLiteral("height"));
    QSignalSpy refused(&session, &ProjectSession::refused);
    EXPECT_FALSE(
        session.change(withoutEdit(session.project(), "Proposal A", 0), QStringLiteral("take back")));
    EXPECT_EQ(refused.count(), 1);
    EXPECT_TRUE(session.change(withoutEdit(session.project(), "Proposal A", 1), QStringLiteral("take back")));
}

TEST_F(Session, AScenarioSharesWhatItsBaseBuilt) {
    session.addEdits({ChangeHeight{idOf(session.project(), 0), 99}}, QStringLiteral("height"));
    session.change(withScenario(session.project(), "B", "Proposal A"), QStringLiteral("new"), "B");
    session.addEdits({Demolish{idOf(session.project(), 2)}}, QStringLiteral("demolish"));
    const auto a = session.cityOf("Proposal A").value(), b = session.cityOf("B").value();
    EXPECT_EQ(a->buildings[0], b->buildings[0]);
    EXPECT_NE(a->buildings[0], session.project().city->buildings[0]);
    EXPECT_EQ(b->buildings.size(), 2U);
    EXPECT_EQ(session.cityOf("B").value(), b) << "a repeated call returns the same city";
}

TEST_F(Session, RenamingAScenarioKeepsThoseThatStartFromIt) {
    demolish(0);
    session.change(withScenario(session.project(), "B", "Proposal A"), QStringLiteral("new"), "B");
    EXPECT_TRUE(
        session.change(renameIn(session.project(), ProjectPart::scenario, "Proposal A", "Slim").value(),
                       QStringLiteral("rename")));
    EXPECT_EQ(session.project().scenarios[1].base, "Slim");
    EXPECT_EQ(session.city()->buildings.size(), 2U);
    EXPECT_FALSE(renameIn(session.project(), ProjectPart::scenario, "Slim", "B")) << "the name is in use";
    EXPECT_THAT(without(session.project(), ProjectPart::scenario, "Slim").error().text(),
                HasSubstr("first: B"));
}

TEST_F(Session, ADeletedScenarioIsLeftAndABaselineToo) {
    demolish(0);
    session.compareWith("Proposal A");
    EXPECT_TRUE(session.change(without(session.project(), ProjectPart::scenario, "Proposal A").value(),
                               QStringLiteral("delete")));
    EXPECT_EQ(session.scenario(), existingCity);
    EXPECT_EQ(session.baseline(), "");
    undo.undo();
    EXPECT_EQ(session.scenario(), "Proposal A");
}

TEST_F(Session, ACopyStandsBesideTheOriginalUnderANameOfItsOwn) {
    demolish(0);
    std::string made;
    const Project next = duplicate(session.project(), ProjectPart::scenario, "Proposal A", made);
    EXPECT_EQ(made, "Proposal B");
    EXPECT_EQ(next.scenarios[1].edits, next.scenarios[0].edits);
    duplicate(session.project(), ProjectPart::lot, "Yard", made);
    EXPECT_EQ(made, "Yard (2)");
}

TEST_F(Session, QuestionsAloneOfACityThatWasNeverSavedAreNoWorkToLose) {
    StudySettings settings = document.settings();
    settings.receivers.cellM = 7;
    document.change(settings, QStringLiteral("cell size"));
    EXPECT_FALSE(session.hasUnsavedWork());
    session.addLot({"", test::square({0, 0}, 5)});
    EXPECT_EQ(session.project().lots.back().name, "Lot");
    EXPECT_TRUE(session.hasUnsavedWork());
    undo.undo();
    EXPECT_FALSE(session.hasUnsavedWork());
}

TEST_F(Session, TheSavedStateIsCleanByWhateverWayItIsComeBackTo) {
    const QTemporaryDir folder;
    demolish(0);
    auto file =
        ProjectFile::create(folder.filePath("a.noonmark.gpkg").toStdString(), session.project()).value();
    session.setSaved(file, session.version());
    EXPECT_FALSE(session.hasUnsavedWork());
    demolish(1);
    EXPECT_TRUE(session.hasUnsavedWork());
    undo.undo();
    EXPECT_FALSE(session.hasUnsavedWork());
    undo.undo();
    EXPECT_TRUE(session.hasUnsavedWork());
    const int version = session.version();
    undo.redo();
    undo.undo();
    session.setSaved(file, version);
    EXPECT_TRUE(session.hasUnsavedWork()) << "the saved state may differ from the present one";
}

TEST_F(Session, AStepThatIsTakenBackWhileItIsSavedLeavesNoStateClean) {
    const QTemporaryDir folder;
    demolish(0);
    auto file =
        ProjectFile::create(folder.filePath("a.noonmark.gpkg").toStdString(), session.project()).value();
    session.setSaved(file, session.version());
    demolish(1);
    const int version = session.version();
    undo.undo();
    session.setSaved(file, version);
    EXPECT_TRUE(session.hasUnsavedWork()) << "the file contains the undone step";
}

TEST_F(Session, OtherBuildingsInTheBaselineAreReported) {
    demolish(0);
    demolish(1);
    session.compareWith("Proposal A");
    session.goTo(existingCity);
    cities.clear();
    const QSignalSpy baselines(&session, &ProjectSession::baselineChanged);
    EXPECT_TRUE(session.change(withoutEdit(session.project(), "Proposal A", 1), QStringLiteral("take back")));
    EXPECT_EQ(session.baseline(), "Proposal A");
    EXPECT_EQ(cities.count(), 0);
    EXPECT_EQ(baselines.count(), 1);
    session.goTo("Proposal A");
    EXPECT_EQ(baselines.count(), 1) << "another scenario is shown, the baseline is the same";
}

TEST_F(Session, OnlyTheUsersChoiceOfABaselineAsksForAComparison) {
    demolish(0);
    const QSignalSpy wanted(&session, &ProjectSession::comparisonRequested);
    const QSignalSpy baselines(&session, &ProjectSession::baselineChanged);
    session.setBaseline(existingCity);
    EXPECT_EQ(baselines.count(), 1);
    EXPECT_EQ(wanted.count(), 0) << "the comparison is at hand";
    session.compareWith({});
    session.compareWith(existingCity);
    EXPECT_EQ(wanted.count(), 2);
    const QSignalSpy refused(&session, &ProjectSession::refused);
    session.compareWith("Nowhere");
    EXPECT_EQ(refused.count(), 1);
    EXPECT_EQ(wanted.count(), 2);
}

TEST(ProposalNames, GoOnAfterZ) {
    std::vector<Scenario> scenarios;
    for (int i = 0; i < 30; ++i) scenarios.push_back({nextProposal(scenarios), {}, {}});
    EXPECT_EQ(scenarios[1].name, "Proposal B");
    EXPECT_EQ(scenarios[25].name, "Proposal Z");
    EXPECT_EQ(scenarios[26].name, "Proposal 27");
    EXPECT_TRUE(validate(scenarios));
}

}  // namespace
}  // namespace noonmark
