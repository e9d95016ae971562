#include "app/gui/docks/project/project_model.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QCoreApplication>
#include <QFont>
#include <QKeyEvent>
#include <QPersistentModelIndex>
#include <QTreeView>
#include <QUndoStack>
#include <random>

#include "app/gui/docks/project/project_dock.h"
#include "app/gui/docks/scenarios/scenario_table.h"
#include "app/gui/session/project/project_session.h"
#include "tests/gui/small_project.h"

namespace noonmark {
namespace {

using test::idOf;
using test::newTower;
using Mode = QAbstractItemModelTester::FailureReportingMode;

struct ProjectTree : ::testing::Test {
    QUndoStack undo;
    ProjectSession session{undo};
    ProjectModel model{session};
    QAbstractItemModelTester tester{&model, Mode::Fatal};

    void SetUp() override { session.open(test::smallProject(), {}, existingCity); }

    QStringList childrenOf(const QModelIndex& parent) {
        QStringList texts;
        for (int i = 0; i < model.rowCount(parent); ++i) texts << model.index(i, 0, parent).data().toString();
        return texts;
    }
    QModelIndex scenario(const std::string& name) { return model.indexOf(ProjectPart::scenario, name); }
};

TEST_F(ProjectTree, ShowsWhatTheProjectHolds) {
    const QModelIndex city = model.index(0, 0);
    EXPECT_EQ(city.data().toString(), QStringLiteral("City"));
    EXPECT_EQ(childrenOf(city).front(), QStringLiteral("3 buildings"));
    EXPECT_TRUE(childrenOf(city).join(QLatin1Char(' ')).contains(QStringLiteral("Nobody")));
    EXPECT_EQ(childrenOf(model.groupOf(ProjectPart::scenario)), QStringList(QStringLiteral("Existing")));
    EXPECT_TRUE(
        childrenOf(model.groupOf(ProjectPart::lot)).front().startsWith(QStringLiteral("Yard   900 m²")));
    EXPECT_EQ(model.rowCount(model.indexOf(ProjectPart::weights, "default")), 12);
}

TEST_F(ProjectTree, ScenariosHaveTheirEditsAndTheShownOneIsBold) {
    session.addEdits({Demolish{idOf(session.project(), 0)}, newTower("New", 44)}, QStringLiteral("edits"));
    const QModelIndex a = scenario("Proposal A");
    EXPECT_TRUE(a.data(Qt::FontRole).value<QFont>().bold());
    EXPECT_FALSE(scenario(existingCity).data(Qt::FontRole).value<QFont>().bold());
    ASSERT_EQ(model.rowCount(a), 2);
    EXPECT_EQ(childrenOf(a)[0].toStdString(), formatText(session.project().scenarios[0].edits[0]));
    session.goTo(existingCity);
    EXPECT_TRUE(scenario(existingCity).data(Qt::FontRole).value<QFont>().bold());
}

TEST_F(ProjectTree, LinesThatStayAreTheSameLines) {
    session.addEdits({newTower("New", 44)}, QStringLiteral("tower"));
    const QPersistentModelIndex saved = scenario("Proposal A");
    const QPersistentModelIndex lot = model.indexOf(ProjectPart::lot, "Yard");
    session.addEdits({ChangeHeight{"New", 60}}, QStringLiteral("height"));
    session.change(withScenario(session.project(), "Other", {}), QStringLiteral("new"));
    EXPECT_TRUE(saved.isValid());
    EXPECT_EQ(model.rowCount(saved), 2);
    EXPECT_TRUE(lot.isValid());
    undo.undo();
    undo.undo();
    EXPECT_EQ(model.rowCount(saved), 1);
    undo.undo();
    EXPECT_FALSE(saved.isValid());
}

TEST_F(ProjectTree, RenamesPartsInPlaceButNotTheExistingCity) {
    session.addEdits({newTower("New", 44)}, QStringLiteral("tower"));
    EXPECT_TRUE(model.setData(scenario("Proposal A"), QStringLiteral(" Slim ")));
    EXPECT_EQ(session.scenario(), "Slim");
    EXPECT_TRUE(scenario("Slim").data(Qt::FontRole).value<QFont>().bold());
    EXPECT_FALSE(model.setData(scenario("Slim"), QStringLiteral("Existing")));
    EXPECT_FALSE(model.setData(scenario("Slim"), QString()));
    EXPECT_FALSE(model.flags(scenario(existingCity)) & Qt::ItemIsEditable);
    EXPECT_FALSE(model.setData(scenario(existingCity), QStringLiteral("x")));
    EXPECT_TRUE(model.setData(model.indexOf(ProjectPart::lot, "Yard"), QStringLiteral("Court")));
    EXPECT_EQ(session.project().lots[0].name, "Court");
    undo.undo();
    EXPECT_EQ(session.project().lots[0].name, "Yard");
}

// The model tester checks rows, parents and signals after each of many random changes.
TEST_F(ProjectTree, HoldsThroughRandomChangesUndoAndRedo) {
    std::mt19937 random(5);
    const auto any = [&](std::size_t below) { return std::size_t(random() % below); };
    for (int i = 0; i < 300; ++i) {
        const std::size_t scenarios = session.project().scenarios.size();
        switch (any(7)) {
            case 0:
                session.addEdits({newTower("t" + std::to_string(i), float(10 + i))}, QStringLiteral("t"));
                break;
            case 1:
                session.change(withScenario(session.project(), "S" + std::to_string(i), session.scenario()),
                               QStringLiteral("s"));
                break;
            case 2:
                undo.undo();
                break;
            case 3:
                undo.redo();
                break;
            case 4:
                session.goTo(scenarios > 0 ? session.project().scenarios[any(scenarios)].name : existingCity);
                break;
            case 5:
                if (scenarios == 0) break;
                if (const auto next = without(session.project(), ProjectPart::scenario,
                                              session.project().scenarios[any(scenarios)].name))
                    session.change(*next, QStringLiteral("d"));
                break;
            default:
                session.addLot({"", test::square({float(i), 0}, 9)});
                break;
        }
        ASSERT_EQ(std::size_t(model.rowCount(model.groupOf(ProjectPart::scenario))),
                  session.project().scenarios.size() + 1);
        ASSERT_EQ(std::size_t(model.rowCount(model.groupOf(ProjectPart::lot))),
                  session.project().lots.size());
    }
}

TEST_F(ProjectTree, ScenarioTableFollows) {
    ScenarioTable table(session);
    const QAbstractItemModelTester checks(&table, Mode::Fatal);
    EXPECT_EQ(table.rowCount(), 1);
    session.addEdits({newTower("New", 44)}, QStringLiteral("tower"));
    EXPECT_EQ(table.rowCount(), 2);
    EXPECT_EQ(table.index(1, 0).data().toString(), QStringLiteral("Proposal A"));
    EXPECT_EQ(table.index(1, 1).data().toString(), QStringLiteral("1"));
    EXPECT_EQ(table.index(1, scenarioColumn("shadow_area_m2")).data().toString(),
              QStringLiteral("not measured"));
    auto study = std::make_shared<Study>();
    study->statistics.shadowAreaM2 = 1234;
    table.setStudies({{"Proposal A", study}}, study->settings);
    EXPECT_EQ(table.index(1, scenarioColumn("shadow_area_m2")).data().toString(), QStringLiteral("1,234"));
    StudySettings other;
    other.receivers.cellM = 9;
    table.setStudies({{"Proposal A", study}}, other);
    EXPECT_EQ(table.index(1, scenarioColumn("shadow_area_m2")).data().toString(),
              QStringLiteral("out of date"))
        << "other settings";
}

TEST_F(ProjectTree, KeysInTheTreeGoBeforeTheWindowsShortcuts) {
    ProjectDock dock(session);
    session.addEdits({newTower("New", 44)}, QStringLiteral("tower"));
    dock.tree().setCurrentIndex(dock.model().indexOf(ProjectPart::scenario, "Proposal A"));
    QKeyEvent claim(QEvent::ShortcutOverride, Qt::Key_Delete, Qt::NoModifier);
    claim.ignore();
    QCoreApplication::sendEvent(&dock.tree(), &claim);
    EXPECT_TRUE(claim.isAccepted());
    QKeyEvent press(QEvent::KeyPress, Qt::Key_Delete, Qt::NoModifier);
    QCoreApplication::sendEvent(&dock.tree(), &press);
    EXPECT_TRUE(session.project().scenarios.empty());
}

TEST_F(ProjectTree, DockUsesRemovesAndCopies) {
    ProjectDock dock(session);
    session.addEdits({newTower("New", 44), ChangeHeight{"New", 55}}, QStringLiteral("tower"));
    const auto at = [&](ProjectPart part, const std::string& name) {
        return dock.model().indexOf(part, name);
    };
    dock.use(at(ProjectPart::scenario, existingCity));
    EXPECT_EQ(session.scenario(), existingCity);
    dock.duplicate(at(ProjectPart::scenario, "Proposal A"));
    EXPECT_EQ(session.scenario(), "Proposal B");
    dock.remove(dock.model().index(1, 0, at(ProjectPart::scenario, "Proposal B")));
    EXPECT_EQ(session.project().scenarios[1].edits.size(), 1U);
    dock.remove(at(ProjectPart::scenario, existingCity));
    dock.remove(at(ProjectPart::scenario, "Proposal A"));
    EXPECT_EQ(session.project().scenarios.size(), 1U);
    Region chosen;
    QObject::connect(&dock, &ProjectDock::regionChosen, [&](const Region& region) { chosen = region; });
    dock.use(at(ProjectPart::region, "Square"));
    EXPECT_EQ(chosen, session.project().regions[0]);
}

}  // namespace
}  // namespace noonmark
