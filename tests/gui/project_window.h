#pragma once

#include <gtest/gtest.h>

#include <QFile>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>

#include "app/gui/frame/main_window.h"
#include "app/gui/view/panel/view_panel.h"
#include "scenarios/project/project_file.h"
#include "tests/gui/small_project.h"
#include "tests/gui/wait_for.h"

namespace noonmark::test {

inline QByteArray bytesOf(const QString& name) {
    QFile file(name);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
}

/// The window with a small project file.
struct ProjectWindow : ::testing::Test {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    QString file = folder.filePath(QStringLiteral("small.noonmark.gpkg"));
    std::unique_ptr<MainWindow> window;

    void SetUp() override {
        settings.setValue(QStringLiteral("unsavedFolder"), folder.filePath(QStringLiteral("unsaved")));
        ASSERT_TRUE(ProjectFile::create(file.toStdString(), smallProject()));
        makeWindow();
        open(file);
    }

    void makeWindow() {
        window.reset();
        window = std::make_unique<MainWindow>(settings);
        window->saving().setUnsavedQuestion([] { return SavingActions::Unsaved::discard; });
        window->resize(900, 600);
        window->show();
    }
    void open(const QString& name) {
        const auto before = workbench().city();
        window->open({name});
        ASSERT_TRUE(waitFor([&] { return workbench().city() != before; })) << message().toStdString();
    }
    void build() {
        ASSERT_TRUE(session().addEdits({newTower("New", 70)}, QStringLiteral("tower")));
        ASSERT_TRUE(waitFor([this] { return workbench().city()->city().buildings.size() == 4; }));
    }
    void save() {
        window->saving().save();
        ASSERT_TRUE(waitFor([this] { return !window->saving().writing().busy(); }));
    }
    [[nodiscard]] std::filesystem::path recovery() const { return recoveryPath(file.toStdString()); }
    void writeRecovery() {
        window->saving().writeRecovery();
        ASSERT_TRUE(waitFor([this] { return std::filesystem::exists(recovery()); }));
    }
    Workbench& workbench() { return window->workbench(); }
    ProjectSession& session() { return workbench().session(); }
    QString message() { return window->panel().messages().text(); }
    void takeOffer() {
        window->panel().messages().findChild<QPushButton*>(QStringLiteral("remedy"))->click();
    }
    // Ends the window as a crash would: without questions or cleaning up.
    void kill() { window.reset(); }
};

}  // namespace noonmark::test
