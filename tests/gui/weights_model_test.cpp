#include "app/gui/docks/weights/weights_model.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QUndoStack>
#include <random>

#include "app/gui/docks/weights/weights_dock.h"
#include "app/gui/session/project/project_session.h"
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

}  // namespace
}  // namespace noonmark
