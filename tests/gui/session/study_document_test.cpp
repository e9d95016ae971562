#include "app/gui/session/study/study_document.h"
#include "app/gui/docks/study_form/study_dock.h"
#include "app/input/all_engines.h"
#include "app/input/load_city.h"
#include "core/city/terrain/terrain.h"
#include "tests/gui/small_city.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QDateEdit>
#include <QDoubleSpinBox>
#include <QSpinBox>

namespace noonmark {
namespace {

StudySettings withCell(StudySettings settings, double cellM) {
    settings.receivers.cellM = cellM;
    return settings;
}

TEST(StudyDocument, UndoAndRedoChangesOfSettings) {
    StudyDocument document;
    const StudySettings before = document.settings();
    document.change(withCell(before, 4), QStringLiteral("cell size"));
    StudySettings later = document.settings();
    later.period.days = 30;
    document.change(later, QStringLiteral("days"));
    document.undoStack().undo();
    EXPECT_EQ(document.settings().period.days, 1);
    EXPECT_EQ(document.settings().receivers.cellM, 4);
    document.undoStack().undo();
    EXPECT_EQ(document.settings(), before);
    document.undoStack().redo();
    document.undoStack().redo();
    EXPECT_EQ(document.settings(), later);
}

TEST(StudyDocument, StepsOfOneFieldAreOneUndo) {
    StudyDocument document;
    const StudySettings before = document.settings();
    for (const double cell : {2.0, 3.0, 4.0})
        document.change(withCell(before, cell), QStringLiteral("cell size"));
    EXPECT_EQ(document.undoStack().count(), 1);
    document.undoStack().undo();
    EXPECT_EQ(document.settings(), before);
}

TEST(StudyDocument, EveryRegionIsAnUndoOfItsOwn) {
    StudyDocument document;
    for (const float size : {10.0F, 20.0F}) {
        StudySettings settings = document.settings();
        settings.region = makeRegionFromLocalBox({{0, 0}, {size, size}});
        document.change(settings, QStringLiteral("region"));
    }
    document.undoStack().undo();
    EXPECT_EQ(bounds(document.settings().region).high.x, 10);
}

TEST(StudyDocument, WhatDoesNotDifferIsNoChange) {
    StudyDocument document;
    document.change(document.settings(), QStringLiteral("days"));
    EXPECT_FALSE(document.undoStack().canUndo());
}

TEST(StudyDock, FieldsChangeTheDocumentAndUndoChangesTheFields) {
    StudyDocument document;
    const StudyDock dock(document);
    dock.findChild<QDateEdit*>(QStringLiteral("startDate"))->setDate(QDate(2026, 6, 21));
    dock.findChild<QSpinBox*>(QStringLiteral("days"))->setValue(7);
    dock.findChild<QDoubleSpinBox*>(QStringLiteral("cell"))->setValue(3);
    EXPECT_EQ(formatText(document.settings().period.start), "2026-06-21");
    EXPECT_EQ(document.settings().period.days, 7);
    EXPECT_EQ(document.settings().receivers.cellM, 3);
    while (document.undoStack().canUndo()) document.undoStack().undo();
    EXPECT_EQ(document.settings(), StudySettings{});
    EXPECT_EQ(dock.findChild<QSpinBox*>(QStringLiteral("days"))->value(), 1);
    EXPECT_EQ(dock.findChild<QDateEdit*>(QStringLiteral("startDate"))->date(), QDate(2026, 3, 21));
}

TEST(StudyDock, OffersEveryEngine) {
    StudyDocument document;
    const StudyDock dock(document);
    const auto* engine = dock.findChild<QComboBox*>(QStringLiteral("engine"));
    ASSERT_EQ(std::size_t(engine->count()), allEngines().size());
    EXPECT_EQ(engine->currentData().toString().toStdString(), document.settings().engine);
}

TEST(StudyDock, ShowingAPeriodDoesNotChangeIt) {
    StudyDocument document;
    const StudyDock dock(document);
    StudySettings settings;
    settings.period.window =
        SolarHours{std::chrono::minutes(90), std::chrono::minutes(45), SunriseRule::centre};
    settings.period.zone = "Australia/Sydney";
    settings.period.stepMinutes = 0.5;
    document.reset(settings);
    EXPECT_EQ(document.settings(), settings);
    EXPECT_FALSE(document.undoStack().canUndo());
    dock.findChild<QSpinBox*>(QStringLiteral("days"))->setValue(2);
    EXPECT_EQ(document.settings().period.window, settings.period.window);
    EXPECT_EQ(document.settings().period.zone, "Australia/Sydney");
    EXPECT_EQ(document.settings().period.stepMinutes, 0.5);
}

// The small city lies within 100 m of its middle; terrain of 121 x 101 m is in it, and another far away.
TEST(FirstRegion, StaysOnTheTerrain) {
    LoadedCity loaded;
    loaded.read.city = test::smallCity();
    const auto regionOn = [&](double westM) {
        Terrain terrain{.grid = {westM, -60, 1, 121, 101}};
        terrain.elevationM.assign(terrain.grid.size(), 0);
        loaded.read.city.terrain = std::make_shared<const Terrain>(std::move(terrain));
        return bounds(firstRegion(loaded, 600));
    };
    const Box2 box = regionOn(-60);
    EXPECT_GE(box.low.x, -60);
    EXPECT_LE(box.high.x, 61);
    EXPECT_GE(box.low.y, -60);
    EXPECT_LE(box.high.y, 41);
    EXPECT_GT(box.high.x - box.low.x, 100) << "nearly all of it";
    const Box2 all = regionOn(5000);
    EXPECT_LT(all.low.x, -100) << "terrain elsewhere does not move it";
}

}  // namespace
}  // namespace noonmark
