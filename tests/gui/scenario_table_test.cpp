#include "app/gui/docks/scenarios/scenario_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QFile>
#include <QHeaderView>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QUndoStack>
#include <cmath>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/column_menu.h"
#include "app/gui/docks/scenarios/scenarios_dock.h"
#include "app/gui/docks/weights/weights_dock.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::newTower;
using test::ProjectWindow;
using test::square;
using test::waitFor;
using testing::HasSubstr;

using TableColumn = ScenarioTable::Column;

/// A tower on 20 x 20 m with storeys of 3.5 m.
Edit towerOfStoreys(const std::string& id, int storeys) {
    const Footprint lot = square({20, 20}, 20);
    Building building{.sourceId = id, .name = id};
    building.parts.push_back({.sourceId = id, .footprint = lot, .topM = 3.5F * float(storeys)});
    return AddBuilding{std::make_shared<const Building>(std::move(building)),
                       std::make_shared<const TowerDesign>(TowerDesign{"Yard", lot, {.storeys = storeys}})};
}

/// Two scenarios: "Low" of 5 storeys and "Tall" of 12, with a quick study and two parks, one of which no
/// shadow reaches.
struct ScenarioTableWindow : ProjectWindow {
    QTableView* view = nullptr;

    void SetUp() override {
        ProjectWindow::SetUp();
        view = window->findChild<QTableView*>(QStringLiteral("scenarioTable"));
        StudySettings question = workbench().document().settings();
        question.receivers.cellM = 4;
        question.period.stepMinutes = 20;
        question.period.zone = "America/New_York";
        question.region = session().project().regions[0];
        workbench().document().change(question, QStringLiteral("test"));
        Project next = session().project();
        next.places.push_back({"Park", PlaceKind::park, {square({10, 60}, 30)}, "drawn"});
        next.places.push_back({"Far park", PlaceKind::park, {square({3000, -3000}, 30)}, "drawn"});
        next = withScenario(std::move(next), "Low", {});
        next = withScenario(std::move(next), "Tall", {});
        next.scenarios[0].edits = {towerOfStoreys("New", 5)};
        next.scenarios[1].edits = {towerOfStoreys("New", 12)};
        ASSERT_TRUE(session().change(std::move(next), QStringLiteral("scenarios")));
        settle();
    }
    void TearDown() override { applyUnits(UnitSystem::metric); }

    // The row of a scenario in the project's order: 0 Existing, 1 Low, 2 Tall.
    [[nodiscard]] QModelIndex at(int row, TableColumn column) const {
        return window->findChild<ScenariosDock*>()->table().index(row, column);
    }
    [[nodiscard]] QString text(int row, TableColumn column) const {
        return at(row, column).data().toString();
    }
    [[nodiscard]] QString tip(int row, TableColumn column) const {
        return at(row, column).data(Qt::ToolTipRole).toString();
    }
    [[nodiscard]] double value(int row, TableColumn column) const {
        return at(row, column).data(ScenarioTable::sortRole).toDouble();
    }
    void settle() {
        ASSERT_TRUE(waitFor([this] {
            return !window->answers().busy() && !workbench().following().busy() &&
                   !workbench().running().busy() && !window->review().runningAll().busy();
        })) << message().toStdString();
    }
    void press(const char* button) {
        window->findChild<QPushButton*>(QString::fromLatin1(button))->click();
        settle();
    }
    // While the existing city is displayed, so that nothing is computed again by itself.
    void editTall(const Edit& edit) {
        session().goTo(existingCity);
        settle();
        Project next = session().project();
        next.scenarios[1].edits.push_back(edit);
        ASSERT_TRUE(session().change(std::move(next), QStringLiteral("edit")));
        settle();
    }
    void undo() {
        workbench().document().undoStack().undo();
        settle();
    }
};

TEST_F(ScenarioTableWindow, StatesHeightAndFloorAreaOfWhatAScenarioAdds) {
    EXPECT_EQ(text(0, TableColumn::height), QString()) << "the existing city adds nothing";
    EXPECT_EQ(text(0, TableColumn::floorArea), QString());
    EXPECT_EQ(tip(0, TableColumn::height), QStringLiteral("The scenario adds no building"));
    EXPECT_EQ(text(2, TableColumn::height), QStringLiteral("42.0")) << "12 storeys of 3.5 m";
    EXPECT_EQ(text(2, TableColumn::floorArea), QStringLiteral("4,800")) << "12 storeys of 400 m2";
    EXPECT_EQ(text(1, TableColumn::floorArea), QStringLiteral("2,000"));
    editTall(ChangeHeight{"New", 30});
    EXPECT_EQ(text(2, TableColumn::height), QStringLiteral("30.0"));
    EXPECT_EQ(text(2, TableColumn::floorArea), QString()) << "its floors are no longer known";
}

TEST_F(ScenarioTableWindow, FollowsTheUnitsInUse) {
    const auto heading = [this](TableColumn column) {
        return view->model()->headerData(column, Qt::Horizontal).toString();
    };
    EXPECT_EQ(heading(TableColumn::height), QStringLiteral("Height, m"));
    EXPECT_EQ(heading(TableColumn::floorArea), QStringLiteral("Floor area, m²"));
    applyUnits(UnitSystem::imperial);
    EXPECT_EQ(heading(TableColumn::floorArea), QStringLiteral("Floor area, sq ft"));
    EXPECT_EQ(text(2, TableColumn::height), QStringLiteral("137.8")) << "42 / 0.3048";
    EXPECT_EQ(text(2, TableColumn::floorArea), QStringLiteral("51,667")) << "4,800 / 0.3048^2";
    applyUnits(UnitSystem::both);
    EXPECT_EQ(heading(TableColumn::height), QStringLiteral("Height, m (ft)"));
    EXPECT_EQ(text(2, TableColumn::floorArea), QStringLiteral("4,800 (51,667)"));
}

// By hand: the sum over the cells of both studies of the difference in minutes.
double sumOfChange(const Study& before, const Study& after) {
    double minutes = 0;
    for (std::size_t i = 0; i < before.field.grossMin.size(); ++i) {
        const double more = double(after.field.grossMin[i]) - double(before.field.grossMin[i]);
        if (!std::isnan(more)) minutes += more;
    }
    const double cellM = before.field.grid.cellM;
    return minutes / before.field.sunlitMinutesPerDay * cellM * cellM;
}

TEST_F(ScenarioTableWindow, TheImpactComesFromTheStudiesAtHand) {
    EXPECT_EQ(text(2, TableColumn::impact), QString());
    EXPECT_THAT(tip(2, TableColumn::impact).toStdString(), HasSubstr("press Measure all"));
    press("measureAll");
    const auto studies = workbench().studies();
    ASSERT_EQ(studies.size(), 3U);
    const double expected = sumOfChange(*studies.at(existingCity), *studies.at("Tall"));
    EXPECT_GT(expected, 1);
    EXPECT_NEAR(value(2, TableColumn::impact), expected, 1e-3 * expected);
    EXPECT_TRUE(text(2, TableColumn::impact).startsWith(QLatin1Char('+')));
    EXPECT_GT(value(2, TableColumn::impact), value(1, TableColumn::impact)) << "the taller one shades more";
    EXPECT_EQ(text(0, TableColumn::impact), QString()) << "the baseline itself";
    EXPECT_THAT(tip(2, TableColumn::impact).toStdString(), HasSubstr("more than 30 min a day:\n"));
    session().compareWith("Low");
    settle();
    EXPECT_NEAR(value(2, TableColumn::impact), sumOfChange(*studies.at("Low"), *studies.at("Tall")), 0.5);
    EXPECT_EQ(text(1, TableColumn::impact), QString());
    EXPECT_LT(value(0, TableColumn::impact), 0) << "without the tower there is less shadow";
}

TEST_F(ScenarioTableWindow, FiguresOfBuildingsThatHaveChangedAreDropped) {
    press("measureAll");
    press("scoreAll");
    const QString impact = text(2, TableColumn::impact), score = text(2, TableColumn::score);
    ASSERT_FALSE(impact.isEmpty());
    ASSERT_FALSE(score.isEmpty());
    editTall(ChangeHeight{"New", 30});
    for (const TableColumn column : {TableColumn::shadowArea, TableColumn::impact, TableColumn::score}) {
        EXPECT_EQ(text(2, column), QString()) << column;
        EXPECT_THAT(tip(2, column).toStdString(), HasSubstr("ress ")) << "how to get it";
        EXPECT_FALSE(text(1, column).isEmpty()) << "the other scenario is as it was";
    }
    undo();
    EXPECT_EQ(text(2, TableColumn::impact), impact);
    EXPECT_EQ(text(2, TableColumn::score), score);
}

TEST_F(ScenarioTableWindow, TheScoreIsThatOfTheChosenWeights) {
    press("scoreAll");
    NoProgress progress;
    const auto expected = runScore(*session().cityOf("Tall").value(), workbench().document().settings(),
                                   session().project().weights[0], progress, {});
    ASSERT_TRUE(expected);
    EXPECT_DOUBLE_EQ(value(2, TableColumn::score), expected->scoreM2);
    EXPECT_FALSE(text(0, TableColumn::score).isEmpty());
    EXPECT_EQ(tip(2, TableColumn::score), QStringLiteral("With the weights default"));
    Project next = session().project();
    next.weights[0].intervals[0].weight = 0.25;
    ASSERT_TRUE(session().change(std::move(next), QStringLiteral("weights")));
    EXPECT_EQ(text(2, TableColumn::score), QString()) << "other weights";
    undo();
    EXPECT_FALSE(text(2, TableColumn::score).isEmpty());
}

TEST_F(ScenarioTableWindow, ASavedScoreCountsUntilItsScenarioChanges) {
    session().goTo("Tall");
    settle();
    workbench().runScore("default");
    settle();
    const QString score = text(2, TableColumn::score);
    ASSERT_FALSE(score.isEmpty());
    workbench().saveAnswer(QStringLiteral("Score"));
    ASSERT_TRUE(waitFor([this] { return session().project().results.size() == 1; }));
    save();
    makeWindow();
    open(file);
    settle();
    EXPECT_EQ(text(2, TableColumn::score), score) << "read from the project";
    editTall(ChangeHeight{"New", 30});
    EXPECT_EQ(text(2, TableColumn::score), QString());
}

TEST_F(ScenarioTableWindow, FiguresAreThereAgainWhenTheProjectIsOpenedAnotherDay) {
    Project next = session().project();
    next.weights.push_back(next.weights[0]);
    next.weights.back().name = "halves";
    for (WeightedInterval& interval : next.weights.back().intervals) interval.weight /= 2;
    ASSERT_TRUE(session().change(std::move(next), QStringLiteral("weights")));
    window->findChild<WeightsDock*>()->choose("halves");
    press("measureAll");
    press("scoreAll");
    const std::vector columns{TableColumn::shadowArea, TableColumn::gross, TableColumn::continuous,
                              TableColumn::impact, TableColumn::score};
    const auto texts = [&] {
        QStringList all;
        for (int row = 0; row < 3; ++row)
            for (const TableColumn column : columns) all << text(row, column);
        return all;
    };
    const QStringList before = texts();
    ASSERT_EQ(before.count(QString()), 1) << "the impact of the baseline itself";
    save();
    for (int day = 1; day <= 2; ++day) {
        makeWindow();
        open(file);
        settle();
        EXPECT_EQ(texts(), before) << day;
        save();  // without measuring again
    }
    EXPECT_THAT(tip(2, TableColumn::gross).toStdString(), HasSubstr("saved with the project"));
    const QString figures = QString::fromStdString(session().file()->project().view.at("figures"));
    EXPECT_EQ(figures.count(QStringLiteral("\"measured\"")), 3) << "each once, however often it is saved";
    editTall(ChangeHeight{"New", 30});
    for (const TableColumn column : columns) {
        EXPECT_EQ(text(2, column), QString()) << column;
        EXPECT_FALSE(text(1, column).isEmpty()) << column;
    }
    undo();
    EXPECT_EQ(texts(), before);
    StudySettings other = workbench().document().settings();
    other.period.days += 1;
    workbench().document().change(other, QStringLiteral("date"));
    EXPECT_EQ(text(2, TableColumn::impact), QString()) << "another question";
}

TEST_F(ScenarioTableWindow, FiguresOfAllScenariosAreUnsavedWork) {
    save();
    for (const char* button : {"measureAll", "scoreAll"}) {
        ASSERT_FALSE(session().hasUnsavedWork());
        press(button);
        EXPECT_TRUE(session().hasUnsavedWork()) << button << ": closing asks whether to save them";
        save();
    }
    EXPECT_FALSE(session().hasUnsavedWork());
}

TEST_F(ScenarioTableWindow, MeasuringAllGivesTheImpactWhateverTheEngineCounted) {
    StudySettings question = workbench().document().settings();
    question.engine = "horizon";
    question.receivers.cellM = 2;
    workbench().document().change(question, QStringLiteral("engine"));
    press("measureAll");
    // Its words state how many longest runs were decided by rays, which differs from scenario to scenario.
    EXPECT_FALSE(text(1, TableColumn::impact).isEmpty());
    EXPECT_FALSE(text(2, TableColumn::impact).isEmpty());
}

TEST_F(ScenarioTableWindow, VerdictsOfEachScenarioAreCountedUntilItChanges) {
    ReviewChoice choice = window->review().choice();
    choice.rule = "boston-common";  // no new shadow outside the first and the last hour
    window->review().choose(choice);
    EXPECT_THAT(tip(1, TableColumn::verdicts).toStdString(), HasSubstr("press Review all"));
    press("reviewAll");
    for (const int row : {1, 2})
        EXPECT_EQ(text(row, TableColumn::verdicts), QStringLiteral("1 ✗ fail, 1 ✓ pass"))
            << "the park beside the tower, and the far one";
    EXPECT_THAT(tip(2, TableColumn::verdicts).toStdString(), HasSubstr("compared with Existing"));
    EXPECT_EQ(text(0, TableColumn::verdicts), QString());
    editTall(Demolish{"New"});
    EXPECT_EQ(text(2, TableColumn::verdicts), QString());
    EXPECT_FALSE(text(1, TableColumn::verdicts).isEmpty());
    undo();
    EXPECT_FALSE(text(2, TableColumn::verdicts).isEmpty());
    choice.rule = "ceqr";
    window->review().choose(choice);
    EXPECT_EQ(text(1, TableColumn::verdicts), QString()) << "another rule";
}

TEST_F(ScenarioTableWindow, IsSortedByEachColumn) {
    press("measureAll");
    press("scoreAll");
    for (int column = 1; column < view->model()->columnCount(); ++column) {
        view->sortByColumn(column, Qt::DescendingOrder);
        for (int row = 1; row < view->model()->rowCount(); ++row) {
            const auto key = [&](int of) {
                return view->model()->index(of, column).data(ScenarioTable::sortRole).toDouble();
            };
            EXPECT_GE(key(row - 1), key(row)) << column << ", " << row;
        }
    }
    view->sortByColumn(TableColumn::height, Qt::DescendingOrder);
    EXPECT_EQ(view->model()->index(0, 0).data().toString(), QStringLiteral("Tall"));
    EXPECT_EQ(view->model()->index(2, 0).data().toString(), QStringLiteral("Existing"));
}

TEST_F(ScenarioTableWindow, ColumnsAreHiddenFromTheHeadingAndStayHidden) {
    auto* columns = view->horizontalHeader()->findChild<ColumnMenu*>();
    ASSERT_NE(columns, nullptr);
    std::unique_ptr<QMenu> menu(columns->makeMenu());
    ASSERT_EQ(menu->actions().size(), view->model()->columnCount() - 1) << "all but the name";
    QAction* gross = menu->actions()[TableColumn::gross - 1];
    EXPECT_EQ(gross->text(), QStringLiteral("Mean gross, min"));
    EXPECT_TRUE(gross->isChecked());
    gross->setChecked(false);
    EXPECT_TRUE(view->isColumnHidden(TableColumn::gross));
    menu.reset();  // before the heading, which owns it too
    makeWindow();
    view = window->findChild<QTableView*>(QStringLiteral("scenarioTable"));
    EXPECT_TRUE(view->isColumnHidden(TableColumn::gross));
    EXPECT_FALSE(view->isColumnHidden(TableColumn::height));
}

TEST_F(ScenarioTableWindow, TheExportedTableHasItsFiguresWithUnits) {
    press("measureAll");
    press("scoreAll");
    ExportChoice choice;
    choice.subject = ExportChoice::Subject::scenarios;
    const QString out = folder.filePath(QStringLiteral("out"));
    workbench().exportShown(out.toStdString(), choice);
    ASSERT_TRUE(waitFor([this] { return !workbench().writing().busy(); })) << message().toStdString();
    QFile csv(out + QStringLiteral("/scenarios.csv"));
    ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = csv.readAll().split('\n');
    ASSERT_GT(lines.size(), 3);
    const QList<QByteArray> heading = lines[0].trimmed().split(','), tall = lines[3].split(',');
    const auto field = [&](const char* name) {
        const auto at = heading.indexOf(name);
        return at < 0 ? QByteArray("no such column") : tall.value(at);
    };
    EXPECT_EQ(field("name"), "Tall");
    EXPECT_EQ(field("height_m"), "42.0");
    EXPECT_EQ(field("gross_floor_m2"), "4800.0");
    EXPECT_EQ(field("impact_baseline"), "Existing");
    EXPECT_NEAR(field("impact_m2").toDouble(), value(2, TableColumn::impact), 0.06);
    EXPECT_NEAR(field("score_m2").toDouble(), value(2, TableColumn::score), 0.06);
    EXPECT_EQ(field("pass"), "") << "not reviewed";
}

}  // namespace
}  // namespace noonmark
