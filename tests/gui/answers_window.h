#pragma once

#include <gtest/gtest.h>

#include <QLabel>
#include <QSettings>
#include <QTemporaryDir>

#include "app/gui/docks/project/project_dock.h"
#include "app/gui/docks/project/project_model.h"
#include "app/gui/docks/results/results_dock.h"
#include "app/gui/frame/main_window.h"
#include "app/gui/view/panel/view_panel.h"
#include "app/questions/saved_question.h"
#include "tests/gui/small_project.h"
#include "tests/gui/wait_for.h"

namespace noonmark::test {

/// The window with a small project, a scenario in it, and a quick study.
struct AnswersWindow : ::testing::Test {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    std::unique_ptr<MainWindow> window;

    void SetUp() override {
        settings.setValue(QStringLiteral("unsavedFolder"), folder.filePath(QStringLiteral("unsaved")));
        const QString file = folder.filePath(QStringLiteral("small.noonmark.gpkg"));
        Project project = smallProject();
        project.scenarios.push_back({"Tower", "", {newTower("New", 70)}});
        ASSERT_TRUE(ProjectFile::create(file.toStdString(), project));
        window = std::make_unique<MainWindow>(settings);
        window->saving().setUnsavedQuestion([] { return SavingActions::Unsaved::discard; });
        window->resize(900, 600);
        window->show();
        window->open({file});
        ASSERT_TRUE(waitFor([&] { return workbench().city() != nullptr; }));
        StudySettings question = workbench().document().settings();
        question.receivers.cellM = 4;
        question.period.stepMinutes = 10;
        question.period.days = 40;
        question.region = session().project().regions[0];
        workbench().document().change(question, QStringLiteral("test"));
    }

    Workbench& workbench() { return window->workbench(); }
    ProjectSession& session() { return workbench().session(); }
    QString note() { return window->findChild<QLabel*>(QStringLiteral("resultNote"))->text(); }
    QStringList figures() {
        QStringList texts;
        for (const QLabel* label : window->findChild<ResultsDock*>()->findChildren<QLabel*>())
            if (label->objectName() != QStringLiteral("resultNote"))
                texts << label->text().replace(QChar::Nbsp, u' ');
        return texts;
    }
    void study() {
        workbench().run();
        ASSERT_TRUE(waitFor([this] { return workbench().study() != nullptr; }));
    }
    void saveAndOpenAgain() {
        window->saving().save();
        ASSERT_TRUE(waitFor([this] { return !window->saving().writing().busy() && session().file(); }));
        const auto before = workbench().city();
        window->open({QString::fromStdString(session().file()->path().string())});
        ASSERT_TRUE(waitFor([&] {
            return !workbench().opening().busy() && workbench().city() != before &&
                   !workbench().running().busy() && !workbench().reading().busy();
        }));
    }
    void keep(const char* name) {
        const auto before = session().project().results.size();
        workbench().saveAnswer(QString::fromLatin1(name));
        EXPECT_EQ(session().project().results.size(), before) << "the city is hashed in a job";
        ASSERT_TRUE(waitFor([&] { return session().project().results.size() == before + 1; }));
    }
    void enter(ProjectPart part, const std::string& name) {
        auto* dock = window->findChild<ProjectDock*>();
        dock->use(dock->model().indexOf(part, name));
    }
    void showSaved(const std::string& name) {
        enter(ProjectPart::result, name);
        ASSERT_TRUE(waitFor(
            [this] { return workbench().answerAs<SavedContent>() && !workbench().following().busy(); }));
    }
};

}  // namespace noonmark::test
