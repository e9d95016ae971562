#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QSettings>

#include "app/gui/frame/main_window.h"
#include "app/gui/view/panel/view_panel.h"
#include "tests/gui/small_project.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;
using testing::HasSubstr;

QByteArray contentOf(const QString& name) {
    QFile file(name);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
}

/// The window with a displayed study of a project whose city was read from a file beside it.
struct OutputWindow : ::testing::Test {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    QString input = written("houses.png", "\x89PNG\r\n\x1a\n: a picture that the city was read from");
    QString project = folder.filePath(QStringLiteral("small.noonmark.gpkg"));
    QString out = folder.filePath(QStringLiteral("out"));
    std::unique_ptr<MainWindow> window;

    void SetUp() override {
        settings.setValue(QStringLiteral("unsavedFolder"), folder.filePath(QStringLiteral("unsaved")));
        Project made = test::smallProject();
        made.inputs = {{"houses.png", 7, "abc"}};
        ASSERT_TRUE(ProjectFile::create(project.toStdString(), made));
        window = std::make_unique<MainWindow>(settings);
        window->saving().setUnsavedQuestion([] { return SavingActions::Unsaved::discard; });
        window->show();
        window->open({project});
        ASSERT_TRUE(waitFor([&] { return workbench().city() != nullptr; }));
    }

    [[nodiscard]] QString written(const char* name, const QByteArray& content) const {
        const QString path = folder.filePath(QLatin1String(name));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
        return path;
    }
    Workbench& workbench() { return window->workbench(); }
    std::string message() { return window->panel().messages().text().toStdString(); }

    void study() {
        StudySettings question = workbench().document().settings();
        question.receivers.cellM = 4;
        question.period.stepMinutes = 30;
        workbench().document().change(question, QStringLiteral("test"));
        workbench().run();
        ASSERT_TRUE(waitFor([this] { return workbench().study() && !workbench().running().busy(); }));
    }
    void exportStudy() {
        workbench().exportShown(out.toStdString(), {});
        ASSERT_TRUE(waitFor([this] { return !workbench().writing().busy(); }));
    }
    void saveAs(const QString& name) {
        window->saving().saveTo(name.toStdString());
        ASSERT_TRUE(waitFor([this] { return !window->saving().writing().busy(); }));
    }
};

TEST_F(OutputWindow, APictureReplacesPicturesOnly) {
    const QString notes = written("notes.png", "Dear board\n");
    for (const QString& victim : {input, notes, project}) {
        const QByteArray before = contentOf(victim);
        window->panel().messages().hide();
        window->results().savePicture(victim);
        EXPECT_THAT(message(), HasSubstr(victim.toStdString()));
        EXPECT_EQ(contentOf(victim), before);
    }
    const QString earlier = written("earlier.png", "\x89PNG\r\n\x1a\n");
    window->results().savePicture(earlier);
    ASSERT_TRUE(waitFor([&] { return contentOf(earlier).size() > 1000; })) << message();
}

TEST_F(OutputWindow, AProjectReplacesProjectsOnly) {
    const QString notes = written("notes.noonmark.gpkg", "Dear board\n");
    saveAs(notes);
    EXPECT_THAT(message(), HasSubstr("it is not a Noonmark project"));
    EXPECT_EQ(contentOf(notes), "Dear board\n");
    const QString other = folder.filePath(QStringLiteral("other.noonmark.gpkg"));
    ASSERT_TRUE(ProjectFile::create(other.toStdString(), test::smallProject()));
    saveAs(other);
    EXPECT_EQ(workbench().session().file()->path(), other.toStdString()) << message();
    saveAs(other);
    EXPECT_THAT(message(), HasSubstr("Saved as")) << "over its own file";
}

TEST_F(OutputWindow, AnExportIsAskedAboutAndReplacesItsOwnFilesOnly) {
    study();
    EXPECT_EQ(workbench().listExistingFiles(out.toStdString()), QStringList());
    exportStudy();
    EXPECT_THAT(message(), HasSubstr("Exported to"));
    const QStringList there = workbench().listExistingFiles(out.toStdString());
    EXPECT_EQ(QSet<QString>(there.begin(), there.end()), [names = QDir(out).entryList(QDir::Files)] {
        return QSet<QString>(names.begin(), names.end());
    }());
    exportStudy();
    EXPECT_THAT(message(), HasSubstr("Exported to"));
    const QString shadow = out + QStringLiteral("/shadow.tif");
    ASSERT_TRUE(QFile::resize(shadow, 0));
    ASSERT_TRUE(QFile::remove(out + QStringLiteral("/cells.csv")));
    ASSERT_TRUE(QFile::link(project, out + QStringLiteral("/cells.csv")));
    const QByteArray before = contentOf(project);
    exportStudy();
    EXPECT_THAT(message(), HasSubstr("cells.csv"));
    EXPECT_EQ(contentOf(project), before);
    EXPECT_EQ(contentOf(shadow).size(), 0) << "all or nothing";
}

}  // namespace
}  // namespace noonmark
