#include "app/gui/frame/help/start_page.h"

#include <gtest/gtest.h>

#include <QDockWidget>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <QToolBar>
#include <cstdlib>

#include "app/gui/base/widgets/buttons.h"
#include "app/gui/docks/study_form/study_dock.h"
#include "app/language/language.h"
#include "tests/gui/project_window.h"

namespace noonmark {
namespace {

using test::waitFor;

struct StartPageWindow : test::ProjectWindow {
    StartPage* begin(bool cityChosen = true) {
        window->help().showStart(cityChosen);
        return window->findChild<StartPage*>();
    }
    static CardButton* card(const StartPage& page, StartQuestion question) {
        return page.questions()->findChildren<CardButton*>()[int(question)];
    }
    bool isShown(const char* dock) {
        return !window->findChild<QDockWidget*>(QLatin1String(dock))->isHidden();
    }
    static bool isGone(const QPointer<StartPage>& page) {
        return waitFor([&] {
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            return page.isNull();
        });
    }
};

TEST_F(StartPageWindow, ASampleOpensAndThePageGoes) {
    const QPointer<StartPage> page = begin();
    const auto before = workbench().city();
    page->findChild<CardButton*>(QStringLiteral("startGrid"))->click();
    EXPECT_TRUE(isGone(page));
    EXPECT_TRUE(waitFor([&] { return workbench().city() != before; })) << message().toStdString();
}

TEST_F(StartPageWindow, TheViewStaysInSightBetweenItsSides) {
    window->resize(1366, 728);
    StartPage* page = begin();
    QCoreApplication::processEvents();
    const ViewPanel& panel = window->panel();
    EXPECT_EQ(panel.internalWinId(), 0U) << "a panel with a window of its own lies above the view's";
    const int middle = page->questions()->x() - page->geometry().right();
    EXPECT_GT(middle, 400);
    EXPECT_GE(page->geometry().right() + 1, std::min(panel.mapTo(window.get(), QPoint()).x(), 400));
    EXPECT_EQ(page->questions()->geometry().right() + 1, window->width());
    const auto* bar = page->questions()->findChild<QScrollArea*>()->verticalScrollBar();
    EXPECT_EQ(bar->maximum(), 0) << "all of it is in sight";
    window->resize(1000, 700);
    QCoreApplication::processEvents();
    EXPECT_EQ(page->questions()->geometry().right() + 1, window->width()) << "it follows the window";
}

TEST_F(StartPageWindow, PanelsBelowAreHiddenMeanwhile) {
    auto* review = window->findChild<QDockWidget*>(QStringLiteral("reviewDock"));
    review->show();
    const QPointer<StartPage> page = begin();
    EXPECT_TRUE(review->isHidden());
    page->close();
    EXPECT_FALSE(review->isHidden());
    EXPECT_TRUE(isGone(page));
    EXPECT_FALSE(review->isHidden());
}

TEST_F(StartPageWindow, ItsQuestionsAreAskedFromTheBarOnceACityIsOpen) {
    QAction* ask = window->help().questions();
    EXPECT_TRUE(window->findChild<QToolBar*>(QStringLiteral("modeBar"))->actions().contains(ask));
    const QList<QAction*> questions = ask->menu()->actions();
    ASSERT_EQ(std::size_t(questions.size()), listStartCards().size());
    questions[int(StartQuestion::places)]->trigger();
    EXPECT_EQ(window->findChild<StudyDock*>()->kind(), StudyKind::places);
    questions[int(StartQuestion::review)]->trigger();
    EXPECT_TRUE(isShown("reviewDock"));
}

TEST_F(StartPageWindow, TheRegionIsOutlinedWhileAPanelSpeaksOfIt) {
    window->findChild<QDockWidget*>(QStringLiteral("resultsDock"))->hide();
    auto* study = window->findChild<QDockWidget*>(QStringLiteral("studyDock"));
    study->raise();
    EXPECT_TRUE(waitFor([this] { return window->panel().showsRegion(); }));
    window->findChild<QDockWidget*>(QStringLiteral("projectDock"))->raise();
    EXPECT_TRUE(waitFor([this] { return !window->panel().showsRegion(); }));
    study->raise();
    EXPECT_TRUE(waitFor([this] { return window->panel().showsRegion(); }));
}

TEST_F(StartPageWindow, AMessageStandsBetweenItsSides) {
    window->resize(1366, 728);
    const QPointer<StartPage> page = begin();
    MessageBar& messages = window->panel().messages();
    messages.showHelp(QStringLiteral("A message"));
    const auto left = [&] { return messages.mapTo(window.get(), QPoint()).x(); };
    EXPECT_TRUE(waitFor([&] {
        return left() > page->geometry().right() && left() + messages.width() <= page->questions()->x();
    })) << left()
        << ", " << messages.width();
    page->close();
    EXPECT_TRUE(isGone(page));
    EXPECT_TRUE(waitFor([&] {
        const int panelLeft = window->panel().mapTo(window.get(), QPoint()).x();
        return std::abs(2 * (left() - panelLeft) + messages.width() - window->panel().width()) <= 2;
    })) << "in the middle of the view again: "
        << left() << ", " << messages.width();
}

TEST_F(StartPageWindow, AFileThatIsGoneIsShownSoAndCannotBeOpened) {
    RecentFiles(settings).add({folder.filePath(QStringLiteral("moved.gpkg"))});
    const StartPage* page = begin();
    const auto recent = page->findChildren<CardButton*>(QStringLiteral("startRecent"));
    ASSERT_EQ(recent.size(), 2);
    EXPECT_FALSE(recent[0]->isEnabled());
    EXPECT_TRUE(recent[0]->accessibleDescription().contains(QStringLiteral("No longer there")));
    EXPECT_TRUE(recent[1]->isEnabled()) << "this project";
}

TEST_F(StartPageWindow, APictureOfTheViewIsKeptWithTheProject) {
    EXPECT_TRUE(waitFor([&] { return !RecentFiles(settings).pictureOf(file).isNull(); }));
    EXPECT_EQ(RecentFiles(settings).pictureOf(file).size(), RecentFiles::pictureSize);
}

TEST_F(StartPageWindow, EachCardOpensThePanelOfItsQuestion) {
    auto* form = window->findChild<StudyDock*>();
    const auto ask = [&](StartQuestion question) { card(*begin(), question)->click(); };
    ask(StartQuestion::places);
    EXPECT_EQ(form->kind(), StudyKind::places);
    ask(StartQuestion::review);
    EXPECT_TRUE(isShown("reviewDock"));
    window->findChild<QDockWidget*>(QStringLiteral("weightsDock"))->close();
    ask(StartQuestion::score);
    EXPECT_TRUE(isShown("weightsDock"));
    ask(StartQuestion::facades);
    ASSERT_TRUE(workbench().document().elements());
    EXPECT_EQ(workbench().document().elements()->places, ElementPlaces::facades);
    window->findChild<QDockWidget*>(QStringLiteral("towerDock"))->close();
    ask(StartQuestion::tower);
    EXPECT_TRUE(isShown("towerDock"));
}

TEST_F(StartPageWindow, WithoutACityACardWaitsForTheOneThatIsOpened) {
    const QPointer<StartPage> page = begin(false);
    auto* form = window->findChild<StudyDock*>();
    card(*page, StartQuestion::places)->click();
    EXPECT_EQ(page->waiting(), StartQuestion::places);
    EXPECT_NE(form->kind(), StudyKind::places) << "not of the sample behind the page";
    page->findChild<CardButton*>(QStringLiteral("startRecent"))->click();
    EXPECT_TRUE(waitFor([&] { return form->kind() == StudyKind::places; })) << message().toStdString();
    EXPECT_TRUE(isGone(page));
}

TEST_F(StartPageWindow, EscapeClosesItAndEnterPressesACard) {
    const QPointer<StartPage> page = begin(false);
    CardButton* first = card(*page, StartQuestion::places);
    QTest::keyClick(first, Qt::Key_Return);
    EXPECT_TRUE(first->isChecked());
    QTest::keyClick(first, Qt::Key_Return);
    EXPECT_EQ(page->waiting(), std::nullopt);
    page->close();
    EXPECT_TRUE(isGone(page));
}

TEST_F(StartPageWindow, FilesDroppedOnItAreOpened) {
    StartPage* page = begin();
    QStringList dropped;
    page->disconnect();
    QObject::connect(page, &StartPage::chosen, [&](const QStringList& files) { dropped = files; });
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(page, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(page, &drop);
    EXPECT_EQ(dropped, QStringList{file});
}

TEST_F(StartPageWindow, AFolderOpensItsCityFiles) {
    const auto before = workbench().city();
    QDir(folder.path()).mkdir(QStringLiteral("empty"));
    window->opening().openFilesOf(folder.filePath(QStringLiteral("empty")));
    EXPECT_TRUE(message().contains(QStringLiteral("holds no buildings"))) << message().toStdString();
    QDir(folder.path()).mkdir(QStringLiteral("tiles"));
    QFile map(folder.filePath(QStringLiteral("tiles/a.geojson")));
    ASSERT_TRUE(map.open(QIODevice::WriteOnly));
    map.write(R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"height":20},
        "geometry":{"type":"Polygon","coordinates":[[[0,0],[0.001,0],[0.001,0.001],[0,0.001],[0,0]]]}}]})");
    map.close();
    window->opening().openFilesOf(folder.filePath(QStringLiteral("tiles")));
    EXPECT_TRUE(waitFor([&] { return workbench().city() != before; })) << message().toStdString();
    EXPECT_EQ(workbench().city()->city().buildings.size(), 1U);
}

// Labels that wrap need the height for their width; one that is smaller is cut.
int countCut(const QWidget& side) {
    int cut = 0;
    for (const QLabel* label : side.findChildren<QLabel*>()) {
        if (label->isHidden() || label->text().isEmpty()) continue;
        const int needed =
            label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
        cut += needed > label->height() || label->minimumSizeHint().width() > label->width() ? 1 : 0;
    }
    return cut;
}

TEST_F(StartPageWindow, NothingIsCutOnASmallScreenNorInGerman) {
    for (const Language language : {Language::english, Language::german}) {
        applyLanguage(language, *qApp);
        RecentFiles(settings).add(
            {QStringLiteral("/data/a_project_with_a_very_long_name_2026-11-27.noonmark.gpkg")});
        window->resize(1366, 728);
        StartPage* page = begin();
        QCoreApplication::processEvents();
        for (const QWidget* side :
             {static_cast<const QWidget*>(page), static_cast<const QWidget*>(page->questions())}) {
            EXPECT_EQ(countCut(*side), 0)
                << side->objectName().toStdString() << ", language " << int(language);
            EXPECT_LE(side->findChild<QScrollArea*>()->widget()->width(), side->width());
        }
    }
    applyLanguage(Language::english, *qApp);
}

}  // namespace
}  // namespace noonmark
