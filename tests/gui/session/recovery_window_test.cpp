#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QPushButton>

#include "app/gui/session/project/project_saving.h"
#include "app/gui/view/panel/view_panel.h"
#include "scenarios/project/project_file.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::bytesOf;
using test::ProjectWindow;
using test::waitFor;

TEST_F(ProjectWindow, WorkDiscardedForAFileThatCannotBeOpenedIsStillRecoverable) {
    build();
    writeRecovery();
    window->open({folder.filePath(QStringLiteral("missing.noonmark.gpkg"))});
    ASSERT_TRUE(waitFor([this] { return !message().isEmpty(); }));
    EXPECT_TRUE(session().hasUnsavedWork());
    EXPECT_TRUE(waitFor([this] { return std::filesystem::exists(recovery()); }));
}

TEST_F(ProjectWindow, WorkThatWasNotSavedIsOfferedAgain) {
    build();
    window->saving().writeRecovery();
    const std::filesystem::path saved = recoveryPath(file.toStdString());
    ASSERT_TRUE(waitFor([&] { return std::filesystem::exists(saved); }));
    kill();
    makeWindow();
    open(file);
    EXPECT_TRUE(session().project().scenarios.empty());
    ASSERT_FALSE(message().isEmpty());
    takeOffer();
    ASSERT_TRUE(waitFor([this] { return session().project().scenarios.size() == 1; }));
    EXPECT_TRUE(session().hasUnsavedWork());
    ASSERT_TRUE(waitFor([this] { return workbench().city()->city().buildings.size() == 4; }));
    workbench().document().undoStack().undo();
    EXPECT_TRUE(session().project().scenarios.empty());
    workbench().document().undoStack().redo();
    save();
    EXPECT_EQ(ProjectFile::open(file.toStdString()).value().project().scenarios.size(), 1U);
}

TEST_F(ProjectWindow, WorkThatNeverHadAFileIsOfferedAgain) {
    open(QStringLiteral("sample:central-park-south"));
    ASSERT_TRUE(session().addLot({"Mine", test::square({0, 0}, 10)}));
    const std::size_t lots = session().project().lots.size();
    window->saving().writeRecovery();
    const QString unsaved = folder.filePath(QStringLiteral("unsaved"));
    const std::filesystem::path saved =
        recoveryPath((unsaved + QStringLiteral("/Untitled 1.noonmark.gpkg")).toStdString());
    ASSERT_TRUE(waitFor([&] { return std::filesystem::exists(saved); }));
    kill();
    makeWindow();
    open(QStringLiteral("sample:central-park-south"));
    ASSERT_TRUE(waitFor([this] { return !message().isEmpty(); }));
    takeOffer();
    ASSERT_TRUE(waitFor([&] { return session().project().lots.size() == lots; }));
    EXPECT_TRUE(waitFor([this] { return session().hasUnsavedWork(); }));
    EXPECT_FALSE(session().file());
}

TEST_F(ProjectWindow, RecoveredWorkThatIsDiscardedIsNotOfferedAgain) {
    const QString sample = QStringLiteral("sample:central-park-south");
    open(sample);
    ASSERT_TRUE(session().addLot({"Mine", test::square({0, 0}, 10)}));
    window->saving().writeRecovery();
    const QDir unsaved(folder.filePath(QStringLiteral("unsaved")));
    const auto saved = [&] {
        return unsaved.entryList({QStringLiteral("*.gpkg")}, QDir::Files | QDir::Hidden);
    };
    ASSERT_TRUE(waitFor([&] { return !saved().isEmpty() && !window->saving().writing().busy(); }));
    kill();
    makeWindow();
    open(sample);
    ASSERT_TRUE(waitFor([this] { return !message().isEmpty(); }));
    takeOffer();
    ASSERT_TRUE(waitFor([this] { return session().recovered(); }));
    open(sample);  // the question is answered by Discard
    EXPECT_EQ(message(), QString());
    kill();
    EXPECT_EQ(saved(), QStringList());
    makeWindow();
    open(sample);
    EXPECT_EQ(message(), QString());
}

TEST_F(ProjectWindow, RecoveredChangesOfAFileThatAreDiscardedAreNotOfferedAgain) {
    build();
    window->saving().writeRecovery();
    const std::filesystem::path saved = recoveryPath(file.toStdString());
    ASSERT_TRUE(waitFor([&] { return std::filesystem::exists(saved); }));
    for (const bool keptAgain : {false, true}) {
        kill();
        makeWindow();
        open(file);
        takeOffer();
        ASSERT_TRUE(waitFor([this] { return session().project().scenarios.size() == 1; }));
        const auto older = ProjectSaving::olderRecovery(file.toStdString());
        if (keptAgain) window->saving().writeRecovery();
        if (keptAgain) {
            ASSERT_TRUE(waitFor([&] { return std::filesystem::exists(saved); }));
            EXPECT_TRUE(std::filesystem::exists(older));
        }
        const auto copy = saved.string() + ".copy";
        std::filesystem::copy_file(keptAgain ? older : saved, copy);
        window->close();
        ASSERT_TRUE(waitFor([&] { return !std::filesystem::exists(saved); }));
        EXPECT_FALSE(std::filesystem::exists(older));
        std::filesystem::rename(copy, saved);  // for the next round
    }
}

TEST_F(ProjectWindow, OlderUnsavedWorkIsOfferedAndGoesWhenItIsDiscarded) {
    build();
    writeRecovery();
    kill();
    const auto older = ProjectSaving::olderRecovery(file.toStdString());
    std::filesystem::rename(recovery(), older);
    makeWindow();
    open(file);
    EXPECT_TRUE(message().startsWith(QStringLiteral("There are unsaved changes to small from 2")))
        << message().toStdString();
    takeOffer();
    ASSERT_TRUE(waitFor([this] { return session().project().scenarios.size() == 1; }));
    EXPECT_TRUE(window->close());  // the question is answered by Discard
    EXPECT_FALSE(std::filesystem::exists(older));
}

TEST_F(ProjectWindow, OlderUnsavedWorkIsOfferedBesideNewerAndCanBeDeleted) {
    build();
    writeRecovery();
    kill();
    const auto older = ProjectSaving::olderRecovery(file.toStdString());
    std::filesystem::copy_file(recovery(), older);
    const auto other = [this] {
        return window->panel().messages().findChild<QPushButton*>(QStringLiteral("otherRemedy"));
    };
    makeWindow();
    open(file);
    EXPECT_TRUE(message().startsWith(QStringLiteral("Noonmark closed before"))) << message().toStdString();
    other()->click();
    EXPECT_TRUE(message().startsWith(QStringLiteral("There are unsaved changes to small from 2")))
        << message().toStdString();
    takeOffer();
    ASSERT_TRUE(waitFor([this] { return session().project().scenarios.size() == 1; }));
    EXPECT_TRUE(window->close());
    EXPECT_FALSE(std::filesystem::exists(older));
    EXPECT_TRUE(std::filesystem::exists(recovery())) << "the newer one was not recovered";
    std::filesystem::copy_file(recovery(), older);
    kill();
    makeWindow();
    open(file);
    other()->click();
    other()->click();
    EXPECT_FALSE(std::filesystem::exists(older)) << "deleted";
    EXPECT_TRUE(std::filesystem::exists(recovery()));
}

TEST(RecoveryStores, WhatManyRunsLeftDoesNotGrowForEver) {
    const QTemporaryDir folder;
    const auto recovery = recoveryPath(folder.filePath("Untitled 1.noonmark.gpkg").toStdString());
    const int runs = RecoveryStore::maxLeft + 3;
    for (int i = 0; i < runs; ++i) {
        QFile file(QString::fromStdString(recovery.string()));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::number(i));
        file.close();
        const RecoveryStore place(folder.path());
        EXPECT_EQ(bytesOf(QString::fromStdString(place.left().value().string())), QByteArray::number(i));
    }
    for (int i = runs - 1; i >= runs - RecoveryStore::maxLeft; --i) {
        RecoveryStore place(folder.path());
        EXPECT_EQ(bytesOf(QString::fromStdString(place.left().value().string())), QByteArray::number(i));
        place.forgetLeft();
    }
    EXPECT_FALSE(RecoveryStore(folder.path()).left());
}

TEST(RecoveryStores, WhatTwoRunsLeftIsKeptTheNewestFirst) {
    const QTemporaryDir folder;
    const auto recovery = recoveryPath(folder.filePath("Untitled 1.noonmark.gpkg").toStdString());
    const auto leave = [&](const char* text) {
        QFile file(QString::fromStdString(recovery.string()));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    };
    const auto left = [](const RecoveryStore& place) {
        return bytesOf(QString::fromStdString(place.left().value().string()));
    };
    leave("first");
    EXPECT_EQ(left(RecoveryStore(folder.path())), "first");
    leave("second");
    {
        RecoveryStore place(folder.path());
        EXPECT_EQ(left(place), "second");
        place.forgetLeft();
    }
    EXPECT_EQ(left(RecoveryStore(folder.path())), "first");
}

}  // namespace
}  // namespace noonmark
