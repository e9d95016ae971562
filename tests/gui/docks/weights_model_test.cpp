#include "app/gui/docks/weights/weights_model.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QUndoStack>
#include <random>

#include "app/gui/docks/weights/weights_dock.h"
#include "app/gui/session/project/project_session.h"
#include "core/city/city.h"
#include "scenarios/weights/edit_weights.h"
#include "tests/gui/small_project.h"

namespace noonmark {
namespace {

using namespace std::chrono;
using Mode = QAbstractItemModelTester::FailureReportingMode;
using Column = WeightsModel::Column;

struct Weights : ::testing::Test {
    QUndoStack undo;
    ProjectSession session{undo};
    WeightsModel model{session};
    QAbstractItemModelTester tester{&model, Mode::Fatal};
    QString refusal;

    void SetUp() override {
        session.open(test::smallProject(), {}, existingCity);
        model.setTable("default");
        QObject::connect(&model, &WeightsModel::refused,
                         [this](const Error& error) { refusal = QString::fromStdString(error.text()); });
    }
    bool set(int row, Column column, const char* text) {
        refusal.clear();
        return model.setData(model.index(row, column), QString::fromUtf8(text));
    }
    const WeightedInterval& interval(int row) {
        return session.project().weights[0].intervals[std::size_t(row)];
    }
    QString shown(int row, Column column) { return model.index(row, column).data().toString(); }
};

TEST_F(Weights, ShowTheTableOfTheProject) {
    ASSERT_EQ(model.rowCount(), 12);
    EXPECT_EQ(shown(5, Column::intervalName), QStringLiteral("June"));
    EXPECT_EQ(shown(5, Column::firstDay), QStringLiteral("1 Jun"));
    EXPECT_EQ(shown(5, Column::lastDay), QStringLiteral("30 Jun"));
    EXPECT_EQ(shown(5, Column::toHour), QStringLiteral("24:00"));
    EXPECT_EQ(shown(2, Column::intervalWeight), QStringLiteral("-0.5"));
    EXPECT_EQ(model.index(2, 0).data(Qt::UserRole).toDouble(), -0.5);
}

TEST_F(Weights, EachEditIsOneStepOfUndo) {
    EXPECT_TRUE(set(5, Column::intervalWeight, "0.25"));
    EXPECT_TRUE(set(5, Column::fromHour, " 09:30 "));
    EXPECT_TRUE(set(5, Column::intervalName, "June days"));
    EXPECT_EQ(undo.count(), 3);
    EXPECT_EQ(interval(5).weight, 0.25);
    EXPECT_EQ(interval(5).from, 9h + 30min);
    undo.undo();
    undo.undo();
    EXPECT_EQ(interval(5).name, "June");
    EXPECT_EQ(interval(5).from, 0h);
    EXPECT_EQ(interval(5).weight, 0.25);
    EXPECT_TRUE(set(5, Column::intervalWeight, "0.25")) << "nothing differs";
    EXPECT_EQ(undo.count(), 3);
}

TEST_F(Weights, MonthsStandForTheirDays) {
    EXPECT_TRUE(model.removeRow(6));
    EXPECT_TRUE(set(5, Column::lastDay, "july"));
    EXPECT_EQ(interval(5).last, July / 31);
}

TEST_F(Weights, WhatIsOutOfRangeIsRefusedInItsPlace) {
    EXPECT_FALSE(set(5, Column::intervalWeight, "1.5"));
    EXPECT_TRUE(refusal.contains(QStringLiteral("row 6: '1.5' is not a weight"))) << refusal.toStdString();
    EXPECT_FALSE(set(5, Column::intervalWeight, "much"));
    EXPECT_FALSE(set(5, Column::firstDay, "06-31"));
    EXPECT_TRUE(refusal.contains(QStringLiteral("row 6, first"))) << refusal.toStdString();
    EXPECT_FALSE(set(5, Column::toHour, "25:00"));
    EXPECT_FALSE(set(5, Column::fromHour, "24:00"));
    EXPECT_TRUE(refusal.contains(QStringLiteral("two different hours"))) << refusal.toStdString();
    EXPECT_FALSE(set(5, Column::lastDay, "07-02"));
    EXPECT_TRUE(refusal.contains(QStringLiteral("'June' and 'July' overlap"))) << refusal.toStdString();
    EXPECT_EQ(undo.count(), 0);
    EXPECT_EQ(session.project().weights[0], makeMonthlyWeights());
}

TEST_F(Weights, RowsComeAndGo) {
    const int row = model.add(5);
    EXPECT_EQ(row, 6);
    ASSERT_EQ(model.rowCount(), 13);
    EXPECT_EQ(interval(6).first, June / 16);
    EXPECT_TRUE(model.removeRow(0));
    EXPECT_EQ(model.rowCount(), 12);
    EXPECT_EQ(model.add(11), 12) << "January is free";
    EXPECT_EQ(interval(12).first, January / 1);
    EXPECT_EQ(undo.count(), 3);
    while (undo.canUndo()) undo.undo();
    EXPECT_EQ(session.project().weights[0], makeMonthlyWeights());
    for (int i = 0; i < 11; ++i) EXPECT_TRUE(model.removeRow(0));
    EXPECT_FALSE(model.removeRow(0));
    EXPECT_TRUE(refusal.contains(QStringLiteral("no intervals"))) << refusal.toStdString();
}

TEST_F(Weights, TheTableKeepsItsRowsUnderAnotherName) {
    ASSERT_TRUE(session.rename(ProjectPart::weights, "default", "paper"));
    EXPECT_EQ(model.table().name, "paper");
    EXPECT_EQ(model.rowCount(), 12);
    undo.undo();
    EXPECT_EQ(model.table().name, "default");
    ASSERT_TRUE(session.change(without(session.project(), ProjectPart::weights, "default").value(),
                               QStringLiteral("delete")));
    EXPECT_EQ(model.rowCount(), 0);
    EXPECT_EQ(model.add(0), -1);
    undo.undo();
    EXPECT_EQ(model.rowCount(), 12);
}

// The model tester checks rows and signals after each of many random edits.
TEST_F(Weights, HoldThroughRandomEditsUndoAndRedo) {
    std::mt19937 random(7);
    const auto any = [&](int below) { return int(random() % unsigned(std::max(1, below))); };
    for (int i = 0; i < 300; ++i) {
        switch (any(6)) {
            case 0:
                model.add(any(model.rowCount()));
                break;
            case 1:
                model.removeRow(any(model.rowCount()));
                break;
            case 2:
                undo.undo();
                break;
            case 3:
                undo.redo();
                break;
            case 4:
                set(any(model.rowCount()), Column::intervalWeight, any(2) == 0 ? "0.75" : "7");
                break;
            default:
                set(any(model.rowCount()), Column::lastDay, any(2) == 0 ? "05-15" : "nov");
                break;
        }
        ASSERT_EQ(model.table(), session.project().weights[0]);
        ASSERT_EQ(std::size_t(model.rowCount()), session.project().weights[0].intervals.size());
    }
}

TEST_F(Weights, TheDockEditsScoresAndSaysWhatIsRefused) {
    WeightsDock dock(session);
    dock.choose("default");
    const auto* refused = dock.findChild<QLabel*>(QStringLiteral("refusal"));
    dock.model().setData(dock.model().index(0, Column::intervalWeight), QStringLiteral("-2"));
    EXPECT_FALSE(refused->isHidden());
    dock.model().setData(dock.model().index(0, Column::intervalWeight), QStringLiteral("-0.9"));
    EXPECT_TRUE(refused->isHidden());
    dock.findChild<QPushButton*>(QStringLiteral("newTable"))->click();
    EXPECT_EQ(dock.findChild<QComboBox*>()->currentText(), QStringLiteral("my weights"));
    EXPECT_EQ(session.project().weights[1].intervals, makeMonthlyWeights().intervals);
    auto* view = dock.findChild<QTableView*>();
    view->setCurrentIndex(dock.model().index(3, 0));
    dock.findChild<QPushButton*>(QStringLiteral("addInterval"))->click();
    EXPECT_EQ(session.project().weights[1].intervals.size(), 13U);
    EXPECT_EQ(view->currentIndex().row(), 4);
    dock.findChild<QPushButton*>(QStringLiteral("removeInterval"))->click();
    EXPECT_EQ(session.project().weights[1].intervals.size(), 12U);
    std::string scored;
    QObject::connect(&dock, &WeightsDock::scoreRequested, [&](const std::string& name) { scored = name; });
    dock.findChild<QPushButton*>(QStringLiteral("score"))->click();
    EXPECT_EQ(scored, "my weights");
    undo.undo();
    undo.undo();
    undo.undo();
    EXPECT_EQ(dock.findChild<QComboBox*>()->currentText(), QStringLiteral("default"));
}

TEST_F(Weights, AllColumnsAreInSightInTheNarrowestDock) {
    WeightsDock dock(session);
    dock.resize(dock.minimumSizeHint().width(), 400);
    dock.show();
    QCoreApplication::processEvents();
    const auto* view = dock.findChild<QTableView*>();
    EXPECT_LE(dock.width(), 330) << "it must fit beside the view";
    EXPECT_LE(view->horizontalHeader()->length(), view->viewport()->width());
    for (int column = 0; column < dock.model().columnCount(); ++column)
        EXPECT_GE(view->columnWidth(column), 30) << column;
}

/// The calendar of a dock that is shown, by mouse and keys.
struct WeightCalendarOf {
    explicit WeightCalendarOf(ProjectSession& session) : dock(std::make_unique<WeightsDock>(session)) {
        dock->choose("default");
        dock->resize(340, 700);
        dock->show();
        calendar = dock->findChild<WeightCalendar*>();
    }
    void drag(Qt::MouseButton button, std::pair<int, int> from, std::pair<int, int> to) const {
        const auto at = [&](std::pair<int, int> cell) {
            return calendar->cellAt(cell.first, cell.second).center().toPoint();
        };
        QTest::mousePress(calendar, button, {}, at(from));
        QTest::mouseMove(calendar, at(to));
        QTest::mouseRelease(calendar, button, {}, at(to));
    }
    [[nodiscard]] WeightCell cell(int month, int hour) const {
        return weightGrid(dock->model().table())[std::size_t(month)][std::size_t(hour)];
    }
    std::unique_ptr<WeightsDock> dock;
    WeightCalendar* calendar;
};

TEST_F(Weights, TheCalendarIsPaintedErasedAndUndone) {
    const WeightCalendarOf shown(session);
    const TimeWeights before = session.project().weights[0];
    QTest::mouseClick(shown.calendar, Qt::LeftButton, {}, shown.calendar->swatchOf(0.25).center().toPoint());
    EXPECT_EQ(shown.calendar->brush(), 0.25);
    shown.drag(Qt::LeftButton, {7, 16}, {5, 12});
    EXPECT_EQ(shown.cell(5, 12).weight, 0.25) << "the drag goes in any direction";
    EXPECT_EQ(shown.cell(7, 16).weight, 0.25);
    EXPECT_EQ(shown.cell(7, 17).weight, 1) << "as it was";
    EXPECT_EQ(shown.cell(4, 12).weight, 0.5);
    EXPECT_EQ(undo.count(), 1) << "one step for a drag";
    shown.drag(Qt::RightButton, {6, 14}, {6, 14});
    EXPECT_FALSE(shown.cell(6, 14).isHeld);
    EXPECT_TRUE(shown.cell(6, 13).isHeld);
    undo.undo();
    undo.undo();
    EXPECT_EQ(session.project().weights[0], before);
    shown.drag(Qt::RightButton, {0, 0}, {11, 23});
    EXPECT_EQ(session.project().weights[0], before) << "a table cannot be empty";
    EXPECT_FALSE(shown.dock->findChild<QLabel*>(QStringLiteral("refusal"))->isHidden());
}

TEST_F(Weights, TheCalendarIsPaintedByKeys) {
    const WeightCalendarOf shown(session);
    QTest::keyClick(shown.calendar, Qt::Key_Minus);
    EXPECT_EQ(shown.calendar->brush(), 0.75);
    QTest::keyClick(shown.calendar, Qt::Key_Right);
    QTest::keyClick(shown.calendar, Qt::Key_Down, Qt::ShiftModifier);
    QTest::keyClick(shown.calendar, Qt::Key_Return);
    EXPECT_EQ(shown.cell(5, 13).weight, 0.75) << "June, one hour after the first cell";
    EXPECT_EQ(shown.cell(6, 13).weight, 0.75);
    EXPECT_EQ(shown.cell(5, 12).weight, 1);
    QTest::keyClick(shown.calendar, Qt::Key_Delete);
    EXPECT_FALSE(shown.cell(6, 13).isHeld);
}

TEST_F(Weights, TemplatesBecomeTablesOfTheProject) {
    WeightsDock dock(session);
    QMenu* menu = dock.findChild<QPushButton*>(QStringLiteral("weightTemplates"))->menu();
    ASSERT_NE(menu, nullptr);
    const auto take = [&](int entry) {
        Q_EMIT menu->aboutToShow();
        menu->actions()[entry]->trigger();
    };
    const double latitude = session.city()->frame.origin().latDeg;
    take(0);
    EXPECT_EQ(session.project().weights.back(), makeComfortWeights(latitude));
    EXPECT_EQ(dock.findChild<QComboBox*>()->currentText(), QStringLiteral("pedestrian comfort"));
    take(1);
    EXPECT_EQ(session.project().weights.back(), makePlantWeights(latitude));
    take(3);  // after the separator: as the first table of the project
    EXPECT_EQ(session.project().weights.back().intervals, session.project().weights[0].intervals);
    EXPECT_NE(session.project().weights.back().name, session.project().weights[0].name);
    for (int i = 0; i < 3; ++i) undo.undo();
    EXPECT_EQ(session.project().weights.size(), 1U);
}

}  // namespace
}  // namespace noonmark
