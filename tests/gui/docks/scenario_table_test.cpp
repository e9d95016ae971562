#include "app/gui/docks/scenarios/scenario_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QBarSeries>
#include <QBarSet>
#include <QChart>
#include <QChartView>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTableView>
#include <QUndoStack>
#include <algorithm>
#include <cmath>

#include "app/gui/base/looks/units.h"
#include "app/gui/base/widgets/table_columns.h"
#include "app/gui/docks/scenarios/latest_answers.h"
#include "app/gui/docks/scenarios/scenarios_dock.h"
#include "app/gui/docks/weights/weights_dock.h"
#include "app/gui/frame/actions/scenario_actions.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::newTower;
using test::ProjectWindow;
using test::square;
using test::waitFor;
using testing::HasSubstr;

using TableColumn = std::string_view;

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
        return window->findChild<ScenariosDock*>()->table().index(row, scenarioColumn(column));
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
    [[nodiscard]] bool hasValue(int row, TableColumn column) const {
        return std::isfinite(value(row, column));
    }
    [[nodiscard]] bool isBest(int row, TableColumn column) const {
        return at(row, column).data(ScenarioTable::bestRole).toBool();
    }
    void tick(const char* box, bool on) {
        window->findChild<QCheckBox*>(QString::fromLatin1(box))->setChecked(on);
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

TEST_F(ScenarioTableWindow, WhatIsBeingComputedIsNotCalledMissing) {
    EXPECT_EQ(text(2, "score_m2"), QStringLiteral("not scored"));
    window->findChild<QPushButton*>(QStringLiteral("scoreAll"))->click();
    EXPECT_EQ(text(2, "score_m2"), QStringLiteral("being scored"));
    settle();
    EXPECT_TRUE(hasValue(2, "score_m2")) << text(2, "score_m2").toStdString();
}

TEST_F(ScenarioTableWindow, WhatWasMeasuredIsReadFirst) {
    const QHeaderView& heading = *view->horizontalHeader();
    const int score = scenarioColumn("score_m2"), height = scenarioColumn("height");
    EXPECT_EQ(heading.logicalIndex(0), 0) << "the name";
    EXPECT_LT(heading.visualIndex(height), heading.visualIndex(score));
    press("scoreAll");
    EXPECT_GT(heading.visualIndex(height), heading.visualIndex(score));
    EXPECT_LT(heading.visualIndex(height), heading.visualIndex(scenarioColumn("shadow_area_m2")))
        << "not measured";
}

TEST_F(ScenarioTableWindow, StatesHeightAndFloorAreaOfWhatAScenarioAdds) {
    EXPECT_EQ(text(0, "height"), QString()) << "the existing city adds nothing";
    EXPECT_EQ(text(0, "floor_area"), QString());
    EXPECT_EQ(tip(0, "height"), QStringLiteral("The scenario adds no building"));
    EXPECT_EQ(text(2, "height"), QStringLiteral("42.0")) << "12 storeys of 3.5 m";
    EXPECT_EQ(text(2, "floor_area"), QStringLiteral("4,800")) << "12 storeys of 400 m2";
    EXPECT_EQ(text(1, "floor_area"), QStringLiteral("2,000"));
    editTall(ChangeHeight{"New", 30});
    EXPECT_EQ(text(2, "height"), QStringLiteral("30.0"));
    EXPECT_EQ(text(2, "floor_area"), QStringLiteral("3,200")) << "8 storeys of 400 m2";
}

TEST_F(ScenarioTableWindow, FollowsTheUnitsInUse) {
    const auto heading = [this](TableColumn column) {
        return view->model()->headerData(scenarioColumn(column), Qt::Horizontal).toString();
    };
    EXPECT_EQ(heading("height"), QStringLiteral("Height, m"));
    EXPECT_EQ(heading("floor_area"), QStringLiteral("Floor area, m²"));
    applyUnits(UnitSystem::imperial);
    EXPECT_EQ(heading("floor_area"), QStringLiteral("Floor area, sq ft"));
    EXPECT_EQ(text(2, "height"), QStringLiteral("137.8")) << "42 / 0.3048";
    EXPECT_EQ(text(2, "floor_area"), QStringLiteral("51,667")) << "4,800 / 0.3048^2";
    applyUnits(UnitSystem::both);
    EXPECT_EQ(heading("height"), QStringLiteral("Height, m (ft)"));
    EXPECT_EQ(text(2, "floor_area"), QStringLiteral("4,800 (51,667)"));
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
    EXPECT_EQ(text(2, "shadow_area_change_m2"), QStringLiteral("not compared"));
    EXPECT_THAT(tip(2, "shadow_area_change_m2").toStdString(), HasSubstr("press Measure all"));
    press("measureAll");
    const auto studies = workbench().studies();
    ASSERT_EQ(studies.size(), 3U);
    const double expected = sumOfChange(*studies.at(existingCity), *studies.at("Tall"));
    EXPECT_GT(expected, 1);
    EXPECT_NEAR(value(2, "shadow_area_change_m2"), expected, 1e-3 * expected);
    EXPECT_TRUE(text(2, "shadow_area_change_m2").startsWith(QLatin1Char('+')));
    EXPECT_GT(value(2, "shadow_area_change_m2"), value(1, "shadow_area_change_m2"))
        << "the taller one shades more";
    EXPECT_EQ(text(0, "shadow_area_change_m2"), QString()) << "the baseline itself";
    EXPECT_THAT(tip(2, "shadow_area_change_m2").toStdString(), HasSubstr("more than 30 min a day:\n"));
    session().compareWith("Low");
    settle();
    EXPECT_NEAR(value(2, "shadow_area_change_m2"), sumOfChange(*studies.at("Low"), *studies.at("Tall")), 0.5);
    EXPECT_EQ(text(1, "shadow_area_change_m2"), QString());
    EXPECT_LT(value(0, "shadow_area_change_m2"), 0) << "without the tower there is less shadow";
}

TEST_F(ScenarioTableWindow, FiguresOfBuildingsThatHaveChangedAreDropped) {
    press("measureAll");
    press("scoreAll");
    const QString impact = text(2, "shadow_area_change_m2"), score = text(2, "score_m2");
    ASSERT_FALSE(impact.isEmpty());
    ASSERT_FALSE(score.isEmpty());
    editTall(ChangeHeight{"New", 30});
    for (const TableColumn column :
         std::vector<TableColumn>{"shadow_area_m2", "shadow_area_change_m2", "score_m2"}) {
        EXPECT_EQ(text(2, column), QStringLiteral("out of date")) << column;
        EXPECT_THAT(tip(2, column).toStdString(), HasSubstr("ress ")) << "how to get it";
        EXPECT_TRUE(hasValue(1, column)) << "the other scenario is as it was";
    }
    undo();
    EXPECT_EQ(text(2, "shadow_area_change_m2"), impact);
    EXPECT_EQ(text(2, "score_m2"), score);
}

TEST_F(ScenarioTableWindow, TheScoreIsThatOfTheChosenWeights) {
    press("scoreAll");
    NoProgress progress;
    const auto expected = runScore(*session().cityOf("Tall").value(), workbench().document().settings(),
                                   session().project().weights[0], progress, {});
    ASSERT_TRUE(expected);
    EXPECT_DOUBLE_EQ(value(2, "score_m2"), expected->scoreM2);
    EXPECT_TRUE(hasValue(0, "score_m2"));
    EXPECT_THAT(tip(2, "score_m2").toStdString(), HasSubstr("With the weights default"));
    Project next = session().project();
    next.weights[0].intervals[0].weight = 0.25;
    ASSERT_TRUE(session().change(std::move(next), QStringLiteral("weights")));
    EXPECT_EQ(text(2, "score_m2"), QStringLiteral("out of date")) << "other weights";
    undo();
    EXPECT_TRUE(hasValue(2, "score_m2"));
}

TEST_F(ScenarioTableWindow, ASavedScoreCountsUntilItsScenarioChanges) {
    session().goTo("Tall");
    settle();
    workbench().runScore("default");
    settle();
    const QString score = text(2, "score_m2");
    ASSERT_FALSE(score.isEmpty());
    workbench().saveAnswer(QStringLiteral("Score"));
    ASSERT_TRUE(waitFor([this] { return session().project().results.size() == 1; }));
    save();
    makeWindow();
    open(file);
    settle();
    EXPECT_EQ(text(2, "score_m2"), score) << "read from the project";
    editTall(ChangeHeight{"New", 30});
    EXPECT_EQ(text(2, "score_m2"), QStringLiteral("out of date"));
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
    const std::vector<TableColumn> columns{"shadow_area_m2", "mean_gross_min", "mean_continuous_min",
                                           "shadow_area_change_m2", "score_m2"};
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
    EXPECT_THAT(tip(2, "mean_gross_min").toStdString(), HasSubstr("saved with the project"));
    const QString figures = QString::fromStdString(session().file()->project().view.at("figures"));
    EXPECT_EQ(figures.count(QStringLiteral("\"measured\"")), 3) << "each once, however often it is saved";
    editTall(ChangeHeight{"New", 30});
    for (const TableColumn column : columns) {
        EXPECT_EQ(text(2, column), QStringLiteral("out of date")) << column;
        EXPECT_TRUE(hasValue(1, column)) << column;
    }
    undo();
    EXPECT_EQ(texts(), before);
    StudySettings other = workbench().document().settings();
    other.period.days += 1;
    workbench().document().change(other, QStringLiteral("date"));
    EXPECT_EQ(text(2, "shadow_area_change_m2"), QStringLiteral("out of date")) << "another question";
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
    EXPECT_TRUE(hasValue(1, "shadow_area_change_m2"));
    EXPECT_TRUE(hasValue(2, "shadow_area_change_m2"));
}

TEST_F(ScenarioTableWindow, OneSentenceJudgesWhichScenarioTakesLessSun) {
    const auto verdict = [this] {
        return window->findChild<QLabel*>(QStringLiteral("scenarioVerdict"))->text().toStdString();
    };
    EXPECT_EQ(verdict(), "");
    press("measureAll");
    EXPECT_THAT(verdict(), testing::StartsWith("Low adds less shadow than Tall: +"));
    EXPECT_THAT(verdict(), HasSubstr(text(1, "shadow_area_change_m2").toStdString()));
    EXPECT_THAT(verdict(), HasSubstr(text(2, "shadow_area_change_m2").toStdString()));
    EXPECT_THAT(verdict(), HasSubstr("over 30 min more a day"));
}

TEST_F(ScenarioTableWindow, VerdictsOfEachScenarioAreCountedUntilItChanges) {
    ReviewChoice choice = window->review().choice();
    choice.rule = "boston-common";  // no new shadow outside the first and the last hour
    window->review().choose(choice);
    EXPECT_THAT(tip(1, "verdicts").toStdString(), HasSubstr("press Review all"));
    press("reviewAll");
    for (const int row : {1, 2})
        EXPECT_EQ(text(row, "verdicts"), QStringLiteral("1 ✗ fail, 1 ✓ pass"))
            << "the park beside the tower, and the far one";
    EXPECT_THAT(tip(2, "verdicts").toStdString(), HasSubstr("compared with Existing"));
    EXPECT_EQ(text(0, "verdicts"), QString());
    editTall(Demolish{"New"});
    EXPECT_EQ(text(2, "verdicts"), QStringLiteral("out of date"));
    EXPECT_TRUE(hasValue(1, "verdicts"));
    undo();
    EXPECT_TRUE(hasValue(2, "verdicts"));
    choice.rule = "ceqr";
    window->review().choose(choice);
    EXPECT_EQ(text(1, "verdicts"), QStringLiteral("out of date")) << "another rule";
}

TEST_F(ScenarioTableWindow, MarksTheBestValueOfEachColumn) {
    for (int row = 0; row < 3; ++row) EXPECT_FALSE(isBest(row, "shadow_area_m2")) << "nothing is measured";
    press("measureAll");
    press("scoreAll");
    EXPECT_TRUE(isBest(0, "shadow_area_m2")) << "without the tower there is least shadow";
    EXPECT_FALSE(isBest(1, "shadow_area_m2"));
    EXPECT_FALSE(isBest(2, "shadow_area_m2"));
    EXPECT_TRUE(isBest(1, "shadow_area_change_m2")) << "of those that are compared";
    EXPECT_FALSE(isBest(2, "height")) << "no height is better than another";
    int best = 0;
    for (int row = 0; row < 3; ++row) {
        if (isBest(row, "score_m2")) best = row;
    }
    for (int row = 0; row < 3; ++row) EXPECT_LE(value(row, "score_m2"), value(best, "score_m2"));
    EXPECT_THAT(tip(0, "shadow_area_m2").toStdString(), HasSubstr("Best of this column"));
    tick("shadeWanted", true);
    EXPECT_TRUE(isBest(2, "shadow_area_m2")) << "the taller one shades more";
    EXPECT_FALSE(isBest(0, "shadow_area_m2"));
    EXPECT_TRUE(isBest(best, "score_m2")) << "the weights say which shade is wanted";
}

TEST_F(ScenarioTableWindow, ShowsDifferencesToTheBaseline) {
    press("measureAll");
    const double existing = value(0, "shadow_area_m2"), tall = value(2, "shadow_area_m2");
    tick("scenarioDifferences", true);
    EXPECT_DOUBLE_EQ(value(0, "shadow_area_m2"), existing) << "the baseline's own";
    EXPECT_DOUBLE_EQ(value(2, "shadow_area_m2"), tall - existing);
    EXPECT_TRUE(text(2, "shadow_area_m2").startsWith(QLatin1Char('+')));
    EXPECT_EQ(text(2, "score_m2"), QStringLiteral("not scored"));
    session().compareWith("Tall");
    settle();
    EXPECT_DOUBLE_EQ(value(0, "shadow_area_m2"), existing - tall);
    EXPECT_EQ(text(1, "changes"), QStringLiteral("1")) << "no figure to compare";
    EXPECT_EQ(text(1, "height"), QStringLiteral("-24.5")) << "17.5 m against 42 m";
}

TEST_F(ScenarioTableWindow, TheCsvStatesWhatEachScenarioLacksAndWhy) {
    press("measureAll");
    editTall(ChangeHeight{"New", 30});
    const QString out = folder.filePath(QStringLiteral("table.csv"));
    window->findChild<ScenarioActions*>()->saveTable(out);
    const QStringList lines = QString::fromUtf8(test::bytesOf(out)).split(QStringLiteral("\r\n"));
    EXPECT_TRUE(lines[0].startsWith(QStringLiteral("scenario,changes,height,floor_area,shadow_area_m2,")));
    EXPECT_TRUE(lines[0].endsWith(QStringLiteral(",region,period,enough_hours,lacks")));
    EXPECT_TRUE(lines[0].contains(QStringLiteral(",shadow_area_m2_difference,")));
    EXPECT_TRUE(lines[2].startsWith(QStringLiteral("Low,1,17.5,2000,")));
    EXPECT_TRUE(
        lines[2].endsWith(QStringLiteral("weighted_shade_m2h: not scored; verdicts: not reviewed\"")));
    EXPECT_THAT(lines[3].toStdString(), HasSubstr("shadow_area_m2: out of date; hours_mean: not measured; "
                                                  "shadow_area_change_m2: out of date"));
    ScenarioTable& table = window->findChild<ScenariosDock*>()->table();
    const std::string whole = table.csv();
    table.setDifferences(true);
    EXPECT_EQ(table.csv(), whole) << "whatever the table shows";
    table.setDifferences(false);
    window->findChild<QPushButton*>(QStringLiteral("copyScenarios"))->click();
    EXPECT_TRUE(QGuiApplication::clipboard()->text().startsWith(QStringLiteral("Scenario\tChanges\t")));
}

TEST_F(ScenarioTableWindow, NamesStayInSightWhenTheTableIsScrolled) {
    auto* names = view->findChild<QTableView*>(QStringLiteral("frozenColumn"));
    ASSERT_NE(names, nullptr);
    EXPECT_FALSE(names->isColumnHidden(0));
    for (int column = 1; column < view->model()->columnCount(); ++column)
        EXPECT_TRUE(names->isColumnHidden(column)) << column;
    EXPECT_EQ(names->columnWidth(0), view->columnWidth(0));
    view->sortByColumn(scenarioColumn("height"), Qt::DescendingOrder);
    EXPECT_EQ(names->model()->index(0, 0).data().toString(), QStringLiteral("Tall"));
    Q_EMIT names->doubleClicked(names->model()->index(0, 0));
    EXPECT_EQ(session().scenario(), "Tall");
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
    view->sortByColumn(scenarioColumn("height"), Qt::DescendingOrder);
    EXPECT_EQ(view->model()->index(0, 0).data().toString(), QStringLiteral("Tall"));
    EXPECT_EQ(view->model()->index(2, 0).data().toString(), QStringLiteral("Existing"));
}

TEST_F(ScenarioTableWindow, ColumnsAreHiddenFromTheHeadingAndStayHidden) {
    auto* columns = view->horizontalHeader()->findChild<ColumnMenu*>();
    ASSERT_NE(columns, nullptr);
    std::unique_ptr<QMenu> menu(columns->makeMenu());
    ASSERT_EQ(menu->actions().size(), view->model()->columnCount() - 1) << "all but the name";
    QAction* gross = menu->actions()[scenarioColumn("mean_gross_min") - 1];
    EXPECT_EQ(gross->text(), QStringLiteral("Mean gross, min"));
    EXPECT_TRUE(gross->isChecked());
    gross->setChecked(false);
    EXPECT_TRUE(view->isColumnHidden(scenarioColumn("mean_gross_min")));
    menu.reset();  // before the heading, which owns it too
    makeWindow();
    view = window->findChild<QTableView*>(QStringLiteral("scenarioTable"));
    EXPECT_TRUE(view->isColumnHidden(scenarioColumn("mean_gross_min")));
    EXPECT_FALSE(view->isColumnHidden(scenarioColumn("height")));
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
    EXPECT_NEAR(field("impact_m2").toDouble(), value(2, "shadow_area_change_m2"), 0.06);
    EXPECT_NEAR(field("score_m2").toDouble(), value(2, "score_m2"), 0.06);
    EXPECT_EQ(field("pass"), "") << "not reviewed";
}

// A building over the whole region leaves no open ground to measure.
Edit coverOf(const Region& region) {
    const Box2 box = bounds(region.polygons.front());
    const glm::vec2 size = box.high - box.low;
    const Footprint outline = square(box.low - 5.0F, std::max(size.x, size.y) + 10);
    Building building{.sourceId = "Cover", .name = "Cover"};
    building.parts.push_back({.sourceId = "Cover", .footprint = outline, .topM = 10});
    return AddBuilding{std::make_shared<const Building>(std::move(building)), nullptr};
}

TEST_F(ScenarioTableWindow, AScenarioThatFailsSaysWhyInItsRowAndTheOthersAreMeasured) {
    Project next = session().project();
    next.scenarios[0].edits = {coverOf(next.regions[0])};
    ASSERT_TRUE(session().change(std::move(next), QStringLiteral("cover")));
    session().goTo(existingCity);
    settle();
    press("measureAll");
    EXPECT_TRUE(hasValue(0, "shadow_area_m2"));
    EXPECT_TRUE(hasValue(2, "shadow_area_m2")) << "it comes after the one that fails";
    EXPECT_EQ(text(1, "shadow_area_m2"), QStringLiteral("failed"));
    EXPECT_THAT(tip(1, "shadow_area_m2").toStdString(), HasSubstr("open ground"));
    EXPECT_THAT(message().toStdString(), HasSubstr("Low"));
    press("scoreAll");
    EXPECT_TRUE(hasValue(2, "score_m2"));
    EXPECT_EQ(text(1, "score_m2"), QStringLiteral("failed"));
    const std::string csv = window->findChild<ScenariosDock*>()->table().csv();
    EXPECT_THAT(csv, HasSubstr("shadow_area_m2: ")) << "what it lacks, and why";
}

TEST_F(ScenarioTableWindow, ScoresAloneAreExportedAsATable) {
    EXPECT_FALSE(workbench().hasScenarioAnswers());
    press("scoreAll");
    ASSERT_TRUE(workbench().hasScenarioAnswers());
    ExportChoice choice;
    choice.subject = ExportChoice::Subject::table;
    const std::filesystem::path out = folder.filePath(QStringLiteral("out")).toStdString();
    workbench().exportShown(out, choice);
    ASSERT_TRUE(waitFor([&] { return !workbench().writing().busy(); }));
    QFile file(QString::fromStdString((out / "scenario_table.csv").string()));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << message().toStdString();
    EXPECT_EQ(file.readAll().toStdString(), window->findChild<ScenariosDock*>()->table().csv());
}

struct ScenarioChartsWindow : ScenarioTableWindow {
    void choose(const char* figure) {
        auto* list = window->findChild<QComboBox*>(QStringLiteral("scenarioChart"));
        list->setCurrentIndex(list->findData(QString::fromLatin1(figure)));
    }
    [[nodiscard]] QList<QChartView*> charts() const {
        return window->findChild<ScenarioCharts*>()->findChildren<QChartView*>();
    }
    [[nodiscard]] std::string note() const {
        return window->findChild<QLabel*>(QStringLiteral("scenarioChartNote"))->text().toStdString();
    }
    void measureMonths() {
        StudySettings question = workbench().document().settings();
        question.byMonth = true;
        question.engine = "horizon";
        workbench().document().change(question, QStringLiteral("months"));
        settle();
        press("measureAll");
    }
};

TEST_F(ScenarioChartsWindow, ShowTheMonthsOfAllScenariosAboveTheirDifferences) {
    choose("sun_hours");
    EXPECT_TRUE(charts().isEmpty());
    EXPECT_THAT(note(), HasSubstr("Measure all")) << "how to get months";
    measureMonths();
    choose("");
    choose("sun_hours");
    ASSERT_EQ(charts().size(), 2);
    const auto* hours = qobject_cast<QBarSeries*>(charts()[0]->chart()->series().front());
    const auto* changes = qobject_cast<QBarSeries*>(charts()[1]->chart()->series().front());
    ASSERT_EQ(hours->barSets().size(), 3);
    ASSERT_EQ(changes->barSets().size(), 2) << "the baseline does not differ from itself";
    EXPECT_NEAR(changes->barSets()[1]->at(0), hours->barSets()[2]->at(0) - hours->barSets()[0]->at(0), 1e-9);
    EXPECT_LT(changes->barSets()[1]->at(0), 0) << "the tall tower takes sun";
    EXPECT_EQ(changes->barSets()[0]->color(), hours->barSets()[1]->color()) << "a scenario keeps its colour";
    EXPECT_NE(hours->barSets()[1]->color(), hours->barSets()[2]->color());
}

TEST_F(ScenarioChartsWindow, ShowScoresByMonthAlsoAfterTheProjectWasOpenedAgain) {
    choose("score_m2");
    EXPECT_THAT(note(), HasSubstr("Score all"));
    press("scoreAll");
    choose("shadow_area_m2");
    EXPECT_EQ(charts().size(), 2) << "a score counts the shadow area of its months";
    choose("all");
    EXPECT_GE(charts().size(), 4) << "shadow area and score together";
    EXPECT_EQ(note(), "");
    choose("score_m2");
    ASSERT_EQ(charts().size(), 2);
    const QString file = folder.filePath(QStringLiteral("months.csv"));
    window->findChild<ScenarioActions*>()->saveMonths(file);
    QFile saved(file);
    ASSERT_TRUE(saved.open(QFile::ReadOnly));
    const QByteArray csv = saved.readAll();
    EXPECT_TRUE(csv.startsWith("scenario,month,shadow_area_m2,")) << csv.toStdString();
    EXPECT_TRUE(csv.contains("\r\nTall,")) << csv.toStdString();
    const auto figures = parseViewFigures(window->answers().figuresToSave());
    const auto scored =
        std::ranges::find_if(figures, [](const auto& one) { return one.figures.weights.has_value(); });
    ASSERT_NE(scored, figures.end());
    EXPECT_FALSE(scored->figures.scoreMonths.empty()) << "saved with the project";
}

}  // namespace
}  // namespace noonmark
