#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTreeView>
#include <cmath>

#include "app/window/frame/main_window.h"
#include "app/window/project/project_dock.h"
#include "app/window/project/project_model.h"
#include "app/window/results/results_dock.h"
#include "app/window/view/view_panel.h"
#include "scenarios/project/results/save_result.h"
#include "tests/gui/small_project.h"
#include "tests/gui/wait_for.h"

namespace noonmark {
namespace {

using test::waitFor;

/// The window with a small project, a scenario in it, and a quick study.
struct AnswersWindow : ::testing::Test {
    QTemporaryDir folder;
    QSettings settings{folder.filePath(QStringLiteral("settings.ini")), QSettings::IniFormat};
    std::unique_ptr<MainWindow> window;

    void SetUp() override {
        settings.setValue(QStringLiteral("unsavedFolder"), folder.filePath(QStringLiteral("unsaved")));
        const QString file = folder.filePath(QStringLiteral("small.noonmark.gpkg"));
        Project project = test::smallProject();
        project.scenarios.push_back({"Tower", "", {test::newTower("New", 70)}});
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
            texts << label->text();
        return texts;
    }
    void study() {
        workbench().run();
        ASSERT_TRUE(waitFor([this] { return workbench().study() != nullptr; }));
    }
    void keep(const char* name) {
        const auto before = session().project().results.size();
        workbench().keepAnswer(QString::fromLatin1(name));
        EXPECT_EQ(session().project().results.size(), before) << "the city is hashed in a job";
        ASSERT_TRUE(waitFor([&] { return session().project().results.size() == before + 1; }));
    }
    void enter(ProjectPart part, const std::string& name) {
        auto* dock = window->findChild<ProjectDock*>();
        dock->use(dock->model().indexOf(part, name));
    }
    void showSaved(const std::string& name) {
        enter(ProjectPart::result, name);
        ASSERT_TRUE(waitFor([this] { return workbench().saved() && !workbench().following().busy(); }));
    }
};

TEST_F(AnswersWindow, AKeptStudyIsShownAgainWithFiguresAndLegend) {
    study();
    const auto before = window->panel().legend().legend();
    keep("June");
    const QString area = figures()[figures().indexOf(QStringLiteral("Shadow area")) + 1];
    window->mode().setMode(ViewMode::exploration);
    showSaved("June");
    EXPECT_EQ(window->mode().mode(), ViewMode::analysis);
    ASSERT_TRUE(window->panel().legend().legend());
    EXPECT_EQ(window->panel().legend().legend()->scale.top, before->scale.top);
    EXPECT_TRUE(window->panel().legend().note().startsWith(QStringLiteral("Saved 2")))
        << window->panel().legend().note().toStdString();
    EXPECT_TRUE(figures().contains(area));
    EXPECT_TRUE(figures().join(QLatin1Char('\n')).contains(QStringLiteral("Square\ncells of 4 m")));
    EXPECT_TRUE(note().contains(QStringLiteral("Its inputs have not changed"))) << note().toStdString();
    EXPECT_EQ(session().project().results.size(), 1U);
    window->findChild<QPushButton*>(QStringLiteral("wayBack"))->click();
    EXPECT_EQ(workbench().saved(), nullptr);
    EXPECT_EQ(window->panel().legend().note(), QString());
}

TEST_F(AnswersWindow, AKeptResultGoesToItsScenarioAndSaysWhatHasChanged) {
    session().goTo("Tower");
    session().compareWith(existingCity);
    window->mode().setMode(ViewMode::analysis);
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return workbench().comparison() != nullptr; }));
    keep("Impact");
    session().compareWith({});
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 20}}, QStringLiteral("lower")));
    session().goTo(existingCity);
    showSaved("Impact");
    EXPECT_EQ(session().scenario(), "Tower");
    EXPECT_TRUE(window->panel().legend().legend()->change);
    EXPECT_TRUE(note().contains(QStringLiteral("'Tower' has changed since"))) << note().toStdString();
    EXPECT_TRUE(window->panel().legend().note().endsWith(QStringLiteral("Outdated")));
    workbench().document().undoStack().undo();
    EXPECT_EQ(workbench().saved(), nullptr) << "it was shown with other buildings";
    showSaved("Impact");
    EXPECT_FALSE(note().contains(QStringLiteral("settings have changed"))) << note().toStdString();
}

TEST_F(AnswersWindow, ADamagedKeptResultIsSaidAndWhatWasShownStays) {
    study();
    keep("June");
    Project next = session().project();
    auto broken = std::make_shared<SavedResult>(*next.results[0]);
    broken->settings = "{}";
    next.results[0] = broken;
    ASSERT_TRUE(session().change(next, QStringLiteral("break")));
    enter(ProjectPart::result, "June");
    ASSERT_TRUE(waitFor([this] { return !window->panel().messages().text().isEmpty(); }));
    EXPECT_TRUE(window->panel().messages().text().contains(QStringLiteral("cannot be shown")));
    EXPECT_EQ(workbench().saved(), nullptr);
    EXPECT_NE(workbench().study(), nullptr);
}

TEST_F(AnswersWindow, GrossShadowAloneStandsForContinuousAndSaysSo) {
    StudySettings question = workbench().document().settings();
    question.engine = "horizon";
    question.engineSettings["runs"] = 0;
    workbench().document().change(question, QStringLiteral("runs"));
    EXPECT_FALSE(window->findChild<QCheckBox*>(QStringLiteral("option_runs"))->isChecked());
    study();
    LegendStrip& legend = window->panel().legend();
    EXPECT_EQ(legend.note(), QString());
    legend.setMeasure(ShadowMeasure::continuous);
    EXPECT_EQ(legend.note(), QStringLiteral("Continuous shadow was not counted"));
    EXPECT_EQ(legend.legend()->title, QStringLiteral("Gross shadow"));
    EXPECT_EQ(figures().at(figures().indexOf(QStringLiteral("Continuous")) + 1),
              QStringLiteral("not counted"));
    EXPECT_FALSE(figures().join(QLatin1Char(' ')).contains(QStringLiteral("nan")));
    keep("Gross");
    showSaved("Gross");
    EXPECT_TRUE(legend.note().endsWith(QStringLiteral("Gross. Continuous shadow was not counted")))
        << legend.note().toStdString();
    EXPECT_TRUE(figures().contains(QStringLiteral("not counted")));
    legend.setMeasure(ShadowMeasure::gross);
    EXPECT_FALSE(legend.note().contains(QStringLiteral("not counted"))) << legend.note().toStdString();
}

TEST_F(AnswersWindow, AScoreIsShownByMonthsKeptAndFoundOutdated) {
    workbench().runScore("default");
    ASSERT_TRUE(waitFor([this] { return workbench().score() != nullptr; }));
    const Score& score = workbench().score()->score;
    EXPECT_GE(score.months.size(), 2U);
    NoProgress progress;
    const Score again =
        runScore(*session().city(), workbench().document().settings(), makeMonthlyWeights(), progress, {})
            .value();
    EXPECT_EQ(score.scoreM2, again.scoreM2) << "as the command line has it";
    EXPECT_TRUE(window->panel().legend().legend()->wanted);
    EXPECT_TRUE(figures().contains(QStringLiteral("Shadow score")));
    EXPECT_EQ(note(), QString());
    keep("Score");
    EXPECT_EQ(session().project().results.at(0)->kind, "score");
    Project next = session().project();
    next.weights[0].intervals[0].weight = 0.5;
    ASSERT_TRUE(session().change(next, QStringLiteral("weights")));
    EXPECT_TRUE(note().contains(QStringLiteral("weight table has changed"))) << note().toStdString();
    showSaved("Score");
    EXPECT_TRUE(window->panel().legend().legend()->wanted);
    EXPECT_TRUE(figures().contains(QStringLiteral("Shadow score")));
    const auto legendNote = [this] { return window->panel().legend().note(); };
    EXPECT_TRUE(note().contains(QStringLiteral("'default' has changed since"))) << note().toStdString();
    EXPECT_TRUE(legendNote().endsWith(QStringLiteral("Outdated"))) << legendNote().toStdString();
    workbench().document().undoStack().undo();
    EXPECT_TRUE(note().contains(QStringLiteral("Its inputs have not changed"))) << note().toStdString();
    EXPECT_FALSE(legendNote().endsWith(QStringLiteral("Outdated"))) << legendNote().toStdString();
    study();
    EXPECT_EQ(workbench().saved(), nullptr) << "another result replaces it";
    EXPECT_FALSE(figures().contains(QStringLiteral("Shadow score")));
}

/// The names of exported files, sorted.
QStringList exported(MainWindow& window, const QString& folder) {
    window.workbench().exportShown(folder.toStdString(), window.panel().legend().changeScale());
    EXPECT_TRUE(waitFor([&] { return !window.workbench().writing().busy(); }));
    return QDir(folder).entryList(QDir::Files, QDir::Name);
}

TEST_F(AnswersWindow, WhatIsShownIsExported) {
    const QAction* action = nullptr;
    for (const QAction* one : window->findChildren<QAction*>())
        if (one->shortcut() == QKeySequence(QStringLiteral("Ctrl+E"))) action = one;
    ASSERT_NE(action, nullptr);
    session().goTo("Tower");
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([this] { return workbench().comparison() != nullptr; }));
    EXPECT_EQ(action->text(),
              QStringLiteral("&Export Tower compared with %1...").arg(QString::fromStdString(existingCity)));
    EXPECT_EQ(exported(*window, folder.filePath(QStringLiteral("impact"))),
              QStringList({QStringLiteral("impact.csv"), QStringLiteral("impact.json"),
                           QStringLiteral("impact.pdf"), QStringLiteral("impact.png"),
                           QStringLiteral("impact.tif")}))
        << window->panel().messages().text().toStdString();
    session().compareWith({});
    study();
    workbench().runScore("default");
    ASSERT_TRUE(waitFor([this] { return workbench().score() != nullptr; }));
    EXPECT_EQ(action->text(), QStringLiteral("&Export the score of Tower..."));
    EXPECT_EQ(
        exported(*window, folder.filePath(QStringLiteral("score"))),
        QStringList({QStringLiteral("score.csv"), QStringLiteral("score.json"), QStringLiteral("score.pdf"),
                     QStringLiteral("score.png"), QStringLiteral("score.tif")}));
    workbench().showStudyAgain();
    EXPECT_EQ(action->text(), QStringLiteral("&Export study..."));
    EXPECT_TRUE(
        exported(*window, folder.filePath(QStringLiteral("study"))).contains(QStringLiteral("report.pdf")));
    keep("June");
    showSaved("June");
    EXPECT_EQ(exported(*window, folder.filePath(QStringLiteral("saved"))), QStringList());
    EXPECT_TRUE(
        window->panel().messages().text().contains(QStringLiteral("A saved result cannot be exported")));
}

TEST_F(AnswersWindow, TheScaleOfDifferencesIsLockedChangedAndFoundAgain) {
    session().goTo("Tower");
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([this] { return workbench().comparison() != nullptr; }));
    LegendStrip& legend = window->panel().legend();
    auto* field = window->findChild<QSpinBox*>(QStringLiteral("changeScale"));
    EXPECT_TRUE(field->isVisible());
    EXPECT_EQ(legend.legend()->scale.top, 60);
    EXPECT_TRUE(legend.legend()->unit.contains(QStringLiteral("scale locked: ±60 min")))
        << legend.legend()->unit.toStdString();
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 8}}, QStringLiteral("low")));
    const auto before = workbench().comparison();
    ASSERT_TRUE(waitFor([&] { return workbench().comparison() && workbench().comparison() != before; }));
    EXPECT_EQ(legend.legend()->scale.top, 60) << "another proposal, the same scale";
    field->setValue(25);
    EXPECT_EQ(legend.legend()->scale.top, 25);
    EXPECT_EQ(legend.changeScale(), ChangeScale{25});
    window->saving().save();
    ASSERT_TRUE(waitFor([this] { return !window->saving().writing().busy(); }));
    EXPECT_EQ(changeScaleIn(ProjectFile::open(session().file()->path()).value().project().view),
              ChangeScale{25});
    field->setValue(0);
    EXPECT_TRUE(legend.legend()->unit.contains(QStringLiteral("fitted")))
        << legend.legend()->unit.toStdString();
    const auto open = workbench().city();
    window->open({QString::fromStdString(session().file()->path().string())});
    ASSERT_TRUE(waitFor([&] { return workbench().city() != open; }));
    EXPECT_EQ(legend.changeScale(), ChangeScale{25}) << "as it was saved";
    session().compareWith({});
    EXPECT_FALSE(field->isVisible());
}

TEST_F(AnswersWindow, FiguresThatAreNotOfWhatIsShownAreMarked) {
    study();
    auto* dock = window->findChild<ResultsDock*>();
    EXPECT_FALSE(dock->faded());
    window->tools().tower().begin(session().project().lots[0], {});
    EXPECT_TRUE(note().contains(QStringLiteral("do not include the building being designed")))
        << note().toStdString();
    EXPECT_TRUE(dock->faded());
    window->tools().tower().cancel();
    EXPECT_EQ(note(), QString());
    EXPECT_FALSE(dock->faded());
}

TEST_F(AnswersWindow, AnAnswerOfTheBuildingsBeforeStaysWithItsMark) {
    session().goTo("Tower");
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([this] { return workbench().comparison() != nullptr; }));
    window->mode().setMode(ViewMode::exploration);  // nothing is computed automatically
    const QStringList before = figures();
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 20}}, QStringLiteral("lower")));
    EXPECT_EQ(workbench().comparison(), nullptr);
    ASSERT_TRUE(waitFor([this] { return !workbench().following().busy(); }));
    EXPECT_TRUE(note().contains(QStringLiteral("buildings have changed"))) << note().toStdString();
    EXPECT_TRUE(window->findChild<ResultsDock*>()->faded());
    EXPECT_EQ(figures().mid(1), before.mid(1)) << "all but the warning";
    window->mode().setMode(ViewMode::analysis);
    EXPECT_TRUE(window->panel().legend().note().endsWith(QStringLiteral("buildings have changed")))
        << window->panel().legend().note().toStdString();
    EXPECT_EQ(workbench().shown(), Workbench::Shown::nothing) << "an outdated result is not exported";
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return workbench().comparison() != nullptr; }));
    EXPECT_EQ(note(), QString());
    EXPECT_FALSE(window->findChild<ResultsDock*>()->faded());
    EXPECT_FALSE(window->panel().legend().note().contains(QStringLiteral("Outdated")));
}

TEST_F(AnswersWindow, ACopyOfAScenarioBearsItsOwnNameInLegendAndFigures) {
    session().goTo("Tower");
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([this] { return workbench().comparison() != nullptr; }));
    auto* tree = window->findChild<ProjectDock*>();
    tree->duplicate(tree->model().indexOf(ProjectPart::scenario, "Tower"));
    ASSERT_NE(session().scenario(), "Tower");
    ASSERT_TRUE(workbench().comparison()) << "the same buildings, the same difference";
    EXPECT_EQ(workbench().comparison()->to, session().scenario());
    const QString name = QString::fromStdString(session().scenario());
    EXPECT_TRUE(window->panel().legend().note().startsWith(name))
        << window->panel().legend().note().toStdString();
    EXPECT_TRUE(figures().join(QLatin1Char('\n')).contains(name));
    workbench().runScore("default");
    ASSERT_TRUE(waitFor([this] { return workbench().score() != nullptr; }));
    session().goTo("Tower");
    EXPECT_EQ(workbench().score()->scenario, "Tower");
    EXPECT_TRUE(window->panel().legend().note().startsWith(QStringLiteral("Tower with")))
        << window->panel().legend().note().toStdString();
}

TEST_F(AnswersWindow, AllWordsOfTheResultsAreSeenWhateverWasShownBefore) {
    auto* dock = window->findChild<ResultsDock*>();
    const auto expectWhole = [&](const char* when) {
        for (int i = 0; i < 20; ++i) QCoreApplication::processEvents();
        int seen = 0;
        for (const QLabel* label : dock->findChildren<QLabel*>()) {
            if (label->text().isEmpty() || !label->isVisible()) continue;
            ++seen;
            const int needed =
                label->wordWrap() ? label->heightForWidth(label->width()) : label->fontMetrics().height();
            EXPECT_GE(label->height(), needed) << when << ": " << label->text().toStdString();
            EXPECT_TRUE(dock->rect().contains(label->geometry()))
                << when << ": " << label->text().toStdString();
        }
        EXPECT_GE(seen, 1) << when;
    };
    expectWhole("before");
    study();
    expectWhole("study");
    workbench().runScore("default");
    ASSERT_TRUE(waitFor([this] { return workbench().score() != nullptr; }));
    expectWhole("score");
    const auto before = workbench().city();
    window->open({QStringLiteral("sample:grid")});
    ASSERT_TRUE(waitFor([&] { return workbench().city() != before; }));
    EXPECT_EQ(note(), QStringLiteral("No study yet."));
    expectWhole("another city");
}

TEST_F(AnswersWindow, ALongRunByRaysIsAnnouncedBeforeItStarts) {
    StudySettings question = workbench().document().settings();
    question.engine = "ray";
    question.receivers.cellM = 1;
    question.period.days = 365;
    question.period.from = std::chrono::hours(6);
    question.period.hours = 12;
    question.period.stepMinutes = 1;
    workbench().document().change(question, QStringLiteral("test"));
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return !window->panel().messages().text().isEmpty(); }));
    const QString words = window->panel().messages().text();
    EXPECT_TRUE(words.startsWith(QStringLiteral("The ray reference takes about "))) << words.toStdString();
    EXPECT_FALSE(workbench().running().busy());
    window->panel().messages().findChild<QPushButton*>(QStringLiteral("otherRemedy"))->click();
    EXPECT_TRUE(workbench().running().busy()) << "by the ray reference";
    workbench().running().cancel();
    ASSERT_TRUE(waitFor([this] { return !workbench().running().busy(); }));
    window->panel().messages().hide();
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return !window->panel().messages().text().isEmpty(); }));
    window->panel().messages().findChild<QPushButton*>(QStringLiteral("remedy"))->click();
    EXPECT_EQ(workbench().document().settings().engine, "auto");
    EXPECT_TRUE(workbench().running().busy());
    workbench().running().cancel();
    ASSERT_TRUE(waitFor([this] { return !workbench().running().busy(); }));
    question.period.days = 1;
    question.period.stepMinutes = 30;
    workbench().document().change(question, QStringLiteral("short"));
    window->panel().messages().hide();
    study();
    EXPECT_EQ(window->panel().messages().text(), QString()) << "a short run starts without a message";
}

TEST(RunEstimates, AreWrittenInTheUnitThatSuits) {
    EXPECT_EQ(describeAbout(1), QStringLiteral("about a second"));
    EXPECT_EQ(describeAbout(90), QStringLiteral("about 90 s"));
    EXPECT_EQ(describeAbout(600), QStringLiteral("about 10 min"));
    EXPECT_EQ(describeAbout(3 * 3600), QStringLiteral("about 3 h"));
    EXPECT_EQ(describeAbout(40 * 86400.0), QStringLiteral("about 40 days"));
}

TEST_F(AnswersWindow, RoofsAreChosenMeasuredAndRefusedWhereTheyCannotBe) {
    auto* places = window->findChild<QComboBox*>(QStringLiteral("places"));
    places->setCurrentIndex(2);
    Q_EMIT places->activated(2);
    EXPECT_EQ(workbench().document().settings().receivers.places, ReceiverPlaces::both);
    study();
    const Study& study = *workbench().study();
    const auto roof = std::ranges::find(study.receivers.kind, CellKind::roof);
    ASSERT_NE(roof, study.receivers.kind.end());
    const auto cell = int(roof - study.receivers.kind.begin());
    const Grid& grid = study.receivers.grid;
    const glm::dvec2 centre = grid.centre(cell % grid.columns, cell / grid.columns);
    const Pick onRoof{.position = {centre, 10}, .building = 0};
    EXPECT_TRUE(window->panel().results().minutesAt(onRoof).startsWith(QStringLiteral("gross")));
    for (const auto measure : {ShadowMeasure::continuous, ShadowMeasure::gross}) {
        window->panel().legend().setMeasure(measure);
        QImage image;
        window->panel().view().capture([&image](const QImage& made) { image = made; });
        ASSERT_TRUE(waitFor([&image] { return !image.isNull(); }, 20000)) << "pictures of both are drawn";
    }
    workbench().runScore("default");
    ASSERT_TRUE(waitFor([this] { return !window->panel().messages().text().isEmpty(); }));
    EXPECT_TRUE(window->panel().messages().text().contains(QStringLiteral("ground only")));
    auto* refusal = window->findChild<QLabel*>(QStringLiteral("engineRefusal"));
    EXPECT_TRUE(refusal->isHidden()) << "the automatic engine is one that can";
    StudySettings polygons = workbench().document().settings();
    polygons.engine = "projected";
    workbench().document().change(polygons, QStringLiteral("engine"));
    EXPECT_FALSE(refusal->isHidden()) << "before Run is pressed";
    EXPECT_TRUE(refusal->text().contains(QStringLiteral("roofs"))) << refusal->text().toStdString();
    workbench().document().undoStack().undo();
    EXPECT_TRUE(refusal->isHidden());
    workbench().document().undoStack().undo();
    EXPECT_EQ(places->currentIndex(), 0);
}

}  // namespace
}  // namespace noonmark
