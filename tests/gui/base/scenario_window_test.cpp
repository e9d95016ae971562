#include <gtest/gtest.h>

#include <QLabel>
#include <QTableView>

#include "app/gui/base/looks/units.h"
#include "app/gui/docks/export/table_text.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/questions/saved_question.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::newTower;
using test::ProjectWindow;
using test::waitFor;

TEST_F(ProjectWindow, ComparesTwoScenariosAndKeepsTheResult) {
    StudySettings question = workbench().document().settings();
    question.receivers.cellM = 4;
    question.period.stepMinutes = 10;
    question.period.zone = "America/New_York";
    workbench().document().change(question, QStringLiteral("test"));
    build();
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ImpactAnswer>() != nullptr; }));
    // Keeps the object alive, so that no other comparison gets its address.
    const auto held = workbench().answerAs<ImpactAnswer>();
    const ImpactAnswer& answer = *held;
    EXPECT_EQ(answer.from, existingCity);
    EXPECT_EQ(answer.to, "Proposal A");
    EXPECT_GT(computeFigures(answer.study.total, 0).gross.anyMoreShadowM2, 0);
    EXPECT_EQ(window->mode().mode(), ViewMode::analysis);
    const auto legend = window->panel().legend().legend();
    ASSERT_TRUE(legend);
    EXPECT_TRUE(legend->change);
    EXPECT_EQ(legend->patches.size(), 1U) << "the tower stands on what was ground";
    workbench().saveAnswer(QStringLiteral("Impact"));
    ASSERT_TRUE(waitFor([this] { return session().project().results.size() == 1; }));
    EXPECT_EQ(session().project().results[0]->kind, "impact");
    session().addEdits({ChangeHeight{"New", 20}}, QStringLiteral("height"));
    ASSERT_TRUE(waitFor([&] {
        return workbench().answerAs<ImpactAnswer>() && workbench().answerAs<ImpactAnswer>().get() != &answer;
    })) << "a quick result is recomputed after the change";
    session().compareWith({});
    EXPECT_EQ(workbench().answerAs<ImpactAnswer>(), nullptr);
}

TEST_F(ProjectWindow, AllScenariosAreMeasuredForTheTable) {
    build();
    StudySettings question = workbench().document().settings();
    question.receivers.cellM = 4;
    question.period.stepMinutes = 10;
    workbench().document().change(question, QStringLiteral("test"));
    std::vector<double> fractions;
    QObject::connect(&workbench().running(), &JobSlot::started, &workbench(), [&](const Job& job) {
        QObject::connect(&job, &Job::progressed, &workbench(),
                         [&](double fraction) { fractions.push_back(fraction); });
    });
    workbench().measureAll();
    ASSERT_TRUE(waitFor([this] { return workbench().studies().size() == 2; }));
    ASSERT_FALSE(fractions.empty());
    EXPECT_TRUE(std::ranges::is_sorted(fractions)) << "progress never runs back";
    const auto studies = workbench().studies();
    EXPECT_GT(studies.at("Proposal A")->statistics.shadowAreaM2,
              studies.at(existingCity)->statistics.shadowAreaM2);
    EXPECT_EQ(workbench().study(), studies.at("Proposal A"));
    session().goTo(existingCity);
    ASSERT_TRUE(waitFor([&] { return workbench().study() == studies.at(existingCity); }))
        << "saved and shown again";
}

Edit designedTower(const std::string& id, int storeys) {
    const Footprint lot = test::square({20, 20}, 20);
    Building building{.sourceId = id, .name = id};
    building.parts.push_back({.sourceId = id, .footprint = lot, .topM = 3.5F * float(storeys)});
    return AddBuilding{std::make_shared<const Building>(std::move(building)),
                       std::make_shared<const TowerDesign>(TowerDesign{
                           "Yard", lot, {.storeys = storeys, .uses = {{"Offices", 2}, {"Homes", 0}}}})};
}

struct ScenarioUsesTable : ProjectWindow {
    QTableView* view = nullptr;

    void SetUp() override {
        ProjectWindow::SetUp();
        view = window->findChild<QTableView*>(QStringLiteral("scenarioTable"));
        ASSERT_TRUE(session().addEdits({designedTower("Low", 5)}, QStringLiteral("tower")));
        ASSERT_TRUE(session().change(withScenario(session().project(), "Tall", {}), QStringLiteral("new")));
        session().goTo("Tall");
        ASSERT_TRUE(
            session().addEdits({designedTower("High", 12), newTower("Plain", 30)}, QStringLiteral("towers")));
    }
    void TearDown() override { applyUnits(UnitSystem::metric); }

    [[nodiscard]] QModelIndex uses(int row) const {
        return view->model()->index(row, view->model()->columnCount() - 1);
    }
    [[nodiscard]] QString first() const { return view->model()->index(0, 0).data().toString(); }
};

TEST_F(ScenarioUsesTable, ListsTheFloorAreaOfEachUse) {
    EXPECT_EQ(uses(0).data().toString(), QString()) << "the existing city";
    EXPECT_EQ(uses(1).data().toString(), QStringLiteral("Homes 1,200 m², Offices 800 m²"));
    EXPECT_EQ(uses(1).data(Qt::ToolTipRole).toString(),
              QStringLiteral("Homes: 3 storeys, 1,200 m²\nOffices: 2 storeys, 800 m²"));
    EXPECT_TRUE(uses(2)
                    .data(Qt::ToolTipRole)
                    .toString()
                    .endsWith(QStringLiteral("\nNot counted: 1 building whose floors are not known")));
    EXPECT_TRUE(makeTableText(*view->model()).contains(QStringLiteral("\tHomes 1,200 m², Offices 800 m²\n")))
        << "copied with the table";
    applyUnits(UnitSystem::imperial);
    EXPECT_TRUE(uses(1).data().toString().startsWith(QStringLiteral("Homes 12,917 sq ft")))
        << uses(1).data().toString().toStdString();
}

TEST_F(ScenarioUsesTable, FollowsTheEditsOfAScenario) {
    session().goTo("Proposal A");
    session().addEdits({Demolish{"Low"}}, QStringLiteral("demolish"));
    EXPECT_EQ(uses(1).data().toString(), QString());
    workbench().document().undoStack().undo();
    EXPECT_EQ(uses(1).data().toString(), QStringLiteral("Homes 1,200 m², Offices 800 m²"));
}

TEST_F(ScenarioUsesTable, IsSortedByItsHeadingsAndOpensTheRowThatIsSeen) {
    EXPECT_EQ(first(), QStringLiteral("Existing")) << "the project's order";
    view->sortByColumn(uses(0).column(), Qt::DescendingOrder);
    EXPECT_EQ(first(), QStringLiteral("Tall"));
    session().goTo(existingCity);
    Q_EMIT view->doubleClicked(view->model()->index(0, 0));
    EXPECT_EQ(session().scenario(), "Tall");
    view->sortByColumn(-1, Qt::AscendingOrder);
    EXPECT_EQ(first(), QStringLiteral("Existing"));
}

TEST_F(ProjectWindow, ARunRightAfterAnEditAnswersForTheEditedCity) {
    build();
    StudySettings question = workbench().document().settings();
    question.receivers.cellM = 4;
    question.period.stepMinutes = 10;
    workbench().document().change(question, QStringLiteral("test"));
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 20}}, QStringLiteral("height")));
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return !workbench().following().busy() && !workbench().running().busy(); }));
    EXPECT_TRUE(workbench().study());
    EXPECT_EQ(workbench().studies().count("Proposal A"), 1U);
}

TEST_F(ProjectWindow, ARunningComparisonOutlivesAnotherNameOfEitherSide) {
    build();
    StudySettings question = workbench().document().settings();
    question.receivers.cellM = 4;
    question.period.stepMinutes = 10;
    workbench().document().change(question, QStringLiteral("test"));
    ASSERT_TRUE(session().change(withScenario(session().project(), "Other", {}), QStringLiteral("new")));
    session().compareWith("Other");
    ASSERT_TRUE(workbench().running().busy());
    ASSERT_TRUE(session().rename(ProjectPart::scenario, "Other", "Base"));
    ASSERT_TRUE(session().rename(ProjectPart::scenario, "Proposal A", "Tall"));
    EXPECT_TRUE(workbench().running().busy());
    EXPECT_EQ(session().baseline(), "Base");
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ImpactAnswer>() != nullptr; }));
    EXPECT_EQ(workbench().answerAs<ImpactAnswer>()->from, "Base");
    EXPECT_EQ(workbench().answerAs<ImpactAnswer>()->to, "Tall");
    workbench().document().undoStack().undo();
    workbench().document().undoStack().undo();
    ASSERT_TRUE(workbench().answerAs<ImpactAnswer>()) << "undoing the renaming does not end it either";
    EXPECT_EQ(session().baseline(), "Other");
    EXPECT_EQ(workbench().answerAs<ImpactAnswer>()->from, "Other");
    EXPECT_EQ(workbench().answerAs<ImpactAnswer>()->to, "Proposal A");
}

TEST_F(ProjectWindow, AStudyOutlivesAnotherNameOfItsScenario) {
    build();
    StudySettings question = workbench().document().settings();
    question.receivers.cellM = 4;
    question.period.stepMinutes = 10;
    workbench().document().change(question, QStringLiteral("test"));
    workbench().run();
    ASSERT_TRUE(session().rename(ProjectPart::scenario, "Proposal A", "Tall"));
    ASSERT_TRUE(waitFor([this] { return !workbench().running().busy(); }));
    EXPECT_TRUE(workbench().study());
    EXPECT_EQ(workbench().studies().count("Tall"), 1U);
}

TEST_F(ProjectWindow, AQuickComparisonIsMadeAgainWhenTheProjectIsReopenedAndASlowOneShownAsSaved) {
    StudySettings question = workbench().document().settings();
    question.receivers.cellM = 4;
    question.period.stepMinutes = 10;
    question.period.zone = "America/New_York";
    workbench().document().change(question, QStringLiteral("test"));
    build();
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ImpactAnswer>() != nullptr; }));
    save();
    makeWindow();
    open(file);
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ImpactAnswer>() != nullptr; }));
    EXPECT_EQ(workbench().answerAs<ImpactAnswer>()->to, "Proposal A");
    auto saved = ProjectFile::open(file.toStdString()).value();
    Project slow = saved.project();
    slow.view["answer_seconds"] = "4000";
    ASSERT_TRUE(saved.save(slow));
    makeWindow();
    open(file);
    EXPECT_FALSE(workbench().running().busy());
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<SavedContent>() != nullptr; }));
    EXPECT_EQ(workbench().answerAs<SavedContent>()->result->kind, "impact");
    slow.view["measured"] = "[]";  // as versions saved it that kept no answers
    ASSERT_TRUE(saved.save(slow));
    makeWindow();
    open(file);
    const QString note = window->findChild<QLabel*>(QStringLiteral("resultNote"))->text();
    EXPECT_TRUE(note.startsWith(QStringLiteral("Proposal A was compared with Existing when")))
        << note.toStdString();
    EXPECT_TRUE(note.contains(QStringLiteral("about 67 min"))) << note.toStdString();
}

}  // namespace
}  // namespace noonmark
