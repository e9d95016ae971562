#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <cmath>

#include "app/gui/docks/project/project_dock.h"
#include "app/gui/docks/project/project_model.h"
#include "app/gui/docks/results/results_dock.h"
#include "app/gui/view/panel/view_panel.h"
#include "core/city/trees/tree_facts.h"
#include "tests/gui/answers_window.h"

namespace noonmark {
namespace {

using test::AnswersWindow;
using test::waitFor;

TEST_F(AnswersWindow, GrossShadowAloneStandsForContinuousAndSaysSo) {
    StudySettings question = workbench().document().settings();
    question.engine = "horizon";
    question.engineSettings["runs"] = 0;
    workbench().document().change(question, QStringLiteral("runs"));
    EXPECT_FALSE(window->findChild<QCheckBox*>(QStringLiteral("option_runs"))->isChecked());
    study();
    LegendStrip& legend = window->panel().legend();
    EXPECT_FALSE(legend.note().contains(QStringLiteral("not counted"))) << legend.note().toStdString();
    legend.setMeasure(ShadowMeasure::continuous);
    EXPECT_TRUE(legend.note().endsWith(QStringLiteral("Continuous shadow was not counted")))
        << legend.note().toStdString();
    EXPECT_EQ(legend.legend()->title, QStringLiteral("Gross shadow"));
    EXPECT_EQ(figures().at(figures().indexOf(QStringLiteral("Mean continuous")) + 1),
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

TEST_F(AnswersWindow, TheLegendStatesTheErrorOfWhatTheMapShows) {
    study();
    LegendStrip& legend = window->panel().legend();
    legend.setMeasure(ShadowMeasure::gross);
    EXPECT_TRUE(legend.note().contains(QStringLiteral("of the minutes of a cell")))
        << legend.note().toStdString();
    legend.setMeasure(ShadowMeasure::continuous);
    EXPECT_TRUE(legend.note().contains(QStringLiteral("Measured error of the longest shadow")))
        << legend.note().toStdString();
    EXPECT_FALSE(legend.note().contains(QStringLiteral("minutes of a cell"))) << legend.note().toStdString();
}

// In leaf for a day of the year only.
void plantOak(ProjectSession& session) {
    Project next = session.project();
    City city = *next.city;
    Tree oak = completeTree({.sourceId = "oak", .species = "Quercus", .heightM = 20, .crownDiameterM = 20});
    oak.place = {-10, 60};
    city.trees = std::make_shared<const Trees>(Trees{.trees = {oak}, .leafDays = {300, 301}});
    next.city = std::make_shared<const City>(std::move(city));
    ASSERT_TRUE(session.change(std::move(next), QStringLiteral("trees")));
}

TEST_F(AnswersWindow, AMapShowsTheTreesThatAreChosen) {
    auto& trees = *window->findChild<QComboBox*>(QStringLiteral("resultTrees"));
    study();
    EXPECT_TRUE(trees.isHidden()) << "the city has none";
    plantOak(session());
    ASSERT_TRUE(waitFor([&] { return workbench().city()->city().trees != nullptr; }));
    study();
    ASSERT_TRUE(waitFor([&] { return workbench().study()->field.trees != nullptr; }));
    EXPECT_FALSE(trees.isHidden());
    ASSERT_EQ(trees.count(), 3);
    LegendStrip& legend = window->panel().legend();
    legend.setMeasure(ShadowMeasure::gross);
    const auto nameOfMap = [&] { return describeUnit(*legend.legend()); };
    const auto headline = [&] { return window->findChild<ResultsDock*>()->headline(); };
    const auto choose = [&](int index) {
        trees.setCurrentIndex(index);
        Q_EMIT trees.activated(index);
    };
    EXPECT_TRUE(nameOfMap().endsWith(QStringLiteral(", without trees"))) << nameOfMap().toStdString();
    EXPECT_TRUE(figures().contains(QStringLiteral("Mean gross, trees as evergreens")));
    const QString open = headline();
    choose(1);
    EXPECT_TRUE(nameOfMap().endsWith(QStringLiteral(", trees as evergreens"))) << nameOfMap().toStdString();
    const QString inLeaf = headline();
    EXPECT_NE(inLeaf, open);
    EXPECT_EQ(trees.currentIndex(), 1);
    // The saved result has all three, and the choice stays.
    keep("With trees");
    showSaved("With trees");
    EXPECT_EQ(trees.count(), 3);
    EXPECT_EQ(trees.currentIndex(), 1);
    EXPECT_TRUE(nameOfMap().endsWith(QStringLiteral(", trees as evergreens"))) << nameOfMap().toStdString();
    EXPECT_EQ(headline(), inLeaf);
    choose(2);
    EXPECT_NE(headline(), inLeaf) << "bare";
    legend.undoChoice();
    EXPECT_EQ(headline(), inLeaf);
    // Files of pictures follow the choice, files of values hold all.
    const QString folderOfFiles = folder.filePath(QStringLiteral("exported"));
    ExportChoice choice;
    choice.legend = legend.choice();
    workbench().exportShown(folderOfFiles.toStdString(), choice);
    ASSERT_TRUE(waitFor([&] { return !workbench().writing().busy(); }));
    QFile style(QDir(folderOfFiles).filePath(QStringLiteral("result.qml")));
    ASSERT_TRUE(style.open(QIODevice::ReadOnly));
    EXPECT_TRUE(style.readAll().contains("band=\"3\"")) << "after gross and continuous without trees";
}

/// The names of exported files, sorted.
QStringList exported(MainWindow& window, const QString& folder) {
    ExportChoice choice;
    choice.scale = window.panel().legend().changeScale();
    window.workbench().exportShown(folder.toStdString(), choice);
    EXPECT_TRUE(waitFor([&] { return !window.workbench().writing().busy(); }));
    return QDir(folder).entryList(QDir::Files, QDir::Name);
}

TEST_F(AnswersWindow, WhatIsShownIsExported) {
    const QAction* action = nullptr;
    for (const QMenu* menu : window->menuBar()->findChildren<QMenu*>())
        for (const QAction* one : menu->actions())
            if (one->shortcut() == QKeySequence(QStringLiteral("Ctrl+E"))) action = one;
    ASSERT_NE(action, nullptr);
    session().goTo("Tower");
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ImpactAnswer>() != nullptr; }));
    EXPECT_EQ(
        action->text(),
        QStringLiteral("&Export (Tower compared with %1)...").arg(QString::fromStdString(existingCity)));
    EXPECT_EQ(exported(*window, folder.filePath(QStringLiteral("impact"))),
              QStringList({QStringLiteral("impact.csv"), QStringLiteral("impact.json"),
                           QStringLiteral("impact.pdf"), QStringLiteral("impact.png"),
                           QStringLiteral("impact.qml"), QStringLiteral("impact.tif")}))
        << window->panel().messages().text().toStdString();
    session().compareWith({});
    study();
    workbench().runScore("default");
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ScoreAnswer>() != nullptr; }));
    EXPECT_EQ(action->text(), QStringLiteral("&Export (Score of Tower with default)..."));
    EXPECT_EQ(
        exported(*window, folder.filePath(QStringLiteral("score"))),
        QStringList({QStringLiteral("score.csv"), QStringLiteral("score.json"), QStringLiteral("score.pdf"),
                     QStringLiteral("score.png"), QStringLiteral("score.qml"), QStringLiteral("score.tif")}));
    workbench().showStudyAgain();
    EXPECT_EQ(action->text(), QStringLiteral("&Export (Study of Tower)..."));
    EXPECT_TRUE(
        exported(*window, folder.filePath(QStringLiteral("study"))).contains(QStringLiteral("report.pdf")));
    keep("June");
    showSaved("June");
    EXPECT_EQ(exported(*window, folder.filePath(QStringLiteral("saved"))),
              QStringList({QStringLiteral("result.json"), QStringLiteral("result.pdf"),
                           QStringLiteral("result.png"), QStringLiteral("result.qml"),
                           QStringLiteral("result.tif")}));
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

TEST_F(AnswersWindow, TheListOfAnswersLeadsBackToEachAndMarksThePast) {
    auto* dock = window->findChild<ResultsDock*>();
    auto* list = dock->findChild<QComboBox*>(QStringLiteral("answers"));
    study();
    EXPECT_TRUE(list->isHidden()) << "one answer needs no list";
    session().goTo("Tower");
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ImpactAnswer>() != nullptr; }));
    keep("Impact");
    ASSERT_EQ(list->count(), 2) << "what is saved under a name is listed once";
    EXPECT_EQ(list->itemText(1), QStringLiteral("Saved: Impact"));
    EXPECT_EQ(list->currentIndex(), 1);
    Q_EMIT list->activated(0);
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<Study>() && !workbench().following().busy(); }));
    EXPECT_EQ(session().scenario(), existingCity);
    EXPECT_EQ(list->currentIndex(), 0);
    Q_EMIT list->activated(1);
    ASSERT_TRUE(
        waitFor([this] { return workbench().answerAs<ImpactAnswer>() && !workbench().following().busy(); }));
    EXPECT_EQ(session().scenario(), "Tower");
    ASSERT_TRUE(waitFor([this] { return !workbench().running().busy(); }));
    EXPECT_EQ(workbench().measured().size(), 1) << "shown again, not computed again";
    window->mode().setMode(ViewMode::exploration);  // nothing is computed automatically
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 20}}, QStringLiteral("lower")));
    ASSERT_TRUE(waitFor([&] { return !workbench().following().busy(); }));
    EXPECT_TRUE(waitFor([&] { return list->itemText(1).contains(QStringLiteral("outdated")); }));
    Q_EMIT list->activated(1);
    EXPECT_TRUE(dock->faded()) << "its buildings have changed";
    EXPECT_EQ(workbench().answer(), nullptr);
}

TEST_F(AnswersWindow, AScoreDoesNotDependOnTheBaseline) {
    session().goTo("Tower");
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ImpactAnswer>() != nullptr; }));
    workbench().runScore("default");
    session().compareWith({});  // while it runs
    EXPECT_TRUE(waitFor([this] { return workbench().answerAs<ScoreAnswer>() != nullptr; }));
}

TEST_F(AnswersWindow, AnAnswerOfTheBuildingsBeforeStaysWithItsMark) {
    session().goTo("Tower");
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ImpactAnswer>() != nullptr; }));
    window->mode().setMode(ViewMode::exploration);  // nothing is computed automatically
    const QStringList before = figures();
    ASSERT_TRUE(session().addEdits({ChangeHeight{"New", 20}}, QStringLiteral("lower")));
    EXPECT_EQ(workbench().answerAs<ImpactAnswer>(), nullptr);
    ASSERT_TRUE(waitFor([this] { return !workbench().following().busy(); }));
    EXPECT_TRUE(note().contains(QStringLiteral("buildings have changed"))) << note().toStdString();
    EXPECT_TRUE(window->findChild<ResultsDock*>()->faded());
    EXPECT_EQ(figures().join(QLatin1Char('\n')).toStdString(), before.join(QLatin1Char('\n')).toStdString());
    window->mode().setMode(ViewMode::analysis);
    EXPECT_TRUE(window->panel().legend().note().contains(QStringLiteral("buildings have changed")))
        << window->panel().legend().note().toStdString();
    EXPECT_EQ(workbench().answer(), nullptr) << "an outdated result is not exported";
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ImpactAnswer>() != nullptr; }));
    EXPECT_EQ(note(), QString());
    EXPECT_FALSE(window->findChild<ResultsDock*>()->faded());
    EXPECT_FALSE(window->panel().legend().note().contains(QStringLiteral("Outdated")));
}

TEST_F(AnswersWindow, ACopyOfAScenarioBearsItsOwnNameInLegendAndFigures) {
    session().goTo("Tower");
    session().compareWith(existingCity);
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ImpactAnswer>() != nullptr; }));
    auto* tree = window->findChild<ProjectDock*>();
    tree->duplicate(tree->model().indexOf(ProjectPart::scenario, "Tower"));
    ASSERT_NE(session().scenario(), "Tower");
    ASSERT_TRUE(workbench().answerAs<ImpactAnswer>()) << "the same buildings, the same difference";
    EXPECT_EQ(workbench().answerAs<ImpactAnswer>()->to, session().scenario());
    const QString name = QString::fromStdString(session().scenario());
    EXPECT_TRUE(window->panel().legend().note().contains(name))
        << window->panel().legend().note().toStdString();
    EXPECT_TRUE(figures().join(QLatin1Char('\n')).contains(name));
    workbench().runScore("default");
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ScoreAnswer>() != nullptr; }));
    session().goTo("Tower");
    EXPECT_EQ(workbench().answerAs<ScoreAnswer>()->scenario, "Tower");
    EXPECT_TRUE(window->panel().legend().note().contains(QStringLiteral("Tower with")))
        << window->panel().legend().note().toStdString();
}

TEST_F(AnswersWindow, AllWordsOfTheResultsAreSeenWhateverWasShownBefore) {
    auto* dock = window->findChild<ResultsDock*>();
    const auto expectWhole = [&](const char* when) {
        window->findChild<QDockWidget*>(QStringLiteral("resultsDock"))->show();  // hidden without an answer
        for (int i = 0; i < 20; ++i) QCoreApplication::processEvents();
        int seen = 0;
        for (const QLabel* label : dock->findChildren<QLabel*>()) {
            if (label->text().isEmpty() || !label->isVisible()) continue;
            ++seen;
            const int needed =
                label->wordWrap() ? label->heightForWidth(label->width()) : label->fontMetrics().height();
            EXPECT_GE(label->height(), needed) << when << ": " << label->text().toStdString();
            EXPECT_TRUE(label->parentWidget()->rect().contains(label->geometry()))
                << when << ": " << label->text().toStdString();
        }
        EXPECT_GE(seen, 1) << when;
    };
    expectWhole("before");
    study();
    expectWhole("study");
    workbench().runScore("default");
    ASSERT_TRUE(waitFor([this] { return workbench().answerAs<ScoreAnswer>() != nullptr; }));
    expectWhole("score");
    const auto before = workbench().city();
    window->open({QStringLiteral("sample:grid")});
    ASSERT_TRUE(waitFor([&] { return workbench().city() != before; }));
    EXPECT_TRUE(note().startsWith(QStringLiteral("No study yet."))) << note().toStdString();
    expectWhole("another city");
}

TEST_F(AnswersWindow, ALongRunByRaysIsAnnouncedBeforeItStarts) {
    StudySettings question = workbench().document().settings();
    question.engine = "ray";
    question.receivers.cellM = 0.25;
    question.period.days = 365;
    question.period.from = std::chrono::hours(6);
    question.period.hours = 12;
    question.period.stepMinutes = 1;
    workbench().document().change(question, QStringLiteral("test"));
    workbench().run();
    ASSERT_TRUE(waitFor([this] { return !window->panel().messages().text().isEmpty(); }));
    const QString words = window->panel().messages().text();
    EXPECT_TRUE(words.startsWith(QStringLiteral("This study takes about "))) << words.toStdString();
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

TEST_F(AnswersWindow, AsInThePaperIsPressedWhileItHolds) {
    auto* paper = window->findChild<QAction*>(QStringLiteral("paperMaps"));
    ASSERT_NE(paper, nullptr);
    EXPECT_FALSE(paper->isChecked());
    const auto engine = [this] { return workbench().document().settings().engine; };
    const std::string before = engine();
    paper->trigger();
    EXPECT_EQ(engine(), "iam");
    EXPECT_TRUE(paper->isChecked());
    paper->trigger();
    EXPECT_NE(engine(), "iam");
    EXPECT_FALSE(paper->isChecked());
    workbench().document().undoStack().undo();
    workbench().document().undoStack().undo();
    EXPECT_EQ(engine(), before);
}

}  // namespace
}  // namespace noonmark
